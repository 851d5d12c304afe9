// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/dicom/write/SegSettings.h"
#include "core/document/Document.h"
#include "core/export/common/ExportFormats.h"
#include "core/volume/Volume.h"

#include <QString>
#include <QStringList>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace core {

/// The labels of one plane on the volume's grid, x fastest.
struct LabelPlaneView {
    std::uint8_t plane = 0;
    std::span<const std::uint8_t> labels;
};

/// "Anatomical Structure" (DICOM CID 7150): what a segment is unless something else is said.
[[nodiscard]] CodedConcept anatomicalStructure();

class Deidentifier;

/// What a segment was made of: a sculpt layer whose coverage says how much of each voxel it fills
/// (Occupancy.h).
struct SegmentCoverage {
    std::uint8_t label = 0;
    QString layer; ///< its name, for the report
    std::span<const std::uint8_t> coverage; ///< x fastest
};

/// What to write, and where.
struct ExportRequest {
    ExportFormat format = ExportFormat::DicomSeg;
    QString file;
    bool force = false; ///< replace a file of that name
    std::vector<Segment> segments; ///< in the order of their numbers in the file
    std::vector<LabelPlaneView> planes; ///< every plane that a segment names
    CodedConcept category = anatomicalStructure();
    MeshSpace space = MeshSpace::Lps; ///< of surfaces
    SegSettings seg{}; ///< of a DICOM SEG
    std::vector<SegmentCoverage> coverages{}; ///< of a fractional one
    std::span<const std::uint16_t> codes{}; ///< the volume's, x fastest; for statistics
    std::shared_ptr<const Deidentifier> deidentifier{}; ///< null: the patient stays named
};

/// What was done, in sentences for a person.
struct ExportReport {
    QString file;
    QStringList written;
    QStringList checked;
    QStringList cautions; ///< what a reader of the file must know
    QString sha256{}; ///< of the file, in hexadecimal digits, read from the disk after the check
};

/// Writes the voxels of the segments and nothing else, then opens the file and the volume's source
/// files again and checks one against the other (CheckExport.h). The file appears under its name
/// only after that; on any failure nothing is left behind, and a file of that name is as it was.
///
/// Segments without a voxel are left out and named. DICOM SEG: one BINARY object, empty frames left
/// out, every frame on its native slice, also where the stack is tilted or uneven; or a FRACTIONAL
/// one of type OCCUPANCY, or a LABELMAP. RTSTRUCT: closed
/// contours along the borders of the voxels, on the native slices. NIfTI: one label
/// map on the source's grid; the file's name must end in .nii or .nii.gz. 3D Slicer segmentation:
/// the same map with names, colours and codes in one layer; the name must end in .seg.nrrd.
/// Statistics: numbers of SegmentStatistics.h; SR also writes the DICOM SEG that it refers to,
/// beside it ("a-seg.dcm").
///
/// De-identified, segments have neutral names, DICOM objects neither patient nor old UIDs; the file
/// is searched for both.
///
/// Cost: reads every source header twice and the export once. Any thread.
/// Errors: NothingToExport, SegmentNotCoded (argument 0: the segment), UnknownSegment, FileExists,
/// FileUnwritable, UnsupportedFormat (argument 1: why, and what is possible instead),
/// InvalidField, ExportMismatch, Cancelled, and those of reading the sources.
Result<ExportReport> exportMask(
    const Volume& volume, const ExportRequest& request, const Progress& progress);

/// Why this volume cannot carry a DICOM SEG or RTSTRUCT, as a clause; empty if it can. Reads no
/// file.
[[nodiscard]] QString dicomSegObstacle(const Volume& volume);

} // namespace core
