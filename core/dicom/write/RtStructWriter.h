// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/titles/ReportSentence.h"
#include "core/volume/Volume.h"

#include <glm/glm.hpp>

#include <QStringList>

#include <memory>
#include <vector>

namespace core {

class Deidentifier;

/// The contents of an RTSTRUCT to be written. Contours are ordered by segment, then by slice.
struct RtStructContent {
    struct Contour {
        int segment = 0; ///< index into `segments`
        int slice = 0; ///< index into `sources`
        std::vector<glm::ivec2> corners; ///< (x, y): half a pixel before the centre of pixel (x, y)
    };

    StudyIdentity identity; ///< of the source, as it was loaded
    QString repair; ///< how the series was repaired on loading (repairMade()); empty: not at all
    std::vector<SourceSlice> sources;
    std::shared_ptr<const KeptHeaders> keptHeaders; ///< replaces these; null: their files are read
    std::vector<Segment> segments; ///< each with a contour
    std::vector<Contour> contours;
    std::shared_ptr<const Deidentifier> deidentifier{}; ///< null: the patient's identity is kept
};

/// The result of writing.
struct RtStructWritten {
    /// Sentences on invalid parts of the source's header that were normalised or left out.
    ReportLines notes;
};

/// Writes a DICOM RT Structure Set (PS3.3 A.19) to @p path, which is created or overwritten: one
/// ROI per segment, with CLOSED_PLANAR contours in the planes of the source images, positioned by
/// the images' own headers. In implicit VR, since explicit VR limits a contour's numbers to 64 KiB.
///
/// Patient, study and frame of reference are those of the source's header. UIDs are new. Reads the
/// header of every source. Any thread.
/// Errors: FileUnreadable and FileNotFound (a source), UnsupportedFormat (what the source lacks),
/// FileUnwritable, Cancelled, Internal.
Result<RtStructWritten> writeRtStruct(
    const QString& path, const RtStructContent& content, const Progress& progress);

} // namespace core
