// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/EditableRange.h"

#include <optional>
#include <vector>

namespace core {

/// Conditions on the voxels that a growth may enter; all that are given must hold. Values are in
/// modality units.
struct GrowCriteria {
    double lower = 0.0; ///< inclusive
    double upper = 0.0;
    int connectivity = 6; ///< 6, 18 or 26
    /// Narrows the interval, separately for each segment, to mean ± this many standard deviations
    /// around its seeds.
    std::optional<double> sigmas{};
    /// Does so separately for each stroke of seeds; a voxel qualifies if it does for one stroke of
    /// the segment. The strokes are the SeedStrokes in effect before this edit.
    std::optional<bool> perStroke{};
    std::optional<double> difference{}; ///< greatest difference from the parent voxel
    std::optional<double> gradient{}; ///< greatest magnitude, per millimetre
    /// greatest difference of magnitudes from the parent voxel
    std::optional<double> gradientDifference{};
    /// at least this many of the 27 voxels around it (with itself) are in the interval
    std::optional<int> majority{};
    /// The weighted median of these 27 (GrowLimits) is compared with the interval, instead of the
    /// voxel's own value: holes and specks of noise vanish, borders and walls stay where they are.
    /// All other criteria use the voxels' own values.
    std::optional<bool> smoothing{};
    /// mm: growth only goes where a ball of this diameter can roll to from a seed (Passage.h). A
    /// ball that contains no voxel but its centre has no effect.
    std::optional<double> passage{};
    bool onlyVisible = false; ///< excludes what is carved
    std::optional<GrowBox> box{};
    bool overwriteUnlocked = false;
    /// Only these segments grow; the others stay as they are, as if they were locked, but unlocked
    /// ones may be overwritten. None: all that are not locked.
    std::optional<std::vector<int>> segments{};
    /// Which voxels may change at all. The segments that it lists must lie in the plane that grows.
    std::optional<EditableRange> editable{};
    /// The label plane that grows (GrowthPlane.h); named segments must lie there.
    std::optional<int> plane{};
    bool operator==(const GrowCriteria&) const = default;
};

} // namespace core
