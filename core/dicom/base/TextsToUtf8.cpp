// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/base/TextsToUtf8.h"

#include "core/dicom/base/DicomText.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace core {

namespace {

/// @param inherited the character set of the item around it
void convertItem(DcmItem& item, const QByteArray& inherited)
{
    QByteArray characterSet = inherited;
    OFString declared;
    if (item.findAndGetOFStringArray(DCM_SpecificCharacterSet, declared).good())
        characterSet = QByteArray(declared.data(), qsizetype(declared.size()));
    for (DcmObject* object = item.nextInContainer(nullptr); object != nullptr;
         object = item.nextInContainer(object)) {
        if (auto* sequence = dynamic_cast<DcmSequenceOfItems*>(object)) {
            for (DcmObject* inner = sequence->nextInContainer(nullptr); inner != nullptr;
                 inner = sequence->nextInContainer(inner)) {
                auto* nested = dynamic_cast<DcmItem*>(inner);
                if (nested == nullptr)
                    continue;
                convertItem(*nested, characterSet);
                delete nested->remove(DCM_SpecificCharacterSet);
            }
            continue;
        }
        auto* element = dynamic_cast<DcmCharString*>(object);
        if (element == nullptr)
            continue;
        OFString value;
        if (element->getOFStringArray(value).bad())
            continue;
        const QByteArray bytes(value.data(), qsizetype(value.size()));
        if (!isPlainText(bytes))
            element->putString(dicomText(bytes, characterSet).toUtf8().constData());
    }
}

} // namespace

void textsToUtf8(DcmItem& set)
{
    convertItem(set, {});
    set.putAndInsertString(DCM_SpecificCharacterSet, "ISO_IR 192");
}

} // namespace core
