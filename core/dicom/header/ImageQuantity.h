// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"

#include <QString>

namespace core {

/// What the values of an image measure: "magnitude", "phase", "field map", "water" …
/// Empty if neither attribute states it. Case is ignored.
/// @param imageType (0008,0008), or that of a frame (0008,9007): PS3.3 C.7.6.1.1.2, C.8.13.3.1.1;
/// vendors state the quantity from the third value on
/// @param complexComponent (0008,9208), PS3.3 C.8.13.3.1.2; takes precedence over the image type,
/// unless that denotes a map computed from the images
[[nodiscard]] Clause imageQuantity(const QString& imageType, const QString& complexComponent);

} // namespace core
