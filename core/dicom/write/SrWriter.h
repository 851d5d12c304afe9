// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/volume/Volume.h"

#include <QStringList>

#include <memory>
#include <vector>

namespace core {

class Deidentifier;

/// What a measurement report says of one segment.
struct SrGroup {
    Segment segment;
    double volumeMl = 0.0;
    double surfaceMm2 = 0.0;
    double minimum = 0.0;
    double maximum = 0.0;
    double mean = 0.0;
    double deviation = 0.0;
    double median = 0.0;
};

struct SrContent {
    StudyIdentity identity; ///< of the source, as it was loaded
    std::vector<SourceSlice> sources;
    std::shared_ptr<const KeptHeaders> keptHeaders; ///< of these; null: their files are read
    QString seg; ///< the DICOM SEG it refers to: segments 1, 2 … are those of `groups`, in order
    std::vector<SrGroup> groups;
    QString unit; ///< of values: "HU", "SUVbw" …; may be empty
    std::shared_ptr<const Deidentifier> deidentifier; ///< the SEG was written by it, too
};

/// Writes a DICOM SR measurement report (PS3.16 TID 1500, groups of TID 1411) at @p path, an
/// Enhanced SR: a group a segment with tracking, finding, the segment of the SEG, its source
/// series, volume (cm3), surface (mm2) and values with their derivation. By plain dcmdata: DCMTK's
/// own templates take no letters beyond ASCII.
///
/// @returns what of the source's header was normalised or left out, in sentences
/// Errors: as writeSeg(), and those of reading the SEG.
[[nodiscard]] Result<QStringList> writeSr(
    const QString& path, const SrContent& content, const Progress& progress);

} // namespace core
