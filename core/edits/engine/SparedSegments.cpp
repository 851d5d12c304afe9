// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/SparedSegments.h"

#include <set>

namespace core {

void spareProtected(SparedSegments& spared, const Document& document)
{
    std::set<int> all;
    if (spared)
        all.insert(spared->begin(), spared->end());
    for (const Segment& segment : document.segments) {
        if (segment.uncarvable)
            all.insert(segment.label);
    }
    if (!all.empty())
        spared.emplace(all.begin(), all.end());
}

SparedLabels sparedLabels(const SparedSegments& spared, const Document& document)
{
    SparedLabels labels;
    labels.plane = document.growths.empty() ? std::uint8_t(0) : document.growths.front().plane;
    if (!spared)
        return labels;
    for (const int label : *spared)
        labels.labels.set(std::size_t(label));
    return labels;
}

Result<void> checkSpared(const SparedSegments& spared, bool restore, const QString& edit)
{
    if (spared && restore)
        return failure(ErrorCode::InvalidField, edit + QStringLiteral(".spared"),
            QStringLiteral("has no meaning while restoring"));
    return {};
}

Result<void> checkSparedAreThere(
    const SparedSegments& spared, bool restore, const Document& document)
{
    if (restore || !spared)
        return {};
    for (const int label : *spared) {
        if (!document.segment(label))
            return failure(ErrorCode::UnknownSegment, QString::number(label),
                QStringLiteral("in field 'spared'"));
    }
    return {};
}

} // namespace core
