// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/ProgressStep.h"

#include <QString>

namespace ui {

/// What work is doing: "Reading slices".
[[nodiscard]] QString progressText(core::ProgressStep step);

} // namespace ui
