// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace core {

/// What of a cut can be revised, as it is; absent: it has no such thing.
struct StrokeParameters {
    int layer = 1;
    std::optional<double> radiusMm{};
    std::optional<double> sideMm{};
    std::optional<double> widthMm{};
    std::optional<double> heightMm{};
    std::optional<double> factor{}; ///< of its outline as it is: 1
    std::optional<double> depthMm{};
    std::optional<double> softnessMm{};
    std::optional<bool> throughGaps{};
    bool operator==(const StrokeParameters&) const = default;
};
} // namespace core
