// SPDX-License-Identifier: Apache-2.0
#include "core/history/StandingStrokes.h"

#include "core/edits/kinds/history/ReviseStroke.h"

#include <algorithm>

namespace core {

namespace {

/// By a row of the history, so that it can be.
SculptEdit asRevised(const History& history, const ReviseStroke& revise)
{
    return revised(*sculptEdit(history.row(revise.row).edit), revise).value();
}

} // namespace

bool StandingStroke::operator==(const StandingStroke& other) const
{
    // The row is where it was drawn, and a revision changes nothing but its parameters.
    return row == other.row && removed == other.removed
        && parametersOf(form) == parametersOf(other.form);
}

std::vector<StandingStroke> standingStrokes(const History& history, RowId at)
{
    std::vector<StandingStroke> strokes;
    for (const RowId id : history.standing(at)) {
        const Edit& edit = history.row(id).edit;
        if (std::optional<SculptEdit> sculpted = sculptEdit(edit)) {
            strokes.push_back({.row = id, .form = *std::move(sculpted), .removed = false});
        } else if (const auto* revise = edit.as<ReviseStroke>()) {
            const auto found = std::find_if(strokes.begin(), strokes.end(),
                [revise](const StandingStroke& stroke) { return stroke.row == revise->row; });
            if (found == strokes.end())
                continue;
            found->form = asRevised(history, *revise);
            found->removed = revise->removed;
        }
    }
    return strokes;
}

std::vector<SculptEdit> formsOf(const History& history, RowId row)
{
    std::optional<SculptEdit> drawn = sculptEdit(history.row(row).edit);
    if (!drawn)
        return {};
    std::vector<SculptEdit> forms{*std::move(drawn)};
    for (const RowId id : history.pathTo(history.position())) {
        const auto* revise = history.row(id).edit.as<ReviseStroke>();
        if (revise && revise->row == row && !revise->removed)
            forms.push_back(asRevised(history, *revise));
    }
    return forms;
}

bool canBeTaken(const History& history, RowId cut)
{
    int layer = 0;
    for (const StandingStroke& stroke : standingStrokes(history, history.position())) {
        if (stroke.row == cut) {
            if (stroke.removed || restores(stroke.form))
                return false;
            layer = layerOf(stroke.form);
        } else if (layer != 0 && !stroke.removed && layer == layerOf(stroke.form)
            && restores(stroke.form)) {
            return false;
        }
    }
    const std::vector<RowId> rows = history.standing();
    return layer != 0 && std::none_of(rows.begin(), rows.end(), [&](RowId row) {
        return row > cut && writesLayer(history.row(row).edit, layer);
    });
}

RowId lastPartialCut(const History& history, int layer)
{
    RowId last = 0;
    bool others = false;
    for (const StandingStroke& stroke : standingStrokes(history, history.position())) {
        if (stroke.removed || layerOf(stroke.form) != layer || restores(stroke.form))
            continue;
        others = others || last != 0;
        last = stroke.row;
    }
    const std::vector<RowId> rows = history.standing();
    others = others || std::any_of(rows.begin(), rows.end(), [&](RowId row) {
        return writesLayer(history.row(row).edit, layer);
    });
    return others && canBeTaken(history, last) ? last : 0;
}

} // namespace core
