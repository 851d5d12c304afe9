// SPDX-License-Identifier: Apache-2.0
#include "core/session/questions/SegmentsAt.h"

#include <algorithm>
#include <functional>

namespace core {

namespace {

const Segment* withLabel(const std::vector<const Segment*>& segments, int label)
{
    const auto found = std::find_if(segments.begin(), segments.end(),
        [label](const Segment* segment) { return segment->label == label; });
    return found == segments.end() ? nullptr : *found;
}

/// Those that are shown; all, if none is.
std::vector<const Segment*> candidates(std::vector<const Segment*> segments)
{
    const auto isShown = [](const Segment* segment) { return segment->visible; };
    if (std::any_of(segments.begin(), segments.end(), isShown))
        std::erase_if(segments, std::not_fn(isShown));
    return segments;
}

} // namespace

std::vector<const Segment*> segmentsAt(const Document& document, const ProbedVoxel& voxel)
{
    std::vector<const Segment*> segments;
    for (const std::uint8_t label : voxel.labels) {
        if (const Segment* segment = label != 0 ? document.segment(label) : nullptr)
            segments.push_back(segment);
    }
    return segments;
}

const Segment* segmentMeant(const Document& document, const ProbedVoxel& voxel, int active)
{
    const std::vector<const Segment*> segments = segmentsAt(document, voxel);
    if (const Segment* segment = withLabel(segments, active))
        return segment;
    return segments.empty() ? nullptr : candidates(segments).back();
}

const Segment* segmentNext(const Document& document, const ProbedVoxel& voxel, int active)
{
    const Segment* meant = segmentMeant(document, voxel, active);
    if (!meant || meant->label != active)
        return meant;
    const std::vector<const Segment*> shown = candidates(segmentsAt(document, voxel));
    const auto lower = std::find_if(shown.rbegin(), shown.rend(),
        [meant](const Segment* segment) { return segment->plane < meant->plane; });
    return lower != shown.rend() ? *lower : shown.back();
}

} // namespace core
