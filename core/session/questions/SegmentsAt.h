// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/growth/ProbedVoxel.h"

#include <vector>

namespace core {

// Which segments contain a voxel, according to VoxelQuestions::probe(). In each label plane there
// is one at most.

/// All segments that contain the voxel, in ascending order of their planes.
[[nodiscard]] std::vector<const Segment*> segmentsAt(
    const Document& document, const ProbedVoxel& voxel);

/// The segment that a user means by pointing at a voxel: the active one if it contains the voxel;
/// otherwise, of those that are shown, the one in the highest plane; if none is shown, the one in
/// the highest plane. Null: no segment contains it.
/// @param active label of the active segment; 0: none
[[nodiscard]] const Segment* segmentMeant(
    const Document& document, const ProbedVoxel& voxel, int active);

/// The segment to be made active next if the user asks again at the same voxel: as segmentMeant(),
/// but if the active segment contains the voxel, the next lower one of those that are shown there
/// (of all, if none is shown), and after the lowest the highest.
[[nodiscard]] const Segment* segmentNext(
    const Document& document, const ProbedVoxel& voxel, int active);

} // namespace core
