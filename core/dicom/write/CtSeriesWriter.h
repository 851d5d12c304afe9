// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/volume/Volume.h"

#include <QString>

#include <cstdint>
#include <functional>
#include <span>

namespace core {

/// A CT series that this program makes up itself.
struct CtSeries {
    StudyIdentity identity; ///< all of it is written; UIDs must be set
    VolumeGeometry geometry; ///< a box: no shear, no slicePositions
    std::span<const std::int16_t> hounsfield; ///< −1024 … 3071, x fastest
    WindowLevel window;
    QString bodyPart; ///< Body Part Examined, a defined term such as HEAD
    QString manufacturer; ///< of the equipment: who made the picture
    QString comments;
    /// SOP Instance UID of slice k.
    std::function<QString(int k)> instanceUid;
};

/// Writes one CT Image (PS3.3 A.3) a slice, "CT0001.dcm" and so on from the lowest slice up,
/// explicit VR little endian, 12 bits stored with intercept −1024, into @p folder, which must be
/// there. On all cores; any thread.
/// Errors: FileUnwritable. Files written until then stay; the caller cleans its folder.
Result<void> writeCtSeries(const QString& folder, const CtSeries& series);

} // namespace core
