// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"
#include "core/export/common/ExportMask.h"
#include "core/repair/WayBack.h"

#include <QString>

namespace core {

/// Follows every voxel of every slice, by its position in mm, into the repaired volume, without any
/// code of WayBack, and compares the labels of both.
/// @param onSlices the labels that were transferred back
/// @param repaired the labels as drawn
/// @return the difference, as a clause; empty if there is none
[[nodiscard]] Clause differenceOfWayBack(const WayBack& back, const Volume& volume,
    const ExportRequest& onSlices, const ExportRequest& repaired);

/// Sentences on what was drawn where there is no image: on interpolated slices, and outside the
/// scanned region. One for each segment; empty if there is nothing.
[[nodiscard]] ReportLines beyondSlices(
    const WayBack& back, const Volume& volume, const ExportRequest& repaired);

} // namespace core
