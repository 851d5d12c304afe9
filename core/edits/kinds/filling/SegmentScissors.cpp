// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/filling/SegmentScissors.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/CutFrames.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/sculpt/OutlinedPlane.h"
#include "core/sculpt/labels/LabelScissors.h"

#include <algorithm>
#include <utility>

namespace core {

using namespace rowWords;

namespace {

tl::unexpected<Error> scissorsFailure(const char* field, const Clause& reason)
{
    return failure(ErrorCode::InvalidField,
        QStringLiteral("segmentScissors.%1").arg(QLatin1String(field)), reason);
}

/// The curve on the plane of the cut, without what is to be done under it. Errors: InvalidField.
Result<LabelScissors> underCurve(const SegmentScissors& edit, const Document& document)
{
    Result<OutlinedPlane> plane = outlinedPlane(edit.polygonMm,
        {.view = edit.view, .maxDepthMm = edit.depthMm.value_or(0.0), .hidden = edit.hidden},
        document, QStringLiteral("segmentScissors"));
    if (!plane)
        return tl::unexpected(plane.error());
    LabelScissors scissors{.outside = edit.outside,
        .fromSurface = edit.depthMm.has_value(),
        .frame = std::move(plane->frame)};
    scissors.mask = std::move(plane->mask);
    return scissors;
}

/// The labels that are erased. Errors: UnknownSegment, SegmentLocked, InvalidField.
Result<std::bitset<256>> erasedLabels(
    const SegmentScissors& edit, const Segment& segment, const Document& document)
{
    std::bitset<256> labels;
    labels.set(segment.label);
    for (const int label : edit.others.value_or(std::vector<int>())) {
        const Result<const Segment*> other =
            unlockedSegment("segmentScissors.others", label, document);
        if (!other)
            return tl::unexpected(other.error());
        if (label == edit.segment)
            return scissorsFailure("others", Clause::saying("names the segment itself"));
        if ((*other)->plane != segment.plane)
            return scissorsFailure("others",
                Clause::saying("segment %1 lies on another label plane than the segment", label));
        labels.set((*other)->label);
    }
    return labels;
}

} // namespace

Result<void> check(const SegmentScissors& edit, const Document& document)
{
    return discardValue(labelScissors(edit, document));
}

Result<bool> apply(const SegmentScissors&, Document&)
{
    return false;
}

EditEffects effects(const SegmentScissors& edit)
{
    return {.task = engineTask<SegmentScissors>(),
        .standsOpen = false,
        .writesTo = edit.segment,
        .fills = {.label = edit.erase ? std::nullopt : std::optional(edit.segment)},
        .boundToStudy = true};
}

Result<LabelScissors> labelScissors(const SegmentScissors& edit, const Document& document)
{
    const Result<const Segment*> segment =
        unlockedSegment("segmentScissors.segment", edit.segment, document);
    if (!segment)
        return tl::unexpected(segment.error());
    const Result<CodeInterval> codes = codesBetween(QStringLiteral("segmentScissors"), edit.lower,
        edit.upper, document.volumes.front().encoding);
    if (!codes)
        return tl::unexpected(codes.error());
    if (edit.others && !edit.erase)
        return scissorsFailure("others", Clause::saying("has no meaning while filling"));
    if (edit.depthMm && edit.outside)
        return scissorsFailure("depthMm", Clause::saying("has no meaning outside of the curve"));
    Result<LabelScissors> scissors = underCurve(edit, document);
    if (!scissors)
        return scissors;
    scissors->target.plane = (*segment)->plane;
    if (edit.erase) {
        const Result<std::bitset<256>> erased = erasedLabels(edit, **segment, document);
        if (!erased)
            return tl::unexpected(erased.error());
        scissors->erased = *erased;
    } else {
        scissors->target.label = std::uint8_t((*segment)->label);
        if (edit.overwriteUnlocked)
            scissors->target.overwritable = document.unlockedLabels((*segment)->plane);
    }
    scissors->lowCode = codes->low;
    scissors->highCode = codes->high;
    return keepingTo(edit.editable, document, "segmentScissors", *std::move(scissors));
}

Result<EngineEdit> engineEdit(const SegmentScissors& edit, const Document& document)
{
    return engineEditFrom(labelScissors(edit, document));
}

/// "Scissors erase 'Liver' inside, 12.0 mm deep, −214 voxels".
RowTitle rowTitle(const SegmentScissors& edit, const RowFacts& row)
{
    RowTitle title{
        .code = edit.outside ? RowTitleCode::ScissorsFillOutside : RowTitleCode::ScissorsFill,
        .arguments = {segmentName(edit.segment, row.document)}};
    const bool hasOthers = edit.others && !edit.others->empty();
    if (edit.erase && hasOthers) {
        title.code =
            edit.outside ? RowTitleCode::ScissorsEraseManyOutside : RowTitleCode::ScissorsEraseMany;
        title.arguments = {TitleCount{std::int64_t(edit.others->size()) + 1}};
    } else if (edit.erase) {
        title.code =
            edit.outside ? RowTitleCode::ScissorsEraseOutside : RowTitleCode::ScissorsErase;
    }
    if (edit.depthMm)
        title.then.push_back(
            {.code = RowTitleCode::MillimetresDeep, .arguments = {inMm(*edit.depthMm)}});
    title.then.push_back(voxelsOrSeedsLost(edit.erase, row));
    return title;
}

/// The labels and seed words of all bricks under the curve, including those in front of what was
/// changed, where the lines of sight met nothing.
EditDependencies dependencies(const SegmentScissors& edit, const DependencyFacts& row)
{
    const Result<LabelScissors> scissors = underCurve(edit, row.document);
    if (!scissors)
        return row.whatWasWritten();
    if (edit.outside)
        return row.alsoReading(edit.editable, dependsOn::Plane{.plane = row.planeOf(edit.segment)});
    const std::vector<std::uint32_t> near = bricksNear(*scissors, row.grid());
    return row.alsoReading(edit.editable,
        row.labelled(std::set<std::uint32_t>(near.begin(), near.end()), row.planeOf(edit.segment)));
}

} // namespace core
