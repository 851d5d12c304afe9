// SPDX-License-Identifier: Apache-2.0
#include "core/fence/FencedDecoder.h"

namespace {

/// Before main(): every test decodes as the program does.
const bool named = [] {
    core::FencedDecoder::instance().setProgram(
        {.path = QStringLiteral(BURIN_PROGRAM), .arguments = {QStringLiteral("--decode-worker")}});
    return true;
}();

} // namespace
