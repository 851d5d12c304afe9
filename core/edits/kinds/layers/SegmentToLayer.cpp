// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/layers/SegmentToLayer.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EngineEdits.h"

namespace core {

using namespace rowWords;

Result<void> check(const SegmentToLayer& edit, const Document& document)
{
    if (const Result<void> checked = checkLayer("segmentToLayer.layer", edit.layer, document);
        !checked)
        return checked;
    return discardValue(coverLabel(edit, document));
}

Result<bool> apply(const SegmentToLayer&, Document&)
{
    return false;
}

EditEffects effects(const SegmentToLayer&)
{
    return {.task = engineTask<SegmentToLayer>(), .standsOpen = false, .fills = fillsNothing};
}

Result<CoverLabel> coverLabel(const SegmentToLayer& edit, const Document& document)
{
    const Segment* segment = document.segment(edit.segment);
    if (!segment)
        return failure(ErrorCode::UnknownSegment, QString::number(edit.segment),
            Clause::saying("in field 'segmentToLayer.segment'"));
    CoverLabel cover{.layer = std::uint8_t(edit.layer),
        .plane = segment->plane,
        .label = segment->label,
        .outside = edit.outside.value_or(false)};
    if (!cover.outside && segment->uncarvable)
        return failure(ErrorCode::SegmentProtected, segment->name);
    for (const Segment& each : document.segments) {
        if (!each.uncarvable)
            continue;
        if (each.plane != segment->plane) // they may share voxels
            return failure(ErrorCode::SegmentProtected, each.name);
        if (cover.outside)
            cover.protectedLabels.set(each.label);
    }
    return cover;
}

Result<EngineEdit> engineEdit(const SegmentToLayer& edit, const Document& document)
{
    return engineEditFrom(coverLabel(edit, document));
}

RowTitle rowTitle(const SegmentToLayer& edit, const RowFacts& row)
{
    return {.code = edit.outside.value_or(false) ? RowTitleCode::OutsideToLayer
                                                 : RowTitleCode::SegmentToLayer,
        .arguments = {segmentName(edit.segment, row.document), layerName(edit.layer, row.document)},
        .then = {figure(RowTitleCode::Voxels, row.statistics.voxelsChanged)}};
}

/// The labels and seed words of the segment's plane, and the layer's coverage.
EditDependencies dependencies(const SegmentToLayer& edit, const DependencyFacts& row)
{
    dependsOn::Fields fields{.plane = row.planeOf(edit.segment), .layers = {}};
    fields.layers.set(std::size_t(edit.layer));
    return fields;
}

} // namespace core
