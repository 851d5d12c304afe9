// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

/// Fixed-point arithmetic. What decides about a voxel is computed with it, so that the result is
/// the same on every machine.
namespace core::fixedPoint {

/// Divides by 2¹⁴, rounding halves up: from units of 2⁻³⁰ to units of 2⁻¹⁶.
[[nodiscard]] constexpr std::int64_t round14(std::int64_t value)
{
    return (value + (std::int64_t(1) << 13)) >> 14;
}
/// Divides by 2³⁰, rounding halves up: from units of 2⁻³⁰ to whole numbers.
[[nodiscard]] constexpr std::int64_t round30(std::int64_t value)
{
    return (value + (std::int64_t(1) << 29)) >> 30;
}
/// Rounded down. @pre @p divisor is greater than 0
[[nodiscard]] constexpr std::int64_t floorDivide(std::int64_t value, std::int64_t divisor)
{
    return value / divisor - (value % divisor < 0 ? 1 : 0);
}
/// ⌊√value⌋. @pre 0 ≤ @p value ≤ 2⁶²
[[nodiscard]] std::int64_t squareRoot(std::int64_t value);

} // namespace core::fixedPoint
