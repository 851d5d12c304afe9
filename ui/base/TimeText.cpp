// SPDX-License-Identifier: Apache-2.0
#include "ui/base/TimeText.h"

#include "ui/texts/ClauseText.h"

#include <QObject>

namespace ui {

QString timeText(const core::Volume& volume)
{
    if (!volume.alternatives || volume.alternatives->times.size() < 2)
        return {};
    const core::SeriesAlternatives& series = *volume.alternatives;
    const QString point =
        QObject::tr("point %1 of %2").arg(series.time + 1).arg(series.times.size());
    const QString label = clauseText(series.times.value(series.time));
    return label.isEmpty() ? point : point + QStringLiteral(" · ") + label;
}

} // namespace ui
