// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/base/ImageHeader.h"
#include "core/dicom/items/HeaderAttributes.h"

namespace core {

// Each function reads one group of attributes, which single-frame objects have in their data set
// and multi-frame objects in an item for each frame. Only for sources of core/dicom.

/// Image Position (Patient).
void readPosition(const HeaderAttributes& from, ImageHeader& header);
/// Image Orientation (Patient); none if its vectors are not of unit length or not perpendicular.
void readOrientation(const HeaderAttributes& from, ImageHeader& header);
/// Pixel spacing, slice thickness, spacing between slices.
void readMeasures(const HeaderAttributes& from, ImageHeader& header);
/// Slope and intercept of stored values.
void readRescale(const HeaderAttributes& from, ImageHeader& header);
/// Scale and unit of a dose (PS3.3 C.8.8.3), which take the place of slope and intercept; nothing
/// if there is no scale.
void readDoseScale(const HeaderAttributes& from, ImageHeader& header);
/// The first window, if it is valid.
void readWindow(const HeaderAttributes& from, ImageHeader& header);

} // namespace core
