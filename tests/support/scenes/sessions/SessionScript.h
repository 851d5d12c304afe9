// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/recipe/RecipeStep.h"
#include "core/volume/Volume.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QByteArray>

#include <set>
#include <vector>

namespace test {

/// A random session with the small study: drills (some of them long), seeds, growths, renaming,
/// undo, redo, going to any row, "undo only here". It also holds the expected result by the oracle:
/// history and voxels after every step.
struct SessionScript {
    struct Step {
        core::RecipeStep step;
        core::RowId rows = 0; ///< number of history rows after it
        core::RowId position = 0; ///< position after it
    };
    std::vector<Step> steps;
    std::vector<QByteArray> hashes; ///< state hash by row; [0] of the initial state
    std::vector<core::RowId> parents; ///< by row
    std::vector<core::RowId> line; ///< History::line() at the end

    /// The number of rows, and the position, after some steps.
    [[nodiscard]] core::RowId rowsAfter(std::size_t done) const;
    [[nodiscard]] core::RowId positionAfter(std::size_t done) const;
    /// The possible positions of a session that did @p done steps and was stopped at any moment of
    /// the next.
    [[nodiscard]] std::set<core::RowId> positionsFrom(std::size_t done) const;
    /// The script as a recipe for `burin run`.
    [[nodiscard]] QByteArray recipe() const;
};

/// @param volume smallStudy(), or the same loaded from a file
[[nodiscard]] SessionScript randomScript(
    const core::LoadedVolume& volume, Random& random, int steps);

} // namespace test
