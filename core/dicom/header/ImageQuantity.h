// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace core {

/// What the values of an image measure, in words: "magnitude", "phase", "field map", "water" … Empty
/// where neither attribute says. Upper and lower case are the same.
/// @param imageType (0008,0008), or a frame's (0008,9007): PS3.3 C.7.6.1.1.2, C.8.13.3.1.1; vendors
///     name the quantity from the third value on
/// @param complexComponent (0008,9208), PS3.3 C.8.13.3.1.2; goes before the image type unless that
///     names a map worked out from the images
[[nodiscard]] QString imageQuantity(const QString& imageType, const QString& complexComponent);

} // namespace core
