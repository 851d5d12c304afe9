// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/export/common/SegmentStatistics.h"
#include "core/history/History.h"

#include <QByteArray>
#include <QStringList>

#include <vector>

namespace ui {

/// What an audit report says of the segments as they stand: how large each is, and what was changed
/// in those that were imported, a network's for instance.
struct AuditSegments {
    struct One {
        core::SegmentStatistics measured;
        /// PNG of the slice with the most changes (ChangePicture.h); empty: none were made, or the
        /// segment was not imported.
        QByteArray changes;
        int slice = 0; ///< of that picture, 0-based
    };
    bool areUnknown = false; ///< the study cannot be read
    core::RowId position = 0; ///< after which step they stand so
    std::vector<One> segments; ///< those with voxels
    QStringList empty; ///< names of those without
};

/// Measures them. Cost: that of the statistics (SegmentStatistics.h). Any thread. Errors:
/// UnknownSegment (its plane is missing), Cancelled.
/// @param request with segments, planes, the codes of the volume and what was imported
[[nodiscard]] core::Result<AuditSegments> auditSegments(
    const core::Volume& volume, const core::ExportRequest& request, const core::Progress& progress);

} // namespace ui
