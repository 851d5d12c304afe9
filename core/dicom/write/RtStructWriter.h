// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/volume/Volume.h"

#include <glm/glm.hpp>

#include <QStringList>

#include <memory>
#include <vector>

namespace core {

class Deidentifier;

/// What goes into an RTSTRUCT. Contours are ordered by segment, then by slice.
struct RtStructContent {
    struct Contour {
        int segment = 0; ///< index into `segments`
        int slice = 0; ///< index into `sources`
        std::vector<glm::ivec2> corners; ///< (x, y): half a pixel before the centre of pixel (x, y)
    };

    StudyIdentity identity; ///< of the source, as it was loaded
    QString repair; ///< how the series was repaired on loading (Volume::repair); empty: not at all
    std::vector<SourceSlice> sources;
    std::shared_ptr<const KeptHeaders> keptHeaders; ///< of these; null: their files are read
    std::vector<Segment> segments; ///< each with a contour
    std::vector<Contour> contours;
    std::shared_ptr<const Deidentifier> deidentifier{}; ///< null: the patient stays named
};

struct RtStructWritten {
    /// What of the source's header was not valid and had to be normalised or left out; sentences.
    QStringList notes;
};

/// Writes a DICOM RT Structure Set (PS3.3 A.19) at @p path, which it creates or overwrites: one ROI
/// a segment, its contours CLOSED_PLANAR in the planes of the source images, placed by the images'
/// own headers. In implicit VR, since explicit VR ends at 64 KiB for a contour's numbers.
///
/// Patient, study and frame of reference are those of the source's header. UIDs are new. Reads the
/// header of every source. Any thread.
/// Errors: FileUnreadable and FileNotFound (a source), UnsupportedFormat (what the source lacks),
/// FileUnwritable, Cancelled, Internal.
Result<RtStructWritten> writeRtStruct(
    const QString& path, const RtStructContent& content, const Progress& progress);

} // namespace core
