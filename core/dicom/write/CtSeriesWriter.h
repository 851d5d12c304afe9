// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/volume/Volume.h"

#include <QString>

#include <cstdint>
#include <functional>
#include <span>

namespace core {

/// A CT series that this program generates.
struct CtSeries {
    StudyIdentity identity; ///< written completely; UIDs must be set
    VolumeGeometry geometry; ///< without shear and slicePositions
    std::span<const std::int16_t> hounsfield; ///< −1024 … 3071, x fastest
    WindowLevel window;
    QString bodyPart; ///< Body Part Examined, a defined term such as HEAD
    QString manufacturer; ///< of the equipment that made the image
    QString comments;
    /// SOP Instance UID of slice k.
    std::function<QString(int k)> instanceUid;
};

/// Writes one CT Image (PS3.3 A.3) per slice, "CT0001.dcm" and so on from the lowest slice up,
/// explicit VR little endian, 12 bits stored with intercept −1024, into @p folder, which must
/// exist. Uses all cores; any thread. Errors: FileUnwritable. Files written before an error remain;
/// the caller cleans its folder.
Result<void> writeCtSeries(const QString& folder, const CtSeries& series);

} // namespace core
