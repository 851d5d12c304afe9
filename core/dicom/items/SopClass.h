// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/dicom/base/ImageHeader.h"

namespace core {

/// What a DICOM object is if it cannot contain slices of a volume ("DICOM SEG", "RT structure set",
/// "DICOMDIR", "report" …); empty if it may be an image.
[[nodiscard]] Clause kindWithoutSlices(const ImageHeader& header);

/// Whether it is the class of RT doses (PS3.3 C.8.8.3).
[[nodiscard]] bool isDose(const QString& sopClassUid);

/// Whether objects of a class have one plane for all of their frames, which lie behind each other
/// along its normal: doses, and images of nuclear medicine.
[[nodiscard]] bool haveFramesInARow(const QString& sopClassUid);

/// The SOP class of a DICOM file, from its header. Errors: those of DicomFile::open().
[[nodiscard]] Result<QString> sopClassOf(const QString& path);

} // namespace core
