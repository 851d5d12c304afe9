// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

namespace core {

/// The default threshold between visible and invisible values in 3D, in modality units: that of
/// skin for values in HU, otherwise halfway between the minimum and the value that separates air
/// from the rest (otsuThreshold()). The window starts with it, and recipes that give no threshold
/// use it.
[[nodiscard]] double usualSurfaceThreshold(const Volume& volume);

/// The threshold between the two classes of a histogram whose between-class variance is greatest
/// (Otsu 1979).
[[nodiscard]] double otsuThreshold(const Histogram& histogram);

} // namespace core
