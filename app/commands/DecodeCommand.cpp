// SPDX-License-Identifier: Apache-2.0
#include "app/commands/DecodeCommand.h"

#include "core/fence/FencedDecoder.h"
#include "core/study/Decoders.h"

#include <cstring>

namespace app {

namespace {

constexpr const char* decoderOption = "--decode-worker";

} // namespace

bool isDecoder(int argc, char** argv)
{
    return argc == 2 && std::strcmp(argv[1], decoderOption) == 0;
}

int runDecoder()
{
    return core::runDecodeWorker(core::readyDecoders, core::decodeForAll);
}

void nameDecoders()
{
    // The file that runs, also where it was replaced by a newer one since.
    core::FencedDecoder::instance().setProgram({.path = QStringLiteral("/proc/self/exe"),
        .arguments = {QString::fromLatin1(decoderOption)}});
}

} // namespace app
