// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/ImageHeader.h"

#include <vector>

namespace core {

/// Splits the slices of one series by what no volume can mix, whatever else their headers say
/// (DICOM.md 1.3): plane, rows and columns, pixel spacing, frame of reference, stack. Not by
/// acquisition, thickness or slope, which differ within volumes. Groups and their images keep the
/// order in which they came.
/// @param slices with a place and a scale (whyApart())
[[nodiscard]] std::vector<std::vector<ImageHeader>> splitSeries(std::vector<ImageHeader> slices);

/// Some de-identified series give every image a frame of reference of its own; that says nothing.
[[nodiscard]] bool framesOfReferenceAreMeaningless(const std::vector<ImageHeader>& slices);

} // namespace core
