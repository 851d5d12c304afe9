// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/SeedStatistics.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace core {

/// Seeds as they were sketched.
struct SeedSketch {
    std::vector<glm::ivec3> voxels{}; ///< inside the volume
    /// The direction of view, in voxels, of a sketch on the 3D view; none: of one on a slice.
    std::optional<glm::dvec3> inward{};
};

/// The codes of what was sketched, and of what lies beside it.
struct SketchedCodes {
    int centre = 0; ///< the median
    int deviation256 = 0; ///< 256ths of a code; robust, and never below the noise
    int voxels = 0; ///< number that were looked at
    /// the median of what lies beside it and is darker, or brighter; none: there is nothing
    std::optional<int> darker{};
    std::optional<int> brighter{};
    std::vector<int> seeds{}; ///< codes of the sketched voxels, ascending
};

/// Finds out which codes a sketch means, so that the first growth from it needs no setting. An
/// interval is only offered; growth takes the one that its edit names.
///
/// 1. Of a sketch on a slice its own voxels count. Those of a sketch on the 3D view are edge
///    values; in their place count the voxels 1 to 3 inward, against the gradient's direction that
///    the user looks from, or along the view where there is no gradient.
/// 2. Fewer than 30 voxels are widened along the structure, nearest first: to face neighbours
///    within `reach` whose codes are at most 2½ deviations from the centre. So one seed is enough.
/// 3. The centre is the median, the deviation the median distance from it, scaled to that of a
///    normal distribution, and at least the noise: what second differences along the axes say of
///    it, and half a code.
/// 4. What lies within `reach` and is farther than two deviations from the centre is another
///    tissue, if it is a tenth of all voxels there or more. In the middle of a structure values
///    differ less than in the rest: the deviation becomes a 16th of the distance to the nearer
///    tissue if that is more, but at most 2½ times as large.
///
/// Pure functions; at most some hundred thousand voxels are read, for sketches of any length.
class SketchInterval {
public:
    SketchInterval(const std::vector<SeedSketch>& sketches, const glm::ivec3& volumeSize);

    /// The voxels whose codes are needed; empty without seeds.
    [[nodiscard]] const std::vector<glm::ivec3>& voxels() const { return m_voxels; }
    /// @param codes of voxels(), in their order
    [[nodiscard]] SketchedCodes look(const std::vector<int>& codes) const;

private:
    class Neighbourhood;

    std::vector<SeedSketch> m_sketches; ///< thinned out
    glm::ivec3 m_volumeSize{0};
    int m_reach = 0;
    std::vector<glm::ivec3> m_voxels; ///< ascending by z, y, x
};

/// The codes within so many deviations of the centre, but of what lies between it and another
/// tissue only the three quarters next to the centre. If fewer than a quarter of the seeds are in
/// it, it is extended to the nearest quarter, for growth could not begin.
/// @param sigmas256 256ths of a deviation
[[nodiscard]] CodeInterval offeredInterval(const SketchedCodes& sketched, int sigmas256);

/// How much of the seeds an interval holds.
[[nodiscard]] int seedsWithin(const SketchedCodes& sketched, const CodeInterval& interval);

} // namespace core
