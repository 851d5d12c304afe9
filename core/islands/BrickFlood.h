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

/// The voxels that hang together with a first one, found brick by brick, so that only bricks are
/// read which they reach. What is found depends neither on the order in which bricks are given nor
/// on how many are given at once. Memory ∝ these bricks.
class BrickFlood {
public:
    struct Rule {
        bool corners = false; ///< voxels also hang together at an edge or a corner
        std::optional<SliceAxis> within{}; ///< only in the first voxel's slice across this axis
    };
    /// @param first a voxel of the volume
    BrickFlood(const glm::ivec3& volumeSize, const glm::ivec3& first, const Rule& rule);

    /// Bricks that were reached and not given yet, ascending; none: everything is found.
    [[nodiscard]] const std::set<std::uint32_t>& wanted() const { return m_wanted; }
    [[nodiscard]] bool wasGiven(std::uint32_t brick) const;
    /// Each brick once, wanted or not. @param voxels those that may belong
    void give(std::uint32_t brick, const BrickBits& voxels);
    /// Goes on as far as the given bricks allow. @return false: cancelled
    bool spread(const Progress& progress);

    /// What hangs together with the first voxel, by brick; empty if that one may not belong.
    [[nodiscard]] std::map<std::uint32_t, BrickBits> found() const;

private:
    struct Brick {
        bool given = false;
        BrickBits possible;
        BrickBits reached; ///< from a neighbour, and not looked at yet
        BrickBits found;
    };
    void reach(const glm::ivec3& voxel);
    void spreadIn(std::uint32_t number);

    BrickGrid m_grid;
    std::vector<glm::ivec3> m_steps; ///< to the neighbours
    std::map<std::uint32_t, Brick> m_bricks;
    std::set<std::uint32_t> m_wanted;
    std::vector<std::uint32_t> m_due; ///< given, with voxels that were reached
};

} // namespace core
