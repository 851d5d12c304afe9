// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace core {

/// The parameters of a cut that can be revised, with their present values; absent: the cut does not
/// have it.
struct StrokeParameters {
    int layer = 1;
    std::optional<double> radiusMm{};
    std::optional<double> sideMm{};
    std::optional<double> widthMm{};
    std::optional<double> heightMm{};
    std::optional<double> factor{}; ///< of its outline; 1 for the present size
    std::optional<double> depthMm{};
    std::optional<double> softnessMm{};
    std::optional<bool> throughGaps{};
    bool operator==(const StrokeParameters&) const = default;
};
} // namespace core
