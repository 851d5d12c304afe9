// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/files/StagedFile.h"
#include "core/base/words/Clause.h"
#include "core/export/common/ExportMask.h"

namespace core {

/// An export that was written and checked and only needs its name.
struct StagedExport {
    StagedFile file;
    ExportReport report;
    std::shared_ptr<StagedExport> beside{}; ///< for a report: the SEG to which it refers
};

/// The segments of a request without the empty ones.
struct MaskSelection {
    std::vector<Segment> segments;
    /// per segment: slices with at least one voxel, ascending
    std::vector<std::vector<int>> slices;
    QStringList empty;
};

/// Errors: NothingToExport, UnknownSegment (its plane is missing).
Result<MaskSelection> selectMask(const Volume& volume, const ExportRequest& request);

/// The plane of a segment; null if the request lacks it.
const LabelPlaneView* planeOf(const ExportRequest& request, const Segment& segment);

/// A sentence that says why overlapping segments cannot be written as one map of numbers: which
/// two, and in how many voxels. Empty if no two of them share a voxel.
/// @param format name of the format: "NRRD", …
Clause whyNoLabelMap(
    const ExportRequest& request, const std::vector<Segment>& segments, const QString& format);

std::size_t voxelsPerSlice(const Volume& volume);

/// The coverage from which a segment was made; null: none.
const SegmentCoverage* coverageOf(
    std::span<const SegmentCoverage> coverages, const Segment& segment);

/// The checksum as hexadecimal digits. Errors: FileUnreadable.
Result<QString> sha256OfFile(const QString& path);

/// Whether the volume was read from this file.
bool isSourceFile(const Volume& volume, const QString& file);

/// Writes the selection to @p path, which the caller has staged, and adds what a reader of the file
/// must know to the report. @returns sentences on what was written
Result<ReportLines> writeSegMask(const QString& path, const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, const Progress& progress,
    ExportReport& report);
Result<ReportLines> writeRtStructMask(const QString& path, const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, const Progress& progress,
    ExportReport& report);
Result<ReportLines> writeSurfaces(const QString& path, const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, const Progress& progress,
    ExportReport& report);
Result<ReportLines> writeNiftiMask(const QString& path, const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, ExportReport& report);
/// Writes CSV, JSON or SR. @param seg the SEG to which an SR refers and which the report names;
/// else null
Result<ReportLines> writeStatistics(const QString& path, const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, const StagedExport* seg,
    const Progress& progress, ExportReport& report);
Result<ReportLines> writeSegNrrdMask(const QString& path, const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, ExportReport& report);

} // namespace core
