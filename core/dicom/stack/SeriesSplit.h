// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/ImageHeader.h"

#include <vector>

namespace core {

/// Splits the slices of one series by what cannot differ within a volume: plane, rows and columns,
/// pixel spacing, frame of reference, stack. Acquisition, thickness and slope are not used, since
/// they differ within volumes. Groups and their images keep their original order.
/// @param slices with a position and a scale (whyApart())
[[nodiscard]] std::vector<std::vector<ImageHeader>> splitSeries(std::vector<ImageHeader> slices);

/// Whether every image has a frame of reference of its own, as in some de-identified series; it
/// then means nothing.
[[nodiscard]] bool framesOfReferenceAreMeaningless(const std::vector<ImageHeader>& slices);

} // namespace core
