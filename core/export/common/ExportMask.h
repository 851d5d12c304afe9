// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/base/words/Clause.h"
#include "core/brick/VoxelRuns.h"
#include "core/dicom/write/SegSettings.h"
#include "core/document/Document.h"
#include "core/export/common/ExportFormats.h"
#include "core/titles/ReportSentence.h"
#include "core/volume/Volume.h"

#include <QString>

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

/// "Anatomical Structure" (DICOM CID 7150): the default category of a segment.
[[nodiscard]] CodedConcept anatomicalStructure();

class Deidentifier;

/// The sculpt layer from which a segment was made; its coverage says how much of each voxel the
/// segment fills (Occupancy.h).
struct SegmentCoverage {
    std::uint8_t label = 0;
    QString layer; ///< its name, for the report
    std::span<const std::uint8_t> coverage; ///< x fastest
};

/// The voxels that were imported as a segment: a network's mask, for instance.
struct ImportedVoxels {
    std::uint8_t label = 0;
    VoxelRuns voxels;
};

/// A request to export segments.
struct ExportRequest {
    ExportFormat format = ExportFormat::DicomSeg;
    QString file;
    bool force = false; ///< replace a file of that name
    std::vector<Segment> segments; ///< in the order of their numbers in the file
    std::vector<LabelPlaneView> planes; ///< every plane that contains one of the segments
    CodedConcept category = anatomicalStructure();
    MeshSpace space = MeshSpace::Lps; ///< for surfaces
    SegSettings seg{}; ///< for a DICOM SEG
    std::vector<SegmentCoverage> coverages{}; ///< for a fractional SEG
    std::span<const std::uint16_t> codes{}; ///< those of the volume, x fastest; for statistics
    /// For statistics: the voxels that segments were imported with. For each segment listed here,
    /// the statistics say what was changed since.
    std::vector<ImportedVoxels> imported{};
    std::shared_ptr<const Deidentifier> deidentifier{}; ///< null: the patient's identity is kept
    std::vector<Measurement> measurements{}; ///< for a report, beside the segments
};

/// What an export did; ui/texts/ReportTexts.h words it.
struct ExportReport {
    QString file;
    ReportLines written;
    ReportLines checked;
    ReportLines cautions; ///< what a reader of the file must know
    QString sha256{}; ///< of the file, hex, read from the disk after the check
};

/// Writes the voxels of the segments and nothing else, then opens the file and the volume's source
/// files again and compares them (CheckExport.h). The file appears under its name only after that.
/// If anything fails, nothing is left, and an existing file is unchanged.
///
/// Segments without voxels are left out and listed. The formats:
/// - DICOM SEG: one BINARY object without empty frames, every frame on its native slice even if the
///   stack is tilted or uneven; or a FRACTIONAL one of type OCCUPANCY, or a LABELMAP.
/// - RTSTRUCT: closed contours along the borders of the voxels, on the native slices.
/// - NIfTI: one label map on the source's grid; the file name must end in .nii or .nii.gz.
/// - 3D Slicer segmentation: the same map with names, colours and codes, in one layer or, where
///   segments overlap, one for each label plane; the file name must end in .seg.nrrd.
/// - Statistics: the numbers of SegmentStatistics.h; an SR also writes the DICOM SEG to which it
///   refers beside it ("a-seg.dcm").
///
/// In a de-identified export, segments have neutral names, and DICOM objects contain neither the
/// patient nor original UIDs; the file is searched for both.
///
/// Cost: every source header is read twice, the export once. Any thread. Errors: NothingToExport,
/// SegmentNotCoded (argument 0: the segment), UnknownSegment, FileExists, FileUnwritable,
/// UnsupportedFormat (argument 1: why, and what is possible instead), InvalidField, ExportMismatch,
/// Cancelled, and those of reading the sources.
Result<ExportReport> exportMask(
    const Volume& volume, const ExportRequest& request, const Progress& progress);

/// Why a DICOM SEG or RTSTRUCT cannot be written for this volume, as a clause; empty if it can.
/// Reads no file.
[[nodiscard]] Clause dicomSegObstacle(const Volume& volume);

} // namespace core
