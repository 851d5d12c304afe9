// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/ChunkStroke.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

using core::ChunkMap;
using core::ChunkTree;

namespace reenact {

namespace {

constexpr std::array<int, 7> divisions{20, 40, 80, 160, 320, 640, 1280};
constexpr std::size_t mostChunks = 24; ///< that are looked at as the begin of a stroke, or its next
constexpr int mostPoints = 8;

/// The chunks of one division, and what a stroke that adds or removes would mend.
class Division {
public:
    Division(const ChunkMap& map, const UserEye& eye, int count, bool adds)
        : m_map(map)
        , m_count(count)
    {
        for (const ChunkTree::Chunk chunk : map.tree().division(count)) {
            int gain = 0;
            map.forEachVoxel(chunk, [&](const glm::ivec3& voxel) {
                gain += eye.worth(eye.seen().offset(voxel), adds);
            });
            m_gains[chunk] = gain;
            if (gain > 0)
                m_wanted.push_back(chunk);
        }
        std::sort(m_wanted.begin(), m_wanted.end(), [this](auto one, auto other) {
            return m_gains[one] != m_gains[other] ? m_gains[one] > m_gains[other] : one < other;
        });
        m_wanted.resize(std::min(m_wanted.size(), mostChunks));
    }

    [[nodiscard]] ChunkStroke best(bool adds) const
    {
        ChunkStroke best{.division = m_count, .adds = adds, .points = {}, .gain = 0};
        for (std::size_t first = 0; first < std::min<std::size_t>(2, m_wanted.size()); ++first) {
            for (int axis = 0; axis < 3; ++axis) {
                const ChunkStroke stroke = from(m_wanted[first], axis, adds);
                if (stroke.gain > best.gain)
                    best = stroke;
            }
        }
        return best;
    }

private:
    /// On the slice across an axis on which the first chunk is largest.
    [[nodiscard]] ChunkStroke from(ChunkTree::Chunk first, int axis, bool adds) const
    {
        std::map<int, int> sizes;
        m_map.forEachVoxel(first, [&](const glm::ivec3& voxel) { ++sizes[voxel[axis]]; });
        const int slice = std::max_element(sizes.begin(), sizes.end(), [](auto one, auto other) {
            return one.second < other.second;
        })->first;
        ChunkStroke stroke{
            .division = m_count, .adds = adds, .points = {middleOn(first, axis, slice)}, .gain = 0};
        stroke.gain = gainOf(stroke.points);
        while (int(stroke.points.size()) < mostPoints) {
            ChunkStroke longer = stroke;
            for (const ChunkTree::Chunk chunk : m_wanted) {
                if (!isOn(chunk, axis, slice))
                    continue;
                std::vector<glm::dvec3> points = stroke.points;
                points.push_back(middleOn(chunk, axis, slice));
                const int gain = gainOf(points);
                if (gain <= longer.gain + longer.gain / 50)
                    continue;
                longer.gain = gain;
                longer.points = std::move(points);
            }
            if (longer.gain == stroke.gain)
                break;
            stroke = std::move(longer);
        }
        return stroke;
    }

    [[nodiscard]] int gainOf(const std::vector<glm::dvec3>& points) const
    {
        std::set<ChunkTree::Chunk> met;
        for (const glm::dvec3& place : alongStroke(points)) {
            if (const auto chunk = m_map.chunkAt(glm::ivec3(glm::round(place)), m_count))
                met.insert(*chunk);
        }
        int gain = 0;
        for (const ChunkTree::Chunk chunk : met)
            gain += m_gains.at(chunk);
        return gain;
    }

    [[nodiscard]] bool isOn(ChunkTree::Chunk chunk, int axis, int slice) const
    {
        bool isThere = false;
        m_map.forEachVoxel(
            chunk, [&](const glm::ivec3& voxel) { isThere = isThere || voxel[axis] == slice; });
        return isThere;
    }

    /// The voxel on a slice with most of its chunk around it, as one aims.
    [[nodiscard]] glm::dvec3 middleOn(ChunkTree::Chunk chunk, int axis, int slice) const
    {
        std::vector<glm::dvec3> there;
        m_map.forEachVoxel(chunk, [&](const glm::ivec3& voxel) {
            if (voxel[axis] == slice)
                there.emplace_back(voxel);
        });
        glm::dvec3 best = there.front();
        int most = -1;
        const std::size_t stride = std::max<std::size_t>(1, there.size() / 60);
        for (std::size_t i = 0; i < there.size(); i += stride) {
            const auto near = int(std::count_if(there.begin(), there.end(), [&](const auto& other) {
                return glm::dot(other - there[i], other - there[i]) <= 16.0;
            }));
            if (near <= most)
                continue;
            most = near;
            best = there[i];
        }
        return best;
    }

    const ChunkMap& m_map;
    int m_count;
    std::map<ChunkTree::Chunk, int> m_gains;
    std::vector<ChunkTree::Chunk> m_wanted; ///< the best first
};

} // namespace

std::vector<glm::dvec3> alongStroke(const std::vector<glm::dvec3>& points)
{
    std::vector<glm::dvec3> places{points.front()};
    for (std::size_t i = 1; i < points.size(); ++i) {
        const int parts = std::max(1, int(std::ceil(glm::distance(points[i - 1], points[i]))));
        for (int part = 1; part <= parts; ++part)
            places.push_back(
                points[i - 1] + double(part) / double(parts) * (points[i] - points[i - 1]));
    }
    return places;
}

ChunkStroke bestChunkStroke(const ChunkMap& map, const UserEye& eye, int division)
{
    ChunkStroke best;
    for (const int count : divisions) {
        if ((division != 0 && count != division) || count < map.tree().fewest()
            || count > map.tree().finest())
            continue;
        for (const bool adds : {false, true}) {
            ChunkStroke stroke = Division(map, eye, count, adds).best(adds);
            if (stroke.gain > best.gain)
                best = std::move(stroke);
        }
    }
    return best;
}

} // namespace reenact
