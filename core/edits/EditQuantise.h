// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/fields/Quantum.h"
#include "core/edits/kinds/Edit.h"
#include "core/edits/open/StrokeExtension.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace core {

/// The edit with every number rounded to its grid. quantised(quantised(e)) equals quantised(e), and
/// editFromJson(editToJson(quantised(e))) equals quantised(e), bit by bit.
[[nodiscard]] Edit quantised(const Edit& edit);

/// The same for one piece of a pen path.
[[nodiscard]] std::vector<PenSample> quantised(const std::vector<PenSample>& samples);
/// The same for one piece of a brush's path.
[[nodiscard]] std::vector<glm::dvec3> quantised(const std::vector<glm::dvec3>& pointsLps);
/// The same for the pressures along it; what is out of range is brought into it.
[[nodiscard]] std::vector<double> quantisedPressures(const std::vector<double>& pressures);
/// The same for any input of an open edit. None: one of its numbers is out of the range that it has
/// in edits, so it must be ignored.
[[nodiscard]] std::optional<StrokeExtension> quantisedIfInRange(const StrokeExtension& extension);

} // namespace core
