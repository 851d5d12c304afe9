// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/fields/Quantum.h"
#include "core/edits/kinds/Edit.h"

#include <glm/glm.hpp>

#include <vector>

namespace core {

struct PenSample;

/// The edit with every number on its grid. quantised(quantised(e)) equals quantised(e), and
/// editFromJson(editToJson(quantised(e))) equals quantised(e), to the bit.
[[nodiscard]] Edit quantised(const Edit& edit);

/// The same for one piece of a pen path.
[[nodiscard]] std::vector<PenSample> quantised(const std::vector<PenSample>& samples);
/// … or of a brush's path.
[[nodiscard]] std::vector<glm::dvec3> quantised(const std::vector<glm::dvec3>& pointsLps);

} // namespace core
