// SPDX-License-Identifier: Apache-2.0
#include "core/masks/MaskOverlap.h"

#include "core/edits/kinds/imports/ImportMask.h"
#include "core/edits/kinds/imports/ImportTargets.h"
#include "core/masks/MaskOnVolume.h"
#include "core/masks/MaskParts.h"

#include <algorithm>
#include <limits>
#include <map>
#include <queue>
#include <set>
#include <utility>

namespace core {

namespace {

/// Goes along the voxels of all segments at once, and counts those that several have.
class OverlapSweep {
public:
    void begin(std::size_t segment, const VoxelRun& run)
    {
        advance(run.first);
        const auto place = std::lower_bound(m_open.begin(), m_open.end(), segment,
            [](const Open& open, std::size_t number) { return open.segment < number; });
        m_open.insert(place, {.segment = segment, .end = run.first + run.count});
    }

    [[nodiscard]] std::vector<MaskOverlap> take()
    {
        advance(std::numeric_limits<std::uint64_t>::max());
        std::vector<MaskOverlap> overlaps;
        for (const auto& [segments, voxels] : m_found)
            overlaps.push_back({.segments = segments, .voxels = voxels});
        return overlaps;
    }

private:
    struct Open {
        std::size_t segment = 0;
        std::uint64_t end = 0;
    };

    void advance(std::uint64_t to)
    {
        while (m_at < to && !m_open.empty()) {
            std::uint64_t end = to;
            for (const Open& open : m_open)
                end = std::min(end, open.end);
            if (m_open.size() > 1) {
                std::vector<std::size_t> segments;
                for (const Open& open : m_open)
                    segments.push_back(open.segment);
                m_found[std::move(segments)] += end - m_at;
            }
            m_at = end;
            std::erase_if(m_open, [this](const Open& open) { return open.end <= m_at; });
        }
        m_at = to;
    }

    std::uint64_t m_at = 0;
    std::vector<Open> m_open; ///< runs in which the voxel at m_at lies, by segment
    std::map<std::vector<std::size_t>, std::uint64_t> m_found;
};

/// What segments of one plane share.
/// @param planes of all segments; empty: all are of one
std::vector<MaskOverlap> withinPlanes(
    const std::vector<MaskOverlap>& overlaps, const std::vector<int>& planes)
{
    if (planes.empty())
        return overlaps;
    std::vector<MaskOverlap> within;
    for (const MaskOverlap& overlap : overlaps) {
        std::map<int, std::vector<std::size_t>> byPlane;
        for (const std::size_t segment : overlap.segments) {
            if (segment < planes.size())
                byPlane[planes[segment]].push_back(segment);
        }
        for (auto& [plane, segments] : byPlane) {
            if (segments.size() > 1)
                within.push_back({.segments = std::move(segments), .voxels = overlap.voxels});
        }
    }
    return within;
}

} // namespace

std::vector<MaskOverlap> overlapsOf(const std::vector<MaskSegment>& segments)
{
    struct Next {
        std::uint64_t first = 0;
        std::size_t segment = 0;
        std::size_t run = 0;
    };
    const auto isLater = [](const Next& one, const Next& other) {
        return std::pair(one.first, one.segment) > std::pair(other.first, other.segment);
    };
    std::priority_queue<Next, std::vector<Next>, decltype(isLater)> ahead(isLater);
    const auto add = [&](std::size_t segment, std::size_t run) {
        const std::vector<VoxelRun>& runs = segments[segment].voxels.runs();
        if (run < runs.size())
            ahead.push({.first = runs[run].first, .segment = segment, .run = run});
    };
    for (std::size_t i = 0; i < segments.size(); ++i)
        add(i, 0);
    OverlapSweep sweep;
    while (!ahead.empty()) {
        const Next next = ahead.top();
        ahead.pop();
        sweep.begin(next.segment, segments[next.segment].voxels.runs()[next.run]);
        add(next.segment, next.run + 1);
    }
    return sweep.take();
}

std::uint64_t voxelsOf(const std::vector<MaskOverlap>& overlaps)
{
    std::uint64_t voxels = 0;
    for (const MaskOverlap& overlap : overlaps)
        voxels += overlap.voxels;
    return voxels;
}

std::vector<int> planesFor(const std::vector<MaskOverlap>& overlaps, std::size_t count)
{
    std::vector<std::set<std::size_t>> met(count); // those before it with which it shares voxels
    for (const MaskOverlap& overlap : overlaps) {
        for (const std::size_t segment : overlap.segments) {
            for (const std::size_t other : overlap.segments) {
                if (other < segment)
                    met[segment].insert(other);
            }
        }
    }
    std::vector<int> planes(count, 0);
    for (std::size_t segment = 0; segment < count; ++segment) {
        std::set<int> taken;
        for (const std::size_t other : met[segment])
            taken.insert(planes[other]);
        while (taken.contains(planes[segment]))
            ++planes[segment];
    }
    return planes;
}

std::vector<OverlapGiven> givenAway(
    const std::vector<MaskOverlap>& overlaps, const std::vector<std::size_t>& order)
{
    std::vector<std::size_t> rank(order.size());
    for (std::size_t place = 0; place < order.size(); ++place)
        rank[order[place]] = place;
    std::map<std::pair<std::size_t, std::size_t>, std::uint64_t> pairs;
    for (const MaskOverlap& overlap : overlaps) {
        const std::size_t to = *std::min_element(overlap.segments.begin(), overlap.segments.end(),
            [&rank](std::size_t one, std::size_t other) { return rank[one] < rank[other]; });
        for (const std::size_t from : overlap.segments) {
            if (from != to)
                pairs[{to, from}] += overlap.voxels;
        }
    }
    std::vector<OverlapGiven> given;
    for (const auto& [pair, voxels] : pairs)
        given.push_back({.to = pair.first, .from = pair.second, .voxels = voxels});
    std::stable_sort(
        given.begin(), given.end(), [](const OverlapGiven& one, const OverlapGiven& other) {
            return one.voxels > other.voxels;
        });
    return given;
}

std::vector<MaskNote> notesOnOverlaps(const std::vector<MaskOverlap>& overlaps,
    const ImportMask& edit, const VolumeGeometry& geometry)
{
    std::vector<MaskNote> notes;
    if (edit.as || !edit.segments)
        return notes;
    const std::vector<ImportedSegment>& segments = *edit.segments;
    const std::vector<int> planes = edit.planes.value_or(std::vector<int>());
    if (const std::set<int> used(planes.begin(), planes.end()); used.size() > 1)
        notes.push_back({.code = MaskNote::Code::OverlapsKept, .some = used.size()});
    for (const OverlapGiven& given : givenAway(
             withinPlanes(overlaps, planes), segmentsByPrecedence(edit.ahead, segments.size())))
        notes.push_back({.code = MaskNote::Code::GoesBefore,
            .names = {segments[given.to].name, segments[given.from].name},
            .some = given.voxels,
            .hereMl = millilitres(given.voxels, geometry)});
    return notes;
}

} // namespace core
