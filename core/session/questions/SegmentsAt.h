// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/growth/ProbedVoxel.h"

#include <vector>

namespace core {

// Which segments have a voxel, by what VoxelQuestions::probe() says of it. There is one at most in
// each label plane.

/// All of them, those of lower planes first.
[[nodiscard]] std::vector<const Segment*> segmentsAt(
    const Document& document, const ProbedVoxel& voxel);

/// The one that is meant by pointing at the voxel: the active segment if it has it; else that of
/// the highest plane that is shown; else that of the highest plane. Null: none has it.
/// @param active a label; 0: none
[[nodiscard]] const Segment* segmentMeant(
    const Document& document, const ProbedVoxel& voxel, int active);

/// The one to go on to from there: as segmentMeant(), but if the active segment has the voxel and
/// others that are shown have it, too, the next lower one of these, and after the lowest the
/// highest.
[[nodiscard]] const Segment* segmentNext(
    const Document& document, const ProbedVoxel& voxel, int active);

} // namespace core
