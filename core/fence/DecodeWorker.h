// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/fence/FenceProtocol.h"

#include <QString>

#include <cstdint>
#include <span>

namespace core {

/// A function that processes bytes that may be hostile. It depends only on its arguments: no files,
/// no threads, no lasting state.
/// @param parameters as the caller of FencedDecoder gave them
/// @return what is wrong, in words; empty if @p output was filled
using FencedWork = QString (*)(std::span<const std::uint8_t> parameters,
    std::span<const std::uint8_t> input, std::span<std::uint8_t> output);

/// The main function of a decoder process (README.md beside this file). `burin --decode-worker`
/// calls it before anything else, in a process that WorkerProcess started. It gives up its own
/// rights, then processes requests until there are no more.
///
/// @param prepare called before that; does everything for which @p work needs files
/// @return the process's exit status
int runDecodeWorker(void (*prepare)(), FencedWork work);

namespace fence {

/// Carries out a request, as a decoder process does. What @p work throws is a refusal.
///
/// @pre isSound(request)
/// @param memory has at least as many bytes as the request says
[[nodiscard]] Reply replyTo(
    const Request& request, std::span<std::uint8_t> memory, FencedWork work);

} // namespace fence

} // namespace core
