// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/history/ReviseStroke.h"

#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/EditReach.h"
#include "core/edits/answers/RowFacts.h"

namespace core {

using namespace rowWords;

/// It reads the history, not the document.
Result<void> check(const ReviseStroke&, const Document&)
{
    return {};
}

Result<bool> apply(const ReviseStroke&, Document&)
{
    return false;
}

EditEffects effects(const ReviseStroke&)
{
    return {.task = EditTask::History, .standsOpen = false, .boundToStudy = true};
}

QString rowName(const ReviseStroke& edit, const RowFacts& row)
{
    const StrokeParameters drawn = row.past.cutOf(edit.row);
    const QString title = QLatin1Char('\'') + row.past.titleOf(edit.row) + QLatin1Char('\'');
    QString what;
    if (edit.removed) {
        what = QStringLiteral("Remove ") + title;
    } else {
        const auto mm = [](double value) { return QString::number(value, 'f', 1); };
        QStringList changes;
        if (edit.radiusMm)
            changes +=
                QStringLiteral("radius %1 → %2 mm").arg(mm(*drawn.radiusMm), mm(*edit.radiusMm));
        if (edit.sideMm)
            changes += QStringLiteral("side %1 → %2 mm").arg(mm(*drawn.sideMm), mm(*edit.sideMm));
        if (edit.widthMm)
            changes +=
                QStringLiteral("width %1 → %2 mm").arg(mm(*drawn.widthMm), mm(*edit.widthMm));
        if (edit.heightMm)
            changes +=
                QStringLiteral("height %1 → %2 mm").arg(mm(*drawn.heightMm), mm(*edit.heightMm));
        if (edit.factor)
            changes += QStringLiteral("outline × %1").arg(QString::number(*edit.factor, 'g', 4));
        if (edit.depthMm)
            changes +=
                QStringLiteral("depth %1 → %2 mm").arg(mm(*drawn.depthMm), mm(*edit.depthMm));
        if (edit.softnessMm)
            changes += QStringLiteral("soft edge %1 → %2 mm")
                           .arg(mm(*drawn.softnessMm), mm(*edit.softnessMm));
        if (edit.layer)
            changes += QStringLiteral("layer %1 → %2").arg(drawn.layer).arg(*edit.layer);
        if (edit.throughGaps)
            changes += *edit.throughGaps ? QStringLiteral("through gaps")
                                         : QStringLiteral("stopping at gaps");
        what = QStringLiteral("Revise ") + title + QStringLiteral(": ")
            + (changes.isEmpty() ? QStringLiteral("as it was drawn")
                                 : changes.join(QStringLiteral(" and ")));
    }
    return what + QStringLiteral(", ") + counted(row.statistics.voxelsChanged, "voxel");
}

/// The bricks that it wrote. It also folds in what lay hidden there, which RevertOperation looks
/// after.
EditReach reach(const ReviseStroke&, const ReachFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core
