// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/ImageHeader.h"
#include "core/volume/Volume.h"

#include <vector>

namespace core {

/// Images of one plane at one position along its normal.
struct SlicePlace {
    double along = 0.0; ///< mm
    std::vector<ImageHeader> images{};
};

/// Sorts images of one grid (splitSeries()) by where they lie along row × column. File names,
/// instance numbers and slice locations have no say.
[[nodiscard]] std::vector<SlicePlace> sortIntoPlaces(std::vector<ImageHeader> images);

/// Drops images that are at the same place under the same UID, or byte for byte the same.
/// @return what was dropped, in words
[[nodiscard]] std::vector<VolumeProblem> dropDuplicates(std::vector<SlicePlace>& places);

} // namespace core
