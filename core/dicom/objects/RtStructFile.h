// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/dicom/source/SourceHeader.h"
#include "core/document/Document.h"

#include <QString>
#include <QStringList>

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// One item of ContourSequence (PS3.3 C.8.8.6).
struct RtContour {
    QString geometricType; ///< CLOSED_PLANAR …
    QString referencedSopUid; ///< the source image; empty if none is stated
    int referencedFrame = 0; ///< 0-based
    std::optional<int> saidPoints; ///< the number of points that it states
    std::vector<glm::dvec3> points; ///< LPS mm, as in the file
};

/// A region of interest: what StructureSetROISequence, ROIContourSequence and
/// RTROIObservationsSequence state for one number.
struct RtRoi {
    int number = 0;
    QString name;
    QString frameOfReferenceUid;
    std::optional<std::uint32_t> rgb; ///< 0xRRGGBB
    CodedConcept code;
    std::vector<RtContour> contours;
};

/// The contents of a DICOM RT Structure Set, unchanged.
struct RtStructFile {
    HeaderPatient patient;
    QString studyUid;
    QString frameOfReferenceUid; ///< of the first item of ReferencedFrameOfReferenceSequence
    QStringList referencedSopUids; ///< of all series in there
    std::vector<RtRoi> rois; ///< in the order of StructureSetROISequence
    int contoursOfNone = 0; ///< items of ROIContourSequence whose number belongs to no region
};

/// Reads an RTSTRUCT. Cost: the file is read once. Any thread. Errors: those of DicomFile::open(),
/// FileNotFound, FileUnreadable (also for numbers that are not points), UnsupportedFormat (not an
/// RTSTRUCT).
[[nodiscard]] Result<RtStructFile> readRtStruct(const QString& path);

} // namespace core
