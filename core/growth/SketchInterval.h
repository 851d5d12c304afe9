// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/SeedStatistics.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace core {

/// Seeds that a user sketched with one stroke.
struct SeedSketch {
    std::vector<glm::ivec3> voxels{}; ///< inside the volume
    /// For a sketch on the 3D view, the direction of view in index space, away from the user; none
    /// for a sketch on a slice.
    std::optional<glm::dvec3> inward{};
};

/// The codes of the sketched structure, and of the tissues beside it.
struct SketchedCodes {
    int centre = 0; ///< median code of the structure
    /// Deviation of its codes, in 256ths of a code; robust, and never below the noise.
    int deviation256 = 0;
    int voxels = 0; ///< number of voxels from which these were computed; 0: there were none
    /// The median code of a darker or brighter tissue beside it; none: there is no such tissue.
    std::optional<int> darker{};
    std::optional<int> brighter{};
    std::vector<int> seeds{}; ///< codes of the sketched voxels, ascending (of at most 64 of them)
};

/// Finds out which interval of codes a sketch means, so that a first growth from it needs no
/// settings. The interval is only offered; a growth uses the one that its edit states.
///
/// 1. The voxels that count: of a sketch on a slice, its own. Those of a sketch on the 3D view lie
///    on an edge; instead of each, the voxels 1 to 3 steps inward count, along the gradient (in the
///    direction that leads away from the user), or along the view where the gradient is across it.
/// 2. If these are fewer than 30, face neighbours within `reach` are added, nearest first, whose
///    codes are at most 2½ deviations from the centre, up to about 100. So a single seed is enough.
/// 3. The centre is the median of the codes. The deviation is the median distance from it, scaled
///    to the standard deviation of a normal distribution. It is at least the noise, which is
///    estimated from second differences along the axes, and at least half a code.
/// 4. Codes within `reach` that are more than two deviations darker (or brighter) than the centre
///    belong to another tissue if they make up at least a tenth of all voxels there. Values in the
///    middle of a structure vary less than those in all of it. Therefore the deviation is raised to
///    a 16th of the distance to the nearer tissue if that is more, but at most to 2½ times its
///    value.
///
/// Pure functions; at most some hundred thousand voxels are read, however long the sketches are.
class SketchInterval {
public:
    SketchInterval(const std::vector<SeedSketch>& sketches, const glm::ivec3& volumeSize);

    /// The voxels whose codes are needed; empty without seeds.
    [[nodiscard]] const std::vector<glm::ivec3>& voxels() const { return m_voxels; }
    /// @param codes of voxels(), in their order
    [[nodiscard]] SketchedCodes look(const std::vector<int>& codes) const;

private:
    class Neighbourhood;

    std::vector<SeedSketch> m_sketches; ///< thinned out to at most 64 seeds
    glm::ivec3 m_volumeSize{0};
    int m_reach = 0;
    std::vector<glm::ivec3> m_voxels; ///< ascending by z, y, x
};

/// The interval that is offered: the codes within a number of deviations of the centre. On the side
/// of another tissue it ends at the latest at three quarters of the distance to that tissue. If
/// fewer than a quarter of the seeds lie in it, it is extended to the nearest quarter of them,
/// because growth could not begin otherwise.
/// @param sigmas256 number of deviations, in 256ths
[[nodiscard]] CodeInterval offeredInterval(const SketchedCodes& sketched, int sigmas256);

/// How many of the sketched seeds have codes in an interval.
[[nodiscard]] int seedsWithin(const SketchedCodes& sketched, const CodeInterval& interval);

} // namespace core
