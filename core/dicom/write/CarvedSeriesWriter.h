// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/volume/Volume.h"

#include <QString>
#include <QStringList>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace core {

class Deidentifier;

/// A series made from another one by taking voxels away.
struct CarvedSeries {
    std::vector<SourceSlice> sources; ///< one single-frame image per slice
    glm::ivec3 size{0};
    std::span<const std::uint8_t> coverage; ///< x fastest; 128 and more: taken away
    double fill = 0.0; ///< modality units: what stands there instead
    QString unit; ///< of it, for the description; may be empty
    std::shared_ptr<const Deidentifier> deidentifier{}; ///< null: the patient stays named
};

/// Writes "IM0001.dcm" and so on, one image a slice, explicit VR little endian, into @p folder,
/// which must be there. Each is its source image with other pixels: stored values outside the cut
/// are the source's to the bit, with its rescale, place and patient. Its own are the UIDs of
/// series and instances, ImageType DERIVED\SECONDARY, "CARVED" in the series description, and the
/// reference to its source. Private elements, overlays, icons and signatures do not go along.
///
/// One core; any thread. @returns what is not as in the source, in sentences
/// Errors: UnsupportedFormat (several frames in one file; a fill value that a slice cannot hold),
/// FileUnwritable, Cancelled, and those of reading the sources. Files written until then stay; the
/// caller cleans its folder.
Result<QStringList> writeCarvedSeries(
    const QString& folder, const CarvedSeries& series, const Progress& progress);

} // namespace core
