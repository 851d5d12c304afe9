// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EngineCommands.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/fields/VoxelFields.h"
#include "gpu/kernels/labels/EraseKernel.h"

#include <vector>

namespace gpu {

// What writes the coverage of whole layers (core/sculpt/LayerWrites.h): seldom asked for, so bricks
// are read, worked out on the processor and written, as undo does it. Each returns the keys of the
// bricks that changed. Engine thread only.

/// Cost ∝ the bricks of the segment. @param programs finds them
std::vector<core::BrickKey> coverLabel(ErasePrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::CoverLabel& edit);

/// Cost ∝ the bricks of the layer.
std::vector<core::BrickKey> foldLayer(
    VoxelFields& fields, BeforeImages& before, const core::FoldLayer& edit);

} // namespace gpu
