// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/measure/region/Measured.h"
#include "core/titles/ReportSentence.h"
#include "core/volume/Volume.h"

#include <memory>
#include <optional>
#include <vector>

namespace core {

class Deidentifier;

/// What has changed in a segment since it was imported.
struct SrSinceImport {
    double addedMl = 0.0;
    double takenMl = 0.0;
    double dice = 1.0;
};

/// The measurements of one segment in a report.
struct SrGroup {
    Segment segment;
    std::int64_t voxels = 0;
    double volumeMl = 0.0;
    double surfaceMm2 = 0.0;
    double sphericity = 0.0;
    double longestMm = 0.0;
    double acrossMm = 0.0; ///< the longest one perpendicular to it
    double minimum = 0.0;
    double maximum = 0.0;
    double mean = 0.0;
    double deviation = 0.0;
    double median = 0.0;
    std::optional<SrSinceImport> sinceImport{}; ///< none: it was not imported
};

struct SrContent {
    StudyIdentity identity; ///< of the source, as it was loaded
    std::vector<SourceSlice> sources;
    std::shared_ptr<const KeptHeaders> keptHeaders; ///< replaces these; null: their files are read
    /// the DICOM SEG to which it refers: its segments 1, 2 … are those of `groups`, in order
    QString seg;
    std::vector<SrGroup> groups;
    /// What was measured beside them; arrows and texts are left out.
    std::vector<Measured> measured{};
    VolumeGeometry geometry{}; ///< the grid on which it was measured
    QString unit; ///< of values: "HU", "SUVbw" …; may be empty
    /// The source does not state the spacing: segments have their volume in voxels, and no other
    /// size.
    bool sizesInVoxels = false;
    /// the one with which the SEG was written; null: the patient's identity is kept
    std::shared_ptr<const Deidentifier> deidentifier;
};

/// Writes a DICOM SR measurement report (PS3.16 TID 1500, groups of TID 1411) to @p path as an
/// Enhanced SR: one group per segment with tracking, finding, the segment of the SEG, its source
/// series, volume (cm3), surface (mm2), sphericity, longest diameter and the longest one across it
/// (mm; "Short Axis" of CID 7470), or the number of voxels alone, and values with their derivation;
/// and one per measurement (SrMeasured.h), with which it is a Comprehensive 3D SR. What was changed
/// since an import has concepts of Burin's own (scheme 99BURIN), since DICOM has no code for the
/// Dice coefficient or for volumes added and taken. It uses plain dcmdata, since DCMTK's own
/// templates accept only ASCII.
///
/// @returns sentences on what was normalised or left out of the source's header
/// Errors: as for writeSeg(), and those of reading the SEG.
[[nodiscard]] Result<ReportLines> writeSr(
    const QString& path, const SrContent& content, const Progress& progress);

} // namespace core
