// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/export/common/SegmentStatistics.h"

#include <QByteArray>

namespace core {

/// One number of a segment's statistics, as both texts name it.
struct StatisticsNumber {
    const char* name = ""; ///< "volumeMl"
    double value = 0.0;
};

/// All of them, in the order of the columns.
[[nodiscard]] std::vector<StatisticsNumber> numbersOf(const SegmentStatistics& statistics);

/// RFC 4180, UTF-8: a line of names, then a line a segment.
[[nodiscard]] QByteArray statisticsCsv(
    const std::vector<SegmentStatistics>& all, const Volume& volume);

/// {"study", "unit", "segments": [{"label", "name", "code", "voxels", …}]}; @p identity is that of
/// the study as it may be named.
[[nodiscard]] QByteArray statisticsJson(
    const std::vector<SegmentStatistics>& all, const Volume& volume, const StudyIdentity& identity);

/// The SEG that a report speaks of lies beside it under this name: "a-seg.dcm".
[[nodiscard]] QString segBeside(const QString& file);

} // namespace core
