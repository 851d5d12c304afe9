// SPDX-License-Identifier: Apache-2.0
#include "core/fence/FencedDecoder.h"
#include "core/study/Decoders.h"
#include "tests/support/program/TestProgram.h"

namespace decodeWorker {

namespace {

constexpr const char* decodes = "DecodeWorker";

/// Before main(): compressed frames are decoded in fenced processes, as the program does it, which
/// is started as its own decoder, too. Thus what tests core alone can be built without the program.
/// A test program that cannot be fenced names another one (BURIN_PROGRAM of the build).
const bool isNamed = [] {
    core::WorkerProgram worker{
        .path = QStringLiteral("/proc/self/exe"), .arguments = {QString::fromLatin1(decodes)}};
#ifdef BURIN_DECODER
    worker = {
        .path = QStringLiteral(BURIN_DECODER), .arguments = {QStringLiteral("--decode-worker")}};
#endif
    core::FencedDecoder::instance().setProgram(worker);
    return true;
}();

int decode(int, char**)
{
    return core::runDecodeWorker(core::readyDecoders, core::decodeForAll);
}

} // namespace

BURIN_TEST_RUN(DecodeWorker, decode)

} // namespace decodeWorker
