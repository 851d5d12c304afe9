// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/export/common/SegmentStatistics.h"

#include <QByteArray>
#include <QString>

namespace core {

/// One number of a segment's statistics, with its name in both text formats.
struct StatisticsNumber {
    const char* name = ""; ///< "volumeMl"
    double value = 0.0;
};

/// Makes a text safe for a table that may be opened as a spreadsheet. A text that begins like a
/// formula (=, +, -, @), even behind apostrophes, gets an apostrophe in front.
[[nodiscard]] QString noFormula(const QString& text);

/// All numbers, in the order of the columns. Those about changes since an import come last, and
/// only for a segment that was imported.
[[nodiscard]] std::vector<StatisticsNumber> numbersOf(const SegmentStatistics& statistics);

/// RFC 4180, UTF-8: a line of names, then one line per segment; texts by noFormula(). Where the
/// source does not state the spacing, volumes, surfaces, diameters and sphericity are empty, and
/// are not in JSON.
[[nodiscard]] QByteArray statisticsCsv(
    const std::vector<SegmentStatistics>& all, const Volume& volume);

/// {"study", "unit", "segments": [{"label", "name", "code", "voxels", …}]}; of a series in time the
/// study also has "pointInTime", from 1, and "pointsInTime". @p identity is that of the study in
/// the form that may be written.
[[nodiscard]] QByteArray statisticsJson(
    const std::vector<SegmentStatistics>& all, const Volume& volume, const StudyIdentity& identity);

/// The name of the SEG to which a report refers and which is written beside it: "a-seg.dcm".
[[nodiscard]] QString segBeside(const QString& file);

} // namespace core
