// SPDX-License-Identifier: Apache-2.0
// libFuzzer's door to the function that BURIN_FUZZ_TARGET names.
#include "core/fence/FencedDecoder.h"
#include "core/study/Decoders.h"
#include "tests/fuzz/FuzzTargets.h"

#include <QCoreApplication>
#include <QLoggingCategory>

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv)
{
    // Qt's database drivers are found through it; it lives until the end.
    static QCoreApplication application(*argc, *argv);
    QLoggingCategory::setFilterRules(QStringLiteral("*=false"));
    // In the process itself, where a sanitizer sees it. What it does to DCMTK's and OpenJPEG's
    // code, which are not instrumented, is no finding in ours unless it ends the program.
    core::FencedDecoder::instance().decodeInside(core::decodeForAll);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    test::BURIN_FUZZ_TARGET({bytes, size});
    return 0;
}
