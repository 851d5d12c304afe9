// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/source/ItemWriter.h"
#include "core/dicom/write/SegWriter.h"

#include <array>
#include <string>

class DcmFileFormat;

namespace core {

// What both writers of DICOM SEG share. Only for sources of core/dicom.

/// What a segment is, as the object says it.
[[nodiscard]] SegCodes segCodesOf(const SegContent& content, const Segment& segment);

/// Errors: InvalidField (a code that DICOM cannot hold).
[[nodiscard]] Result<void> checkSegCodes(const Segment& segment, const SegCodes& codes);

/// Puts modifier and region of a segment into its item of SegmentSequence.
void putSegDetails(DcmItem* segment, const SegCodes& codes, const ItemWriter& items);

/// "MANUAL" …
[[nodiscard]] std::string algorithmTypeText(const SegSettings& settings);
/// Empty where there is none: by hand. Placeholders for letters beyond ASCII.
[[nodiscard]] std::string algorithmName(const SegSettings& settings);

/// RecommendedDisplayCIELabValue of a colour 0xRRGGBB.
[[nodiscard]] std::array<std::uint16_t, 3> cieLabOf(std::uint32_t rgb);

/// Beside the series it was drawn on in a list, and of no scanner's own numbers.
[[nodiscard]] int segSeriesNumber(const StudyIdentity& source);

/// De-identifies the object where that is asked for, and writes the file.
[[nodiscard]] Result<SegWritten> saveSeg(
    const QString& path, const SegContent& content, DcmFileFormat& format, QStringList notes);

} // namespace core
