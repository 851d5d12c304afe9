// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace core {

/// When a growth stops by itself because it probably leaks (LeakGuard.h).
struct GrowGuard {
    /// It stops when a front behind a narrow place is this many times as large as that place; none:
    /// it never stops.
    std::optional<double> factor{};
    double areaMm2 = 60.0; ///< and at least this much larger
    double backMm = 20.0; ///< how far back the narrow place may lie
    // Older recipes and sessions counted voxels and generations. If one of these is given, they are
    // counted, and areaMm2 and backMm are not used.
    std::optional<int> voxels{}; ///< instead of areaMm2; none: 60
    std::optional<int> generations{}; ///< instead of backMm; none: 20
    [[nodiscard]] bool countsVoxels() const { return voxels || generations; }
    bool operator==(const GrowGuard&) const = default;
};

} // namespace core
