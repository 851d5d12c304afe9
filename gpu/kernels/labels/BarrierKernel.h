// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/GrowthCommands.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/fields/VoxelFields.h"

#include <vector>

namespace gpu {

/// The compiled kernels that shut listed voxels (barrierListed.comp), each when it is first needed.
class BarrierPrograms {
public:
    /// @param library outlives the programs
    explicit BarrierPrograms(const ShaderLibrary& library)
        : m_library(library)
    {
    }
    /// @param givesBack members may have overwritten something
    [[nodiscard]] Program& barrier(bool givesBack);

private:
    const ShaderLibrary& m_library;
    Program m_plain;
    Program m_giving;
};

/// Carries out BarrierListed. Returns the keys of what changed. Cost ∝ the bricks that are listed.
/// Engine thread only.
std::vector<core::BrickKey> writeBarriers(BarrierPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::BarrierListed& edit);

} // namespace gpu
