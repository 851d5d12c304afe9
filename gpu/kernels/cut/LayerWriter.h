// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/labels/LayerWrites.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/fields/VoxelFields.h"
#include "gpu/kernels/labels/EraseKernel.h"

#include <vector>

namespace gpu {

// Writes the coverage of whole sculpt layers (core/sculpt/labels/LayerWrites.h). This is seldom
// needed, so bricks are read, computed on the processor and written, as undo does it. Both
// functions return the keys of the bricks that changed. Engine thread only.

/// Sets the coverage of a layer to 255 wherever a label is, or is not. Cost ∝ the bricks of the
/// segment, or those of the volume.
/// @param programs finds these bricks
std::vector<core::BrickKey> coverLabel(ErasePrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::CoverLabel& edit);

/// Empties a layer, after merging it into another one if the edit names one. Cost ∝ the bricks of
/// the layer.
std::vector<core::BrickKey> foldLayer(
    VoxelFields& fields, BeforeImages& before, const core::FoldLayer& edit);

} // namespace gpu
