// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/VoxelReads.h"
#include "core/growth/ProbedVoxel.h"
#include "gpu/fields/VoxelFields.h"

#include <array>
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
    /// The program for a kind of pick, compiled when it is first needed. There is one for each
    /// kind, because a software driver executes everything in a program, needed or not. A pick of
    /// segments reads all label planes.
    [[nodiscard]] Program& programFor(const core::PickVoxels& command, const VoxelFields& fields);

    const ShaderLibrary& m_library;
    std::array<Program, 4> m_pick; ///< by SeenBy
    Program m_pickInPlanes;
    Program m_probe;
};

} // namespace gpu
