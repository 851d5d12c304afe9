// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EditEngine.h"

#include <QString>

#include <cstdint>
#include <map>

namespace test {

/// The result of repairing a ball at random: surface, chunks, paint, with undo, redo, jumps,
/// strokes that are given up, templates that are aborted, and closing and opening the file. A place
/// of the history always holds the same, however it was reached; and the newest branches hold the
/// same when the oracle carries them out from the beginning.
struct RandomRepair {
    QString failure; ///< of the first step that went wrong; empty if none did
    std::map<QString, int> done; ///< how often, by name
};

/// @param engine used by nobody else meanwhile
[[nodiscard]] RandomRepair runRandomRepair(
    core::EditEngine& engine, int commands, std::uint32_t seed);

} // namespace test
