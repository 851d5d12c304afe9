// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/delta/EditStatistics.h"
#include "core/edits/answers/RowWords.h"
#include "core/edits/kinds/parts/PenSample.h"
#include "core/sculpt/DrillCut.h"
#include "core/titles/RowTitle.h"

#include <algorithm>
#include <cmath>

namespace core {

// Names of rows of drill and laser strokes.

template <class Stroke> [[nodiscard]] double deepestMm(const Stroke& stroke)
{
    double pressure = 0.0;
    for (const PenSample& sample : stroke.samples)
        pressure = std::max(pressure, sample.pressure);
    return stroke.depthMm * std::pow(pressure, stroke.pressureExponent);
}

/// Title codes of a tool: for cuts of a given depth, and for mode Rate, where the depth is per
/// second.
struct PressedCodes {
    RowTitleCode carve;
    RowTitleCode carveByRate;
    RowTitleCode restore;
    RowTitleCode restoreByRate;
};

/// "Drill 6.2 mm, 214 bricks". @param codes of the tool
template <class Stroke>
[[nodiscard]] RowTitle pressedTitle(
    const Stroke& stroke, const PressedCodes& codes, const EditStatistics& statistics)
{
    const bool byRate = stroke.mode == DrillMode::Rate;
    return {.code = stroke.restore ? (byRate ? codes.restoreByRate : codes.restore)
                                   : (byRate ? codes.carveByRate : codes.carve),
        .arguments = {inMm(deepestMm(stroke))},
        .then = {rowWords::figure(RowTitleCode::Bricks, statistics.bricks)}};
}

} // namespace core
