// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EngineCommands.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/fields/VoxelFields.h"

#include <vector>

namespace gpu {

/// The compiled kernels that give a label to chosen voxels, or take it (chooseLabel.comp).
struct LabelPrograms {
    explicit LabelPrograms(const ShaderLibrary& library);

    Program carved;
    Program seen;
    Program listed;
    Program relabelled;
};

/// Carries out LabelCarved, LabelSeen, LabelListed or RelabelListed (core/sculpt/LayerWrites.h).
/// Bricks in which something changes are looked for first; only those are captured and written.
/// Returns the keys of what changed. Cost ∝ the bricks that the layer holds, the volume, or the
/// bricks that are listed. Engine thread only.
std::vector<core::BrickKey> labelCarved(LabelPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::LabelCarved& edit);
std::vector<core::BrickKey> labelSeen(LabelPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::LabelSeen& edit);
std::vector<core::BrickKey> labelListed(LabelPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::LabelListed& edit);
std::vector<core::BrickKey> relabelListed(LabelPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::RelabelListed& edit);

} // namespace gpu
