// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// How much an edit changed.
struct EditStatistics {
    std::int64_t voxelsChanged = 0; ///< values that differ, of coverage and labels
    std::int64_t verticesChanged = 0; ///< of the surface; engines leave it 0
    int bricks = 0; ///< changed, of coverage and labels
    /// Generations that a growth advanced (including the one that admitted seeds) or was taken
    /// back.
    int generations = 0;
    double milliseconds = 0.0; ///< engine time; never part of a hash
    /// Of a cut that starts from the surface: how far the surface was searched for, in mm16 of its
    /// plane (searchEnd() in core/sculpt/CutFrame.h); none: no ray was cast, or it was not
    /// recorded.
    std::optional<std::int32_t> searchedTo{};
    /// The edit changed voxels of the segment that is refined as a surface. Engines leave it false,
    /// and sessions before 2026-11-25 do not have it.
    bool surfaceMaskChanged = false;
    /// For a ThresholdSegment: the segment consists of exactly what the interval gave it, so it
    /// follows the interval until another edit changes its voxels (Segment::followsRow). Engines
    /// leave this false. Sessions from before 2026-11-27 do not contain it; their segments follow
    /// no interval.
    bool followsInterval = false;
    /// Labels of segments that followed an interval until this edit changed their voxels. Engines
    /// leave it empty.
    std::vector<int> intervalsLeft{};
};

} // namespace core
