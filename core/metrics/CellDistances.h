// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/morphology/MillimetreBall.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace core {

struct VolumeGeometry;

/// How far the cells of voxels are apart. Along each axis of the grid that is one step less than
/// between the voxels' centres, and never less than 0; on a sheared grid it is measured between the
/// facing corners of the cells. Where slices are unevenly spaced, corners are where they truly lie
/// (worldBetweenSlices()). Squared distances are whole numbers of a unit of the grid's own, so that
/// equal ones are equal: that of MillimetreBall.h or, for unevenly spaced slices, one in which the
/// distance across the whole volume is exact to a hundred-millionth.
class CellDistances {
public:
    explicit CellDistances(const VolumeGeometry& geometry);

    [[nodiscard]] std::int64_t squared(const glm::ivec3& from, const glm::ivec3& to) const
    {
        const glm::ivec3 step = between(from, to);
        return m_borders.empty() ? m_form.squared(step.x, step.y, step.z)
                                 : squaredBetweenBorders(from, to);
    }
    /// A lower bound of the squared distance between a voxel of one box and a voxel of another. On
    /// an upright grid of evenly spaced slices it is that of the nearest two; on others it may
    /// be a little less.
    /// @pre neither box is empty
    [[nodiscard]] std::int64_t leastSquared(const VoxelBox& from, const VoxelBox& to) const;

private:
    static glm::ivec3 between(const glm::ivec3& from, const glm::ivec3& to)
    {
        const glm::ivec3 step = to - from;
        return step - glm::sign(step);
    }

    void placeBorders(const VolumeGeometry& geometry);
    [[nodiscard]] std::int64_t squaredBetweenBorders(
        const glm::ivec3& from, const glm::ivec3& to) const;

    MillimetreBall m_form;
    /// The step from a voxel to the next along each axis of the grid, in a frame of right angles.
    /// Where slices are unevenly spaced there is none from slice to slice: that column is 0.
    glm::dmat3 m_steps{0.0};
    // Only where slices are unevenly spaced, in fractions of the unit: the places of the borders
    // between slices in that frame, from below the first slice to above the last one, and the steps
    // along both other axes.
    std::vector<glm::i64vec3> m_borders{};
    glm::i64vec3 m_columnStep{0};
    glm::i64vec3 m_rowStep{0};
};

} // namespace core
