// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/EngineEdits.h"

#include "core/edits/kinds/layers/MergeLayers.h"
#include "core/edits/kinds/layers/RemoveLayer.h"
#include "core/edits/kinds/layers/SegmentToLayer.h"

namespace core {

Result<CoverLabel> coverLabel(const SegmentToLayer& edit, const Document& document)
{
    const Segment* segment = document.segment(edit.segment);
    if (!segment)
        return failure(ErrorCode::UnknownSegment, QString::number(edit.segment),
            QStringLiteral("in field 'segmentToLayer.segment'"));
    if (segment->uncarvable)
        return failure(ErrorCode::SegmentProtected, segment->name);
    return CoverLabel{
        .layer = std::uint8_t(edit.layer), .plane = segment->plane, .label = segment->label};
}

FoldLayer foldLayer(const RemoveLayer& edit)
{
    return {.layer = std::uint8_t(edit.layer), .into = {}};
}

FoldLayer foldLayer(const MergeLayers& edit)
{
    return {.layer = std::uint8_t(edit.from), .into = std::uint8_t(edit.into)};
}

} // namespace core
