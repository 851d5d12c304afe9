// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/morphology/MillimetreBall.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace core {

struct VolumeGeometry;

/// How far the cells of voxels are apart. Along each axis of the grid that is one step less than
/// between the voxels' centres, and never less than 0; on a sheared grid it is measured between the
/// facing corners of the cells. Squared distances are whole numbers of a unit of the grid's own
/// (MillimetreBall.h), so that equal ones are equal.
class CellDistances {
public:
    explicit CellDistances(const VolumeGeometry& geometry);

    [[nodiscard]] std::int64_t squared(const glm::ivec3& from, const glm::ivec3& to) const
    {
        const glm::ivec3 step = between(from, to);
        return m_form.squared(step.x, step.y, step.z);
    }
    /// What the squared distance of any voxel of a box from any voxel of another one is at least.
    /// On an upright grid it is that of the nearest two; on others it may be a little less.
    /// @pre neither box is empty
    [[nodiscard]] std::int64_t leastSquared(const VoxelBox& from, const VoxelBox& to) const;

private:
    static glm::ivec3 between(const glm::ivec3& from, const glm::ivec3& to)
    {
        const glm::ivec3 step = to - from;
        return step - glm::sign(step);
    }

    MillimetreBall m_form;
    glm::dmat3 m_steps{0.0}; ///< of the grid along its axes, in a frame of right angles
};

} // namespace core
