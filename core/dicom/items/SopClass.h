// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/dicom/base/ImageHeader.h"

namespace core {

/// What a DICOM object is if it cannot contain slices of a volume ("DICOM SEG", "RT structure set",
/// "DICOMDIR", "report" …); empty if it may be an image.
[[nodiscard]] Clause kindWithoutSlices(const ImageHeader& header);

/// The SOP class of a DICOM file, from its header. Errors: those of DicomFile::open().
[[nodiscard]] Result<QString> sopClassOf(const QString& path);

} // namespace core
