// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/export/common/ExportMask.h"

#include <QString>
#include <QStringList>

namespace ui {

/// The report of an export in sentences of the user's language.
struct WordedReport {
    QString file;
    QStringList written;
    QStringList checked;
    QStringList cautions; ///< what readers of the file must know
    QString sha256{}; ///< core::ExportReport::sha256
};

[[nodiscard]] QString reportText(const core::ReportLine& line);
[[nodiscard]] QStringList reportTexts(const core::ReportLines& lines);
[[nodiscard]] WordedReport reportTexts(const core::ExportReport& report);

} // namespace ui
