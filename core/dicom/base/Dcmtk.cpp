// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/base/Dcmtk.h"

#include "core/base/Log.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpls/djdecode.h>

#include <cstdlib>
#include <mutex>

namespace core {

namespace {

bool isDictionaryLoaded()
{
    try {
        return dcmDataDict.isDictionaryLoaded();
    } catch (...) {
        // It is loaded under its lock, which DCMTK does not release where memory is refused:
        // whoever asked for it next would wait for ever.
        dcmDataDict.wrunlock();
        throw;
    }
}

} // namespace

void readyDcmtk()
{
    static std::once_flag once;
    std::call_once(once, [] {
        // The environment could replace the dictionary and with it the meaning of every element.
        unsetenv("DCMDICTPATH");
        OFLog::configure(OFLogger::OFF_LOG_LEVEL);
        if (!isDictionaryLoaded())
            qCCritical(log, "DCMTK's data dictionary is missing; implicit VR files cannot be read");
        DJDecoderRegistration::registerCodecs();
        DJLSDecoderRegistration::registerCodecs();
    });
}

} // namespace core
