// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/EngineEdits.h"

#include "core/edits/kinds/parts/SegmentChoice.h"

namespace core {

Result<LabelTarget> labelTarget(
    const SegmentChoice& choice, bool overwriteUnlocked, const Document& document)
{
    LabelTarget target;
    if (choice.segment) {
        const Segment* segment = document.segment(*choice.segment);
        if (!segment)
            return failure(ErrorCode::UnknownSegment, QString::number(*choice.segment));
        if (segment->locked)
            return failure(ErrorCode::SegmentLocked, segment->name);
        target.plane = segment->plane;
        target.label = segment->label;
    } else {
        target.label = std::uint8_t(document.lastLabelGiven() + 1);
    }
    if (overwriteUnlocked)
        target.overwritable = document.unlockedLabels(target.plane);
    return target;
}

Result<LabelTarget> segmentTarget(int label, bool overwriteUnlocked, const Document& document)
{
    return labelTarget({.segment = label, .name = {}}, overwriteUnlocked, document);
}

} // namespace core
