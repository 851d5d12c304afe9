// SPDX-License-Identifier: Apache-2.0
#include "core/metrics/SegmentPairs.h"

#include <algorithm>
#include <optional>

namespace core {

namespace {

bool isNamed(const MaskSegment& segment, const QString& name)
{
    return segment.name.compare(name, Qt::CaseInsensitive) == 0;
}

/// A single one needs no name; of several with one name the first.
std::optional<std::size_t> placeOf(
    const std::vector<MaskSegment>& segments, const QString& name, bool mayBeTheOnly)
{
    const auto found = std::find_if(segments.begin(), segments.end(),
        [&](const auto& segment) { return isNamed(segment, name); });
    if (found != segments.end())
        return std::size_t(found - segments.begin());
    if (mayBeTheOnly && segments.size() == 1)
        return 0;
    return std::nullopt;
}

std::vector<SegmentPair> askedPair(const std::vector<MaskSegment>& mask,
    const std::vector<MaskSegment>& reference, const AskedSegments& asked)
{
    const auto pairOf = [](std::optional<std::size_t> one, std::optional<std::size_t> other) {
        return one && other ? std::vector<SegmentPair>{{*one, *other}} : std::vector<SegmentPair>();
    };
    if (asked.reference.isEmpty())
        return pairOf(placeOf(mask, asked.segment, false), placeOf(reference, asked.segment, true));
    if (asked.segment.isEmpty())
        return pairOf(
            placeOf(mask, asked.reference, true), placeOf(reference, asked.reference, false));
    return pairOf(placeOf(mask, asked.segment, false), placeOf(reference, asked.reference, false));
}

} // namespace

std::vector<SegmentPair> segmentPairs(const std::vector<MaskSegment>& mask,
    const std::vector<MaskSegment>& reference, const AskedSegments& asked)
{
    if (!asked.segment.isEmpty() || !asked.reference.isEmpty())
        return askedPair(mask, reference, asked);
    std::vector<SegmentPair> pairs;
    std::vector<bool> isPaired(mask.size(), false);
    for (std::size_t i = 0; i < reference.size(); ++i) {
        for (std::size_t place = 0; place < mask.size(); ++place) {
            if (isPaired[place] || !isNamed(mask[place], reference[i].name))
                continue;
            isPaired[place] = true;
            pairs.push_back({place, i});
            break;
        }
    }
    if (pairs.empty() && mask.size() == reference.size()) {
        for (std::size_t i = 0; i < reference.size(); ++i)
            pairs.push_back({i, i});
    }
    return pairs;
}

} // namespace core
