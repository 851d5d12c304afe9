// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

namespace core {

/// The value that parts what is seen from what is seen through while nobody has said another, in
/// modality units: skin for CT, else half of what parts air from the rest. The window starts with
/// it, and recipes that name no surface mean it.
[[nodiscard]] double usualSurfaceThreshold(const Volume& volume);

/// The value between the two classes of a histogram whose variance between them is greatest (Otsu
/// 1979).
[[nodiscard]] double otsuThreshold(const Histogram& histogram);

} // namespace core
