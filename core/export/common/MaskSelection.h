// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/files/StagedFile.h"
#include "core/export/common/ExportMask.h"

namespace core {

/// What is written and checked and has only to be given its name.
struct StagedExport {
    StagedFile file;
    ExportReport report;
    std::shared_ptr<StagedExport> beside{}; ///< of a report: the SEG that it refers to
};

/// What is left of a request once the empty segments are out of it.
struct MaskSelection {
    std::vector<Segment> segments;
    std::vector<std::vector<int>> slices; ///< per segment, those that hold a voxel, ascending
    QStringList empty;
};

/// Errors: NothingToExport, UnknownSegment (its plane is not there).
Result<MaskSelection> selectMask(const Volume& volume, const ExportRequest& request);

/// The plane that a segment lives in; null if the request lacks it.
const LabelPlaneView* planeOf(const ExportRequest& request, const Segment& segment);

std::size_t voxelsPerSlice(const Volume& volume);

/// The coverage that a segment was made of; null: none.
const SegmentCoverage* coverageOf(
    std::span<const SegmentCoverage> coverages, const Segment& segment);

/// Hexadecimal digits. Errors: FileUnreadable.
Result<QString> sha256OfFile(const QString& path);

/// Whether a file is one that the volume was read from.
bool isSourceFile(const Volume& volume, const QString& file);

/// Writes what was selected at @p path, which the caller staged; what the reader of the file must
/// know goes into the report. @returns what was written, in sentences
Result<QStringList> writeSegMask(const QString& path, const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, const Progress& progress,
    ExportReport& report);
Result<QStringList> writeRtStructMask(const QString& path, const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, const Progress& progress,
    ExportReport& report);
Result<QStringList> writeSurfaces(const QString& path, const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, const Progress& progress,
    ExportReport& report);
Result<QStringList> writeNiftiMask(const QString& path, const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, ExportReport& report);
/// As CSV, JSON or SR. @param seg which an SR refers to and names in the report; else null
Result<QStringList> writeStatistics(const QString& path, const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, const StagedExport* seg,
    const Progress& progress, ExportReport& report);
Result<QStringList> writeSegNrrdMask(const QString& path, const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, ExportReport& report);

} // namespace core
