// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/values/ThresholdSegment.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/BoxVoxels.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/parts/SegmentChoice.h"
#include "core/edits/open/OpenPreview.h"
#include "core/sculpt/labels/LabelThreshold.h"

#include <utility>

namespace core {

using namespace rowWords;

namespace {

LabelThreshold::How howOf(ThresholdSegment::Mode mode)
{
    switch (mode) {
    case ThresholdSegment::Mode::Replace:
        break;
    case ThresholdSegment::Mode::Add:
        return LabelThreshold::How::Add;
    case ThresholdSegment::Mode::Subtract:
        return LabelThreshold::How::Subtract;
    }
    return LabelThreshold::How::Replace;
}

RowTitleCode codeOf(ThresholdSegment::Mode mode)
{
    switch (mode) {
    case ThresholdSegment::Mode::Replace:
        break;
    case ThresholdSegment::Mode::Add:
        return RowTitleCode::ThresholdAdd;
    case ThresholdSegment::Mode::Subtract:
        return RowTitleCode::ThresholdSubtract;
    }
    return RowTitleCode::ThresholdReplace;
}

/// "300 … 3071 HU"; an end that is not given is the volume's.
RowTitle rangeTitle(const ThresholdSegment& edit, const Volume& volume)
{
    RowTitle title{.code = RowTitleCode::Range,
        .arguments = {TitleDigits{edit.lower.value_or(volume.minimum)},
            TitleDigits{edit.upper.value_or(volume.maximum)}}};
    if (!volume.unit.isEmpty()) {
        title.code = RowTitleCode::RangeInUnit;
        title.arguments.push_back(volume.unit);
    }
    return title;
}

} // namespace

Result<void> check(const ThresholdSegment& edit, const Document& document)
{
    return discardValue(labelThreshold(edit, document));
}

Result<bool> apply(const ThresholdSegment&, Document&)
{
    return false;
}

EditEffects effects(const ThresholdSegment& edit)
{
    const bool gives = edit.mode != ThresholdSegment::Mode::Subtract;
    return {.task = engineTask<ThresholdSegment>(),
        .standsOpen = opens<ThresholdSegment>(),
        .writesTo = edit.segment,
        .fills = {.label = gives ? std::optional(edit.segment) : std::nullopt},
        .boundToStudy = edit.box.has_value() || namesPlaces(edit.editable)};
}

Result<LabelThreshold> labelThreshold(const ThresholdSegment& edit, const Document& document)
{
    const Volume& volume = document.volumes.front();
    const Result<CodeInterval> codes =
        codesBetween(QStringLiteral("thresholdSegment"), edit.lower, edit.upper, volume.encoding);
    if (!codes)
        return tl::unexpected(codes.error());
    Result<LabelTarget> target = segmentTarget(edit.segment, edit.overwriteUnlocked, document);
    if (!target)
        return tl::unexpected(target.error());
    LabelThreshold threshold{.target = *std::move(target),
        .how = howOf(edit.mode),
        .lowCode = codes->low,
        .highCode = codes->high,
        .onlyVisible = edit.onlyVisible};
    if (edit.box) {
        const Result<VoxelSpan> span =
            voxelsOf(*edit.box, volume.geometry, QStringLiteral("thresholdSegment.box"));
        if (!span)
            return tl::unexpected(span.error());
        threshold.box = VoxelBox{span->from, span->to + 1};
    }
    return keepingTo(edit.editable, document, "thresholdSegment", std::move(threshold));
}

Result<EngineEdit> engineEdit(const ThresholdSegment& edit, const Document& document)
{
    return engineEditFrom(labelThreshold(edit, document));
}

std::unique_ptr<OpenStroke> openStroke(ThresholdSegment&)
{
    return std::make_unique<OpenPreview>();
}

RowTitle rowTitle(const ThresholdSegment& edit, const RowFacts& row)
{
    const LabelFlow flow = row.flowOf(edit.segment);
    RowTitle title{.code = codeOf(edit.mode),
        .arguments = {segmentName(edit.segment, row.document),
            asArgument(rangeTitle(edit, row.document.volumes.front()))},
        .then = {flowTitle(flow.gained, flow.lost)}};
    // If only seeds were removed, no label has changed.
    if (row.statistics.voxelsChanged == 0)
        title.then = {figure(RowTitleCode::SeedVoxelsLost, row.facts.seedWordsChanged)};
    return title;
}

/// The labels of other segments and the seed words decide, too; and coverage, if only visible
/// voxels count.
EditDependencies dependencies(const ThresholdSegment& edit, const DependencyFacts& row)
{
    if (!edit.onlyVisible)
        return row.alsoReading(edit.editable, dependsOn::Plane{.plane = row.planeOf(edit.segment)});
    dependsOn::Fields fields{.plane = row.planeOf(edit.segment), .layers = {}};
    fields.layers.set();
    return row.alsoReading(edit.editable, fields);
}

} // namespace core
