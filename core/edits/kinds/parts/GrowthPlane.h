// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

namespace core {

/// The label plane that an edit of growth names, from 0; none: the first one, where all growths
/// were before there were others.
[[nodiscard]] inline std::uint8_t growthPlaneOf(const std::optional<int>& plane)
{
    return std::uint8_t(plane.value_or(0));
}

/// How an edit names a plane: not at all if it is the first one, so that its text is the same as
/// that of an edit that knows no planes.
[[nodiscard]] inline std::optional<int> namedPlane(std::uint8_t plane)
{
    return plane == 0 ? std::nullopt : std::optional<int>(plane);
}

} // namespace core
