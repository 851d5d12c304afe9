// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EditEngine.h"

#include <QString>

#include <cstdint>
#include <map>

namespace test {

/// The result of a random sequence of repairs of a ball: surface, chunks and paint, with undo,
/// redo, jumps in the history, strokes that are rolled back, templates that are aborted, and
/// closing and opening of the file. A position of the history must always have the same state,
/// however it was reached; and the newest branches must give the same states when the oracle
/// carries them out from the beginning.
struct RandomRepair {
    QString failure; ///< what was wrong after the first step that failed; empty: nothing
    std::map<QString, int> done; ///< how often each kind of step was done, by name
};

/// Carries out @p commands random steps. @p engine must not be used by others meanwhile.
[[nodiscard]] RandomRepair runRandomRepair(
    core::EditEngine& engine, int commands, std::uint32_t seed);

} // namespace test
