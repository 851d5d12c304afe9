// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace core {

/// Where a growth stops by itself (LeakGuard.h).
struct GrowGuard {
    /// Where a front that came out of a narrow place is so many times as wide; none: nowhere.
    std::optional<double> factor{};
    double areaMm2 = 60.0; ///< and so much wider
    double backMm = 20.0; ///< how far a narrow place lies back at most
    // Recipes and sessions of before counted voxels and generations: where one of these is given,
    // that is done still, and areaMm2 and backMm are not looked at.
    std::optional<int> voxels{}; ///< instead of areaMm2; none: 60
    std::optional<int> generations{}; ///< instead of backMm; none: 20
    [[nodiscard]] bool countsVoxels() const { return voxels || generations; }
    bool operator==(const GrowGuard&) const = default;
};

} // namespace core
