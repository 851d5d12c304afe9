// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/VoxelReads.h"
#include "core/sculpt/IntegerHalfSpace.h"
#include "tests/reference/fields/DenseFields.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace reference {

/// A position in index16: voxels, 16.16 fixed point.
using Index16 = std::array<std::int64_t, 3>;

/// What a ray meets (core/sculpt/DrillCut.h, rule 3). Both fields are borrowed.
struct Tissue {
    const DenseArray<std::uint16_t>& codes;
    const DenseArray<std::uint8_t>& radiation;

    [[nodiscard]] bool inside(const Index16& position) const;
    /// Z of rule 3: the interpolated code · 2¹⁶. Only inside.
    [[nodiscard]] std::uint64_t density(const Index16& position) const;
    /// Only inside.
    [[nodiscard]] bool carved(const Index16& position) const;
    [[nodiscard]] bool dense(const Index16& position, int thresholdCode) const;
    [[nodiscard]] bool material(const Index16& position, int thresholdCode) const;

    bool byVoxels = false; ///< as restoring sees
    bool asWhole = false; ///< nothing counts as carved
};

/// core/sculpt/IntegerHalfSpace.h.
[[nodiscard]] bool hidesVoxel(
    const std::vector<core::IntegerHalfSpace>& hidden, const glm::ivec3& voxel);
[[nodiscard]] bool hidesPosition(
    const std::vector<core::IntegerHalfSpace>& hidden, const Index16& position);

/// The voxel that one ray of a pick finds; by what is seen of the volume.
[[nodiscard]] std::optional<glm::ivec3> pick(
    const Tissue& tissue, const core::PickVoxels& pick, const core::PickRay& ray);
/// By the segments of all label planes.
[[nodiscard]] std::optional<glm::ivec3> pickSegment(
    const std::vector<const DenseArray<std::uint8_t>*>& planes, const core::PickVoxels& pick,
    const core::PickRay& ray);

} // namespace reference
