// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/ImageHeader.h"

namespace core {

/// What a DICOM object is if it can hold no slices of a volume ("DICOM SEG", "RT structure set",
/// "DICOMDIR", "report" …); empty if it may be an image.
[[nodiscard]] QString kindWithoutSlices(const ImageHeader& header);

} // namespace core
