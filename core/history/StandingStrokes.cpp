// SPDX-License-Identifier: Apache-2.0
#include "core/history/StandingStrokes.h"

#include <algorithm>

namespace core {

bool StandingStroke::operator==(const StandingStroke& other) const
{
    if (row != other.row || removed != other.removed)
        return false;
    const DrillStroke* one = drill();
    const DrillStroke* two = other.drill();
    // A revision changes nothing else, and no other cut.
    return !one || !two
        || (one->mask == two->mask && one->depthMm == two->depthMm && one->layer == two->layer
            && one->throughGaps == two->throughGaps);
}

std::vector<StandingStroke> standingStrokes(const History& history, RowId at)
{
    std::vector<StandingStroke> strokes;
    for (const RowId id : history.standing(at)) {
        const Edit& edit = history.row(id).edit;
        if (std::optional<SculptEdit> sculpted = sculptEdit(edit)) {
            strokes.push_back({.row = id, .form = *std::move(sculpted), .removed = false});
        } else if (const auto* revise = std::get_if<ReviseStroke>(&edit)) {
            const auto found = std::find_if(strokes.begin(), strokes.end(),
                [revise](const StandingStroke& stroke) { return stroke.row == revise->row; });
            if (found == strokes.end())
                continue;
            found->form = revised(std::get<DrillStroke>(history.row(revise->row).edit), *revise);
            found->removed = revise->removed;
        }
    }
    return strokes;
}

DrillStroke revised(DrillStroke stroke, const ReviseStroke& edit)
{
    stroke.mask.radiusMm = edit.radiusMm.value_or(stroke.mask.radiusMm);
    stroke.depthMm = edit.depthMm.value_or(stroke.depthMm);
    stroke.layer = edit.layer.value_or(stroke.layer);
    stroke.throughGaps = edit.throughGaps.value_or(stroke.throughGaps);
    return stroke;
}

std::vector<DrillStroke> formsOf(const History& history, RowId row)
{
    const auto* drawn = std::get_if<DrillStroke>(&history.row(row).edit);
    if (!drawn)
        return {};
    std::vector<DrillStroke> forms{*drawn};
    for (const RowId id : history.pathTo(history.position())) {
        const auto* revise = std::get_if<ReviseStroke>(&history.row(id).edit);
        if (revise && revise->row == row && !revise->removed)
            forms.push_back(revised(*drawn, *revise));
    }
    return forms;
}

} // namespace core
