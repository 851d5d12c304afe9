// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/growth/GrowBox.h"

#include <optional>

namespace core {

/// Which voxels a growth may enter: all that is given here must hold. Values in modality units.
struct GrowCriteria {
    double lower = 0.0; ///< inclusive
    double upper = 0.0;
    int connectivity = 6; ///< 6, 18 or 26
    /// Narrows the interval, for each segment by itself, to mean ± so many standard deviations
    /// around its seeds.
    std::optional<double> sigmas{};
    /// That is done for each stroke of seeds by itself, and a voxel qualifies where it does for one
    /// of the segment's. Read are the SeedStrokes that stand before this edit.
    std::optional<bool> perStroke{};
    std::optional<double> difference{}; ///< at most so much from the voxel it is reached from
    std::optional<double> gradient{}; ///< magnitude at most, per millimetre
    std::optional<double> gradientDifference{}; ///< of magnitudes, from the voxel before
    std::optional<int> majority{}; ///< so many of the 27 voxels around and at it in the interval
    /// mm: growth goes only where a ball of this diameter can roll to from a seed (Passage.h). One
    /// that holds no voxel but its centre asks nothing.
    std::optional<double> passage{};
    bool onlyVisible = false; ///< not what is carved
    std::optional<GrowBox> box{};
    bool overwriteUnlocked = false;
    bool operator==(const GrowCriteria&) const = default;
};

} // namespace core
