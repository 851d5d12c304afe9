// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/LayerToSegment.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/segments/AddSegment.h"

namespace core {

using namespace rowWords;

Result<void> check(const LayerToSegment& edit, const Document& document)
{
    if (const Result<void> isRoom = checkNewSegment(edit.target, document); !isRoom)
        return isRoom;
    return discardValue(labelCarved(edit, document));
}

Result<bool> apply(const LayerToSegment& edit, Document& document)
{
    return addNewSegment(edit.target, document);
}

EditEffects effects(const LayerToSegment& edit)
{
    return effectsOn(edit.target, engineTask<LayerToSegment>(), namesPlaces(edit.editable));
}

Result<LabelCarved> labelCarved(const LayerToSegment& edit, const Document& document)
{
    if (!document.layer(edit.layer))
        return failure(ErrorCode::InvalidField, QStringLiteral("layerToSegment.layer"),
            Clause::saying("there is no sculpt layer %1", edit.layer));
    Result<LabelTarget> target = labelTarget(edit.target, edit.overwriteUnlocked, document);
    if (!target)
        return tl::unexpected(target.error());
    return keepingTo(edit.editable, document, "layerToSegment",
        LabelCarved{.target = *target, .layer = std::uint8_t(edit.layer)});
}

Result<EngineEdit> engineEdit(const LayerToSegment& edit, const Document& document)
{
    return engineEditFrom(labelCarved(edit, document));
}

RowTitle rowTitle(const LayerToSegment& edit, const RowFacts& row)
{
    return {.code = RowTitleCode::LayerToSegment,
        .arguments = {layerName(edit.layer, row.document), targetName(edit.target, row.document)},
        .then = {figure(RowTitleCode::VoxelsGained, row.statistics.voxelsChanged)}};
}

/// The coverage of the layer, and the labels and seed words of the segment's plane, since what
/// other segments held decided too.
EditDependencies dependencies(const LayerToSegment& edit, const DependencyFacts& row)
{
    dependsOn::Fields fields{.plane = row.planeOf(edit.target.segment.value_or(0)), .layers = {}};
    fields.layers.set(std::size_t(edit.layer));
    return row.alsoReading(edit.editable, fields);
}

} // namespace core
