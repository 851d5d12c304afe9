// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/ImageHeader.h"
#include "core/volume/Volume.h"

#include <vector>

namespace core {

/// The images of one plane at one position along its normal.
struct SlicePlace {
    double along = 0.0; ///< mm
    std::vector<ImageHeader> images{};
};

/// Sorts images of one grid (splitSeries()) by their position along row × column. File names,
/// instance numbers and slice locations are not used.
[[nodiscard]] std::vector<SlicePlace> sortIntoPlaces(std::vector<ImageHeader> images);

/// Drops images that have the position and UID of another one, or the same bytes.
/// @return what was dropped, in words
[[nodiscard]] std::vector<VolumeProblem> dropDuplicates(std::vector<SlicePlace>& places);

} // namespace core
