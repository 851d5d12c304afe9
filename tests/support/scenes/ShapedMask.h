// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/refine/voxels/BoxMask.h"
#include "core/volume/VolumeGeometry.h"

#include <vector>

namespace test {

/// A mask given by a rule, on a grid in LPS.
struct ShapedMask {
    core::VolumeGeometry geometry;
    std::vector<std::uint8_t> labels; ///< 0 or 1

    explicit ShapedMask(const glm::ivec3& size, const glm::dvec3& spacingMm = glm::dvec3(1.0))
        : labels(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), 0)
    {
        geometry.size = size;
        for (int axis = 0; axis < 3; ++axis)
            geometry.indexToWorld[axis][axis] = spacingMm[axis];
        geometry.indexToWorld[3] = glm::dvec4(-40.0, 25.0, 310.0, 1.0);
    }
    /// Sets the voxels for which @p inside is true.
    /// @param inside takes a position in mm from voxel (0, 0, 0)
    template <typename Inside> void fill(const Inside& inside)
    {
        const glm::dvec3 spacing = geometry.spacingMm();
        std::size_t at = 0;
        for (int z = 0; z < geometry.size.z; ++z) {
            for (int y = 0; y < geometry.size.y; ++y) {
                for (int x = 0; x < geometry.size.x; ++x, ++at)
                    labels[at] = inside(glm::dvec3(x, y, z) * spacing) ? 1 : 0;
            }
        }
    }
    [[nodiscard]] std::uint8_t& at(int x, int y, int z)
    {
        return labels[std::size_t((z * geometry.size.y + y) * geometry.size.x + x)];
    }
    [[nodiscard]] core::BoxMask mask() const { return core::BoxMask::of(labels, 1, geometry.size); }
    [[nodiscard]] core::VoxelRuns voxels() const
    {
        core::VoxelRuns runs;
        for (std::size_t i = 0; i < labels.size(); ++i) {
            if (labels[i] == 1)
                runs.append(i, 1);
        }
        return runs;
    }
    /// The LPS position of a point given in mm from voxel (0, 0, 0).
    [[nodiscard]] glm::dvec3 lps(const glm::dvec3& placeMm) const
    {
        return geometry.originLps() + placeMm;
    }
};

} // namespace test
