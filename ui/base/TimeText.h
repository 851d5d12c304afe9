// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <QString>

namespace ui {

/// "point 3 of 10 · trigger time 80 ms" for a volume of a time series; else empty.
[[nodiscard]] QString timeText(const core::Volume& volume);

} // namespace ui
