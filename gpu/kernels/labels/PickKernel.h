// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/VoxelReads.h"
#include "core/growth/ProbedVoxel.h"
#include "gpu/fields/VoxelFields.h"

#include <optional>
#include <vector>

namespace gpu {

/// Questions about voxels: what a ray sees, what a voxel holds (pick.comp, probe.comp). Each waits
/// for its answer. Engine thread only.
class PickKernel {
public:
    /// @param library outlives the kernel
    explicit PickKernel(const ShaderLibrary& library);

    [[nodiscard]] std::vector<std::optional<glm::ivec3>> pick(
        VoxelFields& fields, const core::PickVoxels& command);
    [[nodiscard]] std::vector<core::ProbedVoxel> probe(
        VoxelFields& fields, const core::ProbeVoxels& command);

private:
    /// A pick of segments looks into all label planes; while there is one, it has no program of its
    /// own.
    [[nodiscard]] Program& programFor(const core::PickVoxels& command, const VoxelFields& fields);

    const ShaderLibrary& m_library;
    Program m_pick;
    Program m_pickInPlanes; ///< compiled when it is first needed
    Program m_probe;
};

} // namespace gpu
