// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/ProgressStep.h"

#include <QString>

namespace ui {

/// Returns what work is doing at the moment: "Reading slices".
[[nodiscard]] QString progressText(core::ProgressStep step);

} // namespace ui
