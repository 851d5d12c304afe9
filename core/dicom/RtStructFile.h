// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/dicom/SourceHeader.h"

#include <QString>
#include <QStringList>

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// One item of ContourSequence (PS3.3 C.8.8.6).
struct RtContour {
    QString geometricType; ///< CLOSED_PLANAR …
    QString referencedSopUid; ///< the source image; empty if none is named
    int referencedFrame = 0; ///< 0-based
    std::vector<glm::dvec3> points; ///< LPS mm
};

/// A region of interest: what StructureSetROISequence and ROIContourSequence say of one number.
struct RtRoi {
    int number = 0;
    QString name;
    QString frameOfReferenceUid;
    std::optional<std::uint32_t> rgb; ///< 0xRRGGBB
    std::vector<RtContour> contours;
};

/// A DICOM RT Structure Set, as it lies in the file.
struct RtStructFile {
    HeaderPatient patient;
    QString studyUid;
    QString frameOfReferenceUid; ///< of the first item of ReferencedFrameOfReferenceSequence
    QStringList referencedSopUids; ///< of all series in there
    std::vector<RtRoi> rois; ///< in the order of StructureSetROISequence
};

/// Reads an RTSTRUCT. Cost: the file once. Any thread.
/// Errors: FileNotFound, FileUnreadable (also: points that are no numbers or not as many as said),
/// UnsupportedFormat (no RTSTRUCT).
Result<RtStructFile> readRtStruct(const QString& path);

} // namespace core
