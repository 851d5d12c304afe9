// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/stack/SlicePlaces.h"

#include <QString>

#include <vector>

namespace core {

/// The images of one quantity (ImageHeader::quantity), at least one at each position.
struct QuantityImages {
    Clause quantity;
    std::vector<ImageHeader> images{};
};

/// Separates images of several quantities that share their positions, such as a field map and its
/// magnitude: these are different volumes, not points in time. Ordered by instance number. Empty,
/// with @p places unchanged, unless every position has images of every quantity and no others.
[[nodiscard]] std::vector<QuantityImages> takeApartByQuantity(std::vector<SlicePlace>& places);

} // namespace core
