// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/GrowthCommands.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/fields/VoxelFields.h"

#include <vector>

namespace gpu {

/// The compiled kernels that shut listed voxels (shutListed.comp), each when it is first needed.
class ShutPrograms {
public:
    /// @param library outlives the programs
    explicit ShutPrograms(const ShaderLibrary& library)
        : m_library(library)
    {
    }
    /// @param givesBack something may lie beneath members
    [[nodiscard]] Program& shut(bool givesBack);

private:
    const ShaderLibrary& m_library;
    Program m_plain;
    Program m_giving;
};

/// Carries out ShutListed. Returns the keys of what changed. Cost ∝ the bricks that are listed.
/// Engine thread only.
std::vector<core::BrickKey> shutListed(ShutPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::ShutListed& edit);

} // namespace gpu
