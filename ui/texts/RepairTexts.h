// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/repair/SeriesFindings.h"

#include <QString>

namespace ui {

/// Returns the name of a repair for a button: "Fill the gaps".
[[nodiscard]] QString repairTitle(const core::RepairOffer& offer);

/// Returns one or two sentences on what a repair does and to which slices. Empty for a repair that
/// was already made when the volume was opened.
[[nodiscard]] QString repairEffect(const core::RepairOffer& offer);

} // namespace ui
