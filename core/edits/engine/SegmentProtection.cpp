// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/SegmentProtection.h"

#include <set>

namespace core {

void addProtected(ProtectedSegments& protectedSegments, const Document& document)
{
    std::set<int> all;
    if (protectedSegments)
        all.insert(protectedSegments->begin(), protectedSegments->end());
    for (const Segment& segment : document.segments) {
        if (segment.uncarvable)
            all.insert(segment.label);
    }
    if (!all.empty())
        protectedSegments.emplace(all.begin(), all.end());
}

ProtectedLabels protectedLabelsOf(
    const ProtectedSegments& protectedSegments, const Document& document)
{
    static_assert(ProtectedLabels::mostPlanes == mostLabelPlanes);
    ProtectedLabels labels;
    if (!protectedSegments)
        return labels;
    labels.planes.reset();
    for (const int label : *protectedSegments) {
        const Segment* segment = document.segment(label);
        labels.labels.set(std::size_t(label));
        if (segment)
            labels.planes.set(segment->plane);
        else
            labels.planes.set(); // the segment was deleted since: its voxels may be in any plane
    }
    return labels;
}

Result<void> checkProtected(
    const ProtectedSegments& protectedSegments, bool restore, const QString& edit)
{
    if (protectedSegments && restore)
        return failure(ErrorCode::InvalidField, edit + QStringLiteral(".spared"),
            Clause::saying("has no meaning while restoring"));
    return {};
}

Result<void> checkProtectedAreThere(
    const ProtectedSegments& protectedSegments, bool restore, const Document& document)
{
    if (restore || !protectedSegments)
        return {};
    for (const int label : *protectedSegments) {
        if (!document.segment(label))
            return failure(ErrorCode::UnknownSegment, QString::number(label),
                Clause::saying("in field 'spared'"));
    }
    return {};
}

} // namespace core
