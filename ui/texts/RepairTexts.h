// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/repair/SeriesFindings.h"

#include <QString>

namespace ui {

/// "Fill the gaps"
[[nodiscard]] QString repairTitle(const core::RepairOffer& offer);

/// One or two sentences on what a repair does to which slices; empty for what was done on opening.
[[nodiscard]] QString repairEffect(const core::RepairOffer& offer);

} // namespace ui
