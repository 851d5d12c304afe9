// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/recipe/RecipeStep.h"
#include "core/volume/Volume.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QByteArray>

#include <set>
#include <vector>

namespace test {

/// What a user might do with the small study in one sitting, drawn by lot: drills (some of them
/// long), seeds, growths, names, undo, redo, walks to any row, "undo only here". With it the truth
/// by the oracle: what the history is and the voxels are after every step.
struct SessionScript {
    struct Step {
        core::RecipeStep step;
        core::RowId rows = 0; ///< that the history has after it
        core::RowId position = 0; ///< after it
    };
    std::vector<Step> steps;
    std::vector<QByteArray> hashes; ///< state hash by row; [0]: of the beginning
    std::vector<core::RowId> parents; ///< by row
    std::vector<core::RowId> line; ///< History::line() at the end

    /// Rows and position after so many steps.
    [[nodiscard]] core::RowId rowsAfter(std::size_t done) const;
    [[nodiscard]] core::RowId positionAfter(std::size_t done) const;
    /// Where a session can stand that did @p done steps and was stopped at some point of the next.
    [[nodiscard]] std::set<core::RowId> positionsFrom(std::size_t done) const;
    /// As `burin run` takes it.
    [[nodiscard]] QByteArray recipe() const;
};

/// @param volume smallStudy(), or the same loaded from a file
[[nodiscard]] SessionScript randomScript(
    const core::LoadedVolume& volume, Random& random, int steps);

} // namespace test
