// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/export/common/ExportMask.h"
#include "core/repair/WayBack.h"

#include <QString>
#include <QStringList>

namespace core {

/// Follows every voxel of every slice by its millimetres in the patient into the repaired volume,
/// with nothing of what made the way back, and compares what both hold.
/// @param onSlices the labels as they came back, @param repaired as they were drawn
/// @return what does not agree, as a clause; empty if all does
[[nodiscard]] QString differenceOfWayBack(const WayBack& back, const Volume& volume,
    const ExportRequest& onSlices, const ExportRequest& repaired);

/// What was drawn where no image is, in sentences: on slices that were filled in, and beside what
/// was scanned. A segment each; empty where there is none.
[[nodiscard]] QStringList beyondSlices(
    const WayBack& back, const Volume& volume, const ExportRequest& repaired);

} // namespace core
