// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <optional>
#include <vector>

namespace core {

/// How firmly the pen was pressed at each point of a path, 0 … 1: the share of the tool's radius
/// that it has there, or of what the edit says instead, changing evenly from point to point. None:
/// all of it everywhere, as a mouse has it and as rows of before have it.
using PenPressures = std::optional<std::vector<double>>;

/// Whether there are as many as points, if there are any. @param name of the edit, for the error
[[nodiscard]] Result<void> checkPressures(
    const PenPressures& pressures, std::size_t points, const QString& name);

/// Goes on with those of further points, and returns these. A path that began without them goes on
/// without; where none is told the pen is pressed fully, and what is no pressure presses nothing.
std::vector<double> continuePressures(
    PenPressures& pressures, std::size_t points, const std::vector<double>& told);

} // namespace core
