// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <cstdint>
#include <span>

namespace core {

/// Work on bytes that may be hostile. Needs nothing but its arguments: no file, no thread, no
/// state that lasts.
/// @param parameters as FencedDecoder's caller gave them @return what is wrong, in words; empty if
/// @p output is filled
using FencedWork = QString (*)(std::span<const std::uint8_t> parameters,
    std::span<const std::uint8_t> input, std::span<std::uint8_t> output);

/// The whole life of a decoder (README.md beside this file): called by `burin --decode-worker`
/// before anything else, in a process that WorkerProcess started. Takes away its own rights, then
/// does what it is asked until nobody asks any more.
///
/// @param prepare called before: whatever @p work needs files for
/// @return the process's exit status
int runDecodeWorker(void (*prepare)(), FencedWork work);

} // namespace core
