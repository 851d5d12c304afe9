// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/brick/BrickBits.h"
#include "core/brick/BrickGrid.h"
#include "core/brick/SliceAxis.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace core {

/// Finds the region of voxels that is connected with a first voxel, brick by brick, so that only
/// bricks that it reaches need to be read. The result does not depend on the order in which bricks
/// are given. Memory ∝ these bricks.
class BrickFlood {
public:
    struct Rule {
        bool corners = false; ///< voxels are also neighbours if they share only an edge or a corner
        std::optional<SliceAxis> within{}; ///< only in the first voxel's slice across this axis
        /// For voxels of a slice that lies oblique to the grid: the index axis along which it is
        /// one voxel thick. How far a step leads along it, by one at most, does not count, as for a
        /// flat brush that follows edges (core/sculpt/EdgeRegion.h, rule 3).
        std::optional<int> across{};
    };
    /// @param first index of the first voxel, in the volume
    BrickFlood(const glm::ivec3& volumeSize, const glm::ivec3& first, const Rule& rule);

    /// Numbers of the bricks that the region has reached and that were not given yet, ascending.
    /// Empty: the region is complete (after spread()).
    [[nodiscard]] const std::set<std::uint32_t>& wanted() const { return m_wanted; }
    [[nodiscard]] bool wasGiven(std::uint32_t brick) const;
    /// Provides a brick. Each brick is given once at most, whether it is wanted or not.
    /// @param voxels those voxels of the brick that may belong to the region
    void give(std::uint32_t brick, const BrickBits& voxels);
    /// Extends the region as far as the given bricks allow.
    /// @return false: cancelled
    bool spread(const Progress& progress);

    /// The voxels of the region, by brick; empty if the first voxel itself may not belong to it.
    [[nodiscard]] std::map<std::uint32_t, BrickBits> found() const;

private:
    struct Brick {
        bool given = false;
        BrickBits possible;
        BrickBits reached; ///< reached from a neighbour, not examined yet
        BrickBits found;
    };
    void reach(const glm::ivec3& voxel);
    void spreadIn(std::uint32_t number);

    BrickGrid m_grid;
    std::vector<glm::ivec3> m_steps; ///< steps from a voxel to its neighbours
    std::map<std::uint32_t, Brick> m_bricks;
    std::set<std::uint32_t> m_wanted;
    /// Given bricks with voxels that were reached and not examined yet.
    std::vector<std::uint32_t> m_due;
};

} // namespace core
