// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/fields/Quantum.h"
#include "core/edits/kinds/Edit.h"

#include <glm/glm.hpp>

#include <vector>

namespace core {

struct PenSample;

/// The edit with every number rounded to its grid. quantised(quantised(e)) equals quantised(e), and
/// editFromJson(editToJson(quantised(e))) equals quantised(e), bit by bit.
[[nodiscard]] Edit quantised(const Edit& edit);

/// The same for one piece of a pen path.
[[nodiscard]] std::vector<PenSample> quantised(const std::vector<PenSample>& samples);
/// The same for one piece of a brush's path.
[[nodiscard]] std::vector<glm::dvec3> quantised(const std::vector<glm::dvec3>& pointsLps);
/// The same for the pressures along it; what is out of range is brought into it.
[[nodiscard]] std::vector<double> quantisedPressures(const std::vector<double>& pressures);

} // namespace core
