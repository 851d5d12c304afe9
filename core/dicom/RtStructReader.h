// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/dicom/SourceHeader.h"
#include "core/document/Document.h"

#include <optional>
#include <vector>

namespace core {

/// A closed curve in a plane, LPS mm. The last point is not the first one again.
struct RtContour {
    std::vector<glm::dvec3> points;
};

/// One item of StructureSetROISequence with what other sequences say of it.
struct RtRoi {
    int number = 0;
    QString name;
    std::optional<std::uint32_t> rgb; ///< 0xRRGGBB
    CodedConcept code;
    std::vector<RtContour> contours; ///< closed ones
    int others = 0; ///< points and open curves, which surround nothing
};

/// A DICOM RT Structure Set, as it lies in the file.
struct RtStructFile {
    HeaderPatient patient;
    QString frameOfReferenceUid; ///< of the first one; empty if it names none
    std::vector<RtRoi> rois;
};

/// Cost: the file once. Any thread.
/// Errors: FileNotFound, FileUnreadable, FileTruncated, UnsupportedFormat (no RT Structure Set),
/// FileUnreadable too where the numbers of a contour are no points.
[[nodiscard]] Result<RtStructFile> readRtStruct(const QString& path);

/// The SOP class of a DICOM file, by its header. Errors: those of DicomFile::open().
[[nodiscard]] Result<QString> sopClassOf(const QString& path);

} // namespace core
