// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/history/ReviseStroke.h"

#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/answers/RowUse.h"

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
    return {.task = EditTask::History,
        .standsOpen = false,
        .fills = fillsNothing,
        .boundToStudy = true};
}

namespace {

RowTitle fromTo(RowTitleCode code, double from, double to)
{
    return {.code = code, .arguments = {inMm(from), inMm(to)}};
}

/// What is different from how it was drawn.
std::vector<RowTitle> changesOf(const ReviseStroke& edit, const StrokeParameters& drawn)
{
    std::vector<RowTitle> changes;
    if (edit.radiusMm)
        changes.push_back(fromTo(RowTitleCode::RadiusTo, *drawn.radiusMm, *edit.radiusMm));
    if (edit.sideMm)
        changes.push_back(fromTo(RowTitleCode::SideTo, *drawn.sideMm, *edit.sideMm));
    if (edit.widthMm)
        changes.push_back(fromTo(RowTitleCode::WidthTo, *drawn.widthMm, *edit.widthMm));
    if (edit.heightMm)
        changes.push_back(fromTo(RowTitleCode::HeightTo, *drawn.heightMm, *edit.heightMm));
    if (edit.factor)
        changes.push_back({.code = RowTitleCode::OutlineTimes,
            .arguments = {TitleDigits{.value = *edit.factor, .digits = 4}}});
    if (edit.depthMm)
        changes.push_back(fromTo(RowTitleCode::DepthTo, *drawn.depthMm, *edit.depthMm));
    if (edit.softnessMm)
        changes.push_back(fromTo(RowTitleCode::SoftEdgeTo, *drawn.softnessMm, *edit.softnessMm));
    if (edit.layer)
        changes.push_back({.code = RowTitleCode::LayerTo,
            .arguments = {TitleNumber{drawn.layer}, TitleNumber{*edit.layer}}});
    if (edit.throughGaps)
        changes.push_back(
            {.code = *edit.throughGaps ? RowTitleCode::ThroughGaps : RowTitleCode::StoppingAtGaps});
    return changes;
}

} // namespace

RowTitle rowTitle(const ReviseStroke& edit, const RowFacts& row)
{
    const TitleArgument stroke = asArgument(row.past.headlineOf(edit.row));
    RowTitle title{.code = RowTitleCode::RemoveStroke,
        .arguments = {stroke},
        .then = {figure(RowTitleCode::Voxels, row.statistics.voxelsChanged)}};
    if (edit.removed)
        return title;
    const std::vector<RowTitle> changes = changesOf(edit, row.past.cutOf(edit.row));
    title.code = changes.empty() ? RowTitleCode::ReviseAsDrawn : RowTitleCode::ReviseStroke;
    if (!changes.empty())
        title.arguments.push_back(
            asArgument({.code = RowTitleCode::Changes, .arguments = {changes}}));
    return title;
}

/// The bricks that it wrote. It also folds in what lay hidden there, which RevertOperation looks
/// after.
EditDependencies dependencies(const ReviseStroke&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

RowUse rowUse(const ReviseStroke&)
{
    return RowUse::Revises;
}

} // namespace core
