// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/GuardedLabels.h"

#include "core/edits/engine/SegmentProtection.h"

namespace core {

LabelGuard carvingGuard(const Document& document)
{
    ProtectedSegments all;
    addProtected(all, document);
    return {.uncarved = protectedLabelsOf(all, document)};
}

LabelGuard fullGuard(const Document& document)
{
    LabelGuard guard = carvingGuard(document);
    for (const Segment& segment : document.segments)
        guard.kept.set(segment.label, segment.locked);
    return guard;
}

Error withSegmentName(const Error& error, const Document& document)
{
    if (error.code != ErrorCode::SegmentLocked && error.code != ErrorCode::SegmentProtected)
        return error;
    const Segment* segment = document.segment(error.arguments.value(0).toInt());
    return segment ? Error{error.code, {segment->name}} : error;
}

} // namespace core
