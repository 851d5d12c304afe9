// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/delta/EditStatistics.h"
#include "core/edits/answers/RowWords.h"
#include "core/edits/kinds/sculpt/PenSample.h"
#include "core/sculpt/DrillCut.h"

#include <QString>

#include <algorithm>
#include <array>
#include <cmath>

namespace core {

// Names of rows of drill and laser.

template <class Stroke> [[nodiscard]] double deepestMm(const Stroke& stroke)
{
    double pressure = 0.0;
    for (const PenSample& sample : stroke.samples)
        pressure = std::max(pressure, sample.pressure);
    return stroke.depthMm * std::pow(pressure, stroke.pressureExponent);
}

/// "Drill 6.2 mm, 214 bricks"; @param verbs carving and restoring
template <class Stroke>
[[nodiscard]] QString pressedName(
    const Stroke& stroke, const std::array<const char*, 2>& verbs, const EditStatistics& statistics)
{
    const QString depth = QString::number(deepestMm(stroke), 'f', 1);
    return QLatin1String(verbs[stroke.restore ? 1 : 0])
        + (stroke.mode == DrillMode::Rate ? QStringLiteral("%1 mm/s, ") : QStringLiteral("%1 mm, "))
              .arg(depth)
        + rowWords::counted(statistics.bricks, "brick");
}

} // namespace core
