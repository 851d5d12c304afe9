// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/export/common/SegmentStatistics.h"
#include "core/history/History.h"

#include <QByteArray>

#include <vector>

namespace ui {

/// What an audit report says of the segments as they are: the size of each, and what was changed in
/// those that were imported, for example from a network.
struct AuditSegments {
    struct One {
        core::SegmentStatistics measured;
        /// PNG of the slice with the most changes (ChangePicture.h). Empty if nothing was changed
        /// or the segment was not imported.
        QByteArray changes;
        int slice = 0; ///< slice of that picture, counted from 0
    };
    bool areUnknown = false; ///< the study could not be read, so nothing was measured
    /// The study does not say how large its voxels are: they are counted, and no volume is stated.
    bool areCounted = false;
    core::RowId position = 0; ///< the row of the history after which they were measured
    /// First those with voxels, then those without: of these nothing is measured but what was taken
    /// since their import.
    std::vector<One> segments;
};

/// Measures the segments. Any thread. Cost: that of the statistics (SegmentStatistics.h). Errors:
/// UnknownSegment (its label plane is missing), Cancelled.
/// @param request with segments, label planes, the codes of the volume and what was imported
[[nodiscard]] core::Result<AuditSegments> auditSegments(
    const core::Volume& volume, const core::ExportRequest& request, const core::Progress& progress);

} // namespace ui
