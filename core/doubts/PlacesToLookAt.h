// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/doubts/DoubtfulPlace.h"
#include "core/doubts/FaintBorder.h"

namespace core {

/// Finds where to look first in a segment that may have errors, for instance one that a network
/// made: where its border follows no edge of the image, and where it disagrees with a second mask.
/// It changes nothing, and finds the same on every machine.
///
/// The result takes places of both kinds in turn, beginning with a disagreement: disagreements by
/// size (onlyIn()), places without an edge by doubt (FaintBorder). A place without an edge that
/// lies mostly beside a listed disagreement is left out, since a user sees it there anyway. Empty
/// if the segment has no voxels.
/// Cost: that of FaintBorder and of two calls of onlyIn(). Any thread. Errors: Cancelled.
/// @param second the second mask; null: there is none
/// @param most the greatest number of places
[[nodiscard]] Result<std::vector<DoubtfulPlace>> placesToLookAt(const BorderSource& source,
    const VoxelRuns* second, std::size_t most, const Progress& progress);

} // namespace core
