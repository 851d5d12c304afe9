// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <cstdint>

/// Numbers as users read them, the same everywhere: the decimal sign of the system, a true minus
/// sign, no "−0.0", and no groups but those of countText().
namespace ui {

/// The true minus sign, "−"; "-" is a hyphen.
inline constexpr QChar minusSign(0x2212);

/// "−31.5": @p value with a fixed number of decimals.
[[nodiscard]] QString numberText(double value, int decimals);

/// How many decimals suit values that are seen in a range of this width: enough to distinguish a
/// hundredth of it, or a thousandth for narrow ranges.
[[nodiscard]] int decimalsForSpan(double span);

/// "−31.5", "1024", "0.00012": @p value with at most @p digits significant digits.
[[nodiscard]] QString digitsText(double value, int digits);

/// A count with its digits in groups of three, as in the names of the history: 18204 → "18 204".
[[nodiscard]] QString countText(qlonglong count);

/// A volume as in lists and beside the pointer: "0.35 mL", "12.4 mL".
[[nodiscard]] QString volumeText(double millilitres);

/// "9.84 mL": two digits below 10, one below 1000, none above; "—" for nothing.
[[nodiscard]] QString millilitreText(std::int64_t voxels, double voxelVolumeMm3);

} // namespace ui
