// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/GrowthCommands.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/fields/VoxelFields.h"

#include <vector>

namespace gpu {

/// The kernels that make listed voxels barriers of growth, or remove barriers (barrierListed.comp).
/// Each is compiled when it is first needed.
class BarrierPrograms {
public:
    /// @param library outlives the programs
    explicit BarrierPrograms(const ShaderLibrary& library)
        : m_library(library)
    {
    }
    /// @param givesBack the variant for a plane in which members of a growth have overwritten other
    /// labels: a barrier on such a member restores the overwritten label
    [[nodiscard]] Program& barrier(bool givesBack);

private:
    const ShaderLibrary& m_library;
    Program m_plain;
    Program m_giving;
};

/// Carries out BarrierListed and returns the keys of what has changed. Cost: proportional to the
/// listed bricks. Engine thread only.
std::vector<core::BrickKey> writeBarriers(BarrierPrograms& programs, VoxelFields& fields,
    BeforeImages& before, const core::BarrierListed& edit);

} // namespace gpu
