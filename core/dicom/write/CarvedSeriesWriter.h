// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/titles/ReportSentence.h"
#include "core/volume/Volume.h"

#include <QString>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace core {

class Deidentifier;

/// A series derived from another one by removing voxels.
struct CarvedSeries {
    std::vector<SourceSlice> sources; ///< one single-frame image per slice
    glm::ivec3 size{0};
    std::span<const std::uint8_t> coverage; ///< x fastest; 128 and more: removed
    double fill = 0.0; ///< modality units: the value that replaces removed voxels
    QString unit; ///< of the fill value, for the description; may be empty
    std::shared_ptr<const Deidentifier> deidentifier{}; ///< null: the patient's identity is kept
};

/// Writes one image per slice, "IM0001.dcm" and so on, explicit VR little endian, into @p folder,
/// which must exist. Each is its source image with other pixels: stored values outside the cut are
/// those of the source bit by bit, with its rescale, position and patient. New are the UIDs of
/// series and instances, ImageType DERIVED\SECONDARY, "CARVED" in the series description, and the
/// reference to the source. Private elements, overlays, icons and signatures are not copied.
///
/// One core; any thread. @returns sentences on what differs from the source Errors:
/// UnsupportedFormat (several frames in one file; a fill value that a slice cannot store),
/// FileUnwritable, Cancelled, and those of reading the sources. Files written before an error
/// remain; the caller cleans its folder.
Result<ReportLines> writeCarvedSeries(
    const QString& folder, const CarvedSeries& series, const Progress& progress);

} // namespace core
