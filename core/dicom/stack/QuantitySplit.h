// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/stack/SlicePlaces.h"

#include <QString>

#include <vector>

namespace core {

/// Images of one quantity (ImageHeader::quantity), with at least one at every place.
struct QuantityImages {
    QString quantity;
    std::vector<ImageHeader> images{};
};

/// Images of several quantities that share their places, such as a field map and its magnitude:
/// they are volumes beside each other, not points in time. In order of their instance numbers.
/// Empty, and @p places as they were, unless every place has images of every quantity and of
/// nothing else.
[[nodiscard]] std::vector<QuantityImages> takeApartByQuantity(std::vector<SlicePlace>& places);

} // namespace core
