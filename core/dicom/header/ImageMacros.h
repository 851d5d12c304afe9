// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/ImageHeader.h"
#include "core/dicom/items/HeaderAttributes.h"

namespace core {

// Each reads one group of attributes, which single-frame objects have in their data set and
// multi-frame ones in an item per frame. Only for sources of core/dicom.

/// Image Position (Patient).
void readPosition(const HeaderAttributes& from, ImageHeader& header);
/// Image Orientation (Patient); none where its vectors are neither long nor square enough.
void readOrientation(const HeaderAttributes& from, ImageHeader& header);
/// Pixel spacing, slice thickness, spacing between slices.
void readMeasures(const HeaderAttributes& from, ImageHeader& header);
/// Slope and intercept of stored values.
void readRescale(const HeaderAttributes& from, ImageHeader& header);
/// The first window, if it is one.
void readWindow(const HeaderAttributes& from, ImageHeader& header);

} // namespace core
