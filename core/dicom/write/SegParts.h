// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/source/ItemWriter.h"
#include "core/dicom/write/SegWriter.h"

#include <array>
#include <string>

class DcmFileFormat;

namespace core {

// Parts that both writers of DICOM SEG share. Only for sources of core/dicom.

/// The codes that are written for a segment.
[[nodiscard]] SegCodes segCodesOf(const SegContent& content, const Segment& segment);

/// Errors: InvalidField (a code that DICOM does not allow).
[[nodiscard]] Result<void> checkSegCodes(const Segment& segment, const SegCodes& codes);

/// Writes modifier and region of a segment into its item of SegmentSequence.
void putSegDetails(DcmItem* segment, const SegCodes& codes, const ItemWriter& items);

/// What the object is and, in ASCII, how the series on which it was drawn was repaired.
[[nodiscard]] QString contentDescription(const SegContent& content);
/// The same for each of its frames.
[[nodiscard]] QString derivationDescription(const SegContent& content);
/// "MANUAL" …
[[nodiscard]] std::string algorithmTypeText(const SegSettings& settings);
/// Empty if there is none (manual). Letters beyond ASCII are replaced by placeholders.
[[nodiscard]] std::string algorithmName(const SegSettings& settings);

/// RecommendedDisplayCIELabValue of a colour 0xRRGGBB.
[[nodiscard]] std::array<std::uint16_t, 3> cieLabOf(std::uint32_t rgb);

/// Close to the number of the source series in a list, and not used by scanners.
[[nodiscard]] int segSeriesNumber(const StudyIdentity& source);

/// De-identifies the object if requested, and writes the file.
[[nodiscard]] Result<SegWritten> saveSeg(
    const QString& path, const SegContent& content, DcmFileFormat& format, ReportLines notes);

} // namespace core
