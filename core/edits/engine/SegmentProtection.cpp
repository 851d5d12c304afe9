// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/SegmentProtection.h"

#include "core/edits/engine/FirstPlane.h"

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

ProtectedLabels protectedLabelsOf(const ProtectedSegments& protectedSegments)
{
    ProtectedLabels labels;
    if (!protectedSegments)
        return labels;
    for (const int label : *protectedSegments)
        labels.labels.set(std::size_t(label));
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
        const Segment* segment = document.segment(label);
        if (!segment)
            return failure(ErrorCode::UnknownSegment, QString::number(label),
                Clause::saying("in field 'spared'"));
        if (const Result<void> first = checkInFirstPlane(
                QStringLiteral("spared"), *segment, Clause::saying("be spared by a cut"));
            !first)
            return first;
    }
    return {};
}

} // namespace core
