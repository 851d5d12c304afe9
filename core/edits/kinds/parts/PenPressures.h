// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <optional>
#include <vector>

namespace core {

/// How firmly the pen was pressed at each point of a path, 0 … 1. The radius of the tool, or
/// another quantity that the edit names, is multiplied by it; between points it changes linearly.
/// None: full pressure everywhere, as for a mouse and for rows that are older than this field.
using PenPressures = std::optional<std::vector<double>>;

/// Checks that there is one pressure for each point, if there are any.
/// @param name name of the edit, for the error
[[nodiscard]] Result<void> checkPressures(
    const PenPressures& pressures, std::size_t points, const QString& name);

/// Appends the pressures of further points of a path, and returns those that were appended. If the
/// path has no pressures, nothing is appended. A missing pressure counts as 1; values are clamped
/// to 0 … 1, and what is not finite becomes 0.
std::vector<double> continuePressures(
    PenPressures& pressures, std::size_t points, const std::vector<double>& told);

} // namespace core
