// SPDX-License-Identifier: Apache-2.0
#include "core/contour/ContourTrack.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace core {

ContourTrack::ContourTrack(const ContourState& start)
    : m_generations{{.gained = start.gained(), .lost = start.lost()}}
{
}

void ContourTrack::append(ContourGeneration generation)
{
    m_generations.push_back(std::move(generation));
}

std::int64_t ContourTrack::gained() const
{
    return m_generations[std::size_t(m_shown)].gained;
}

std::int64_t ContourTrack::lost() const
{
    return m_generations[std::size_t(m_shown)].lost;
}

/// A voxel that changes twice is as it was, so the order does not matter.
std::vector<ContourPlaces> ContourTrack::between(int from, int to) const
{
    std::vector<ContourPlaces> way;
    for (int generation = std::min(from, to) + 1; generation <= std::max(from, to); ++generation)
        way.push_back(m_generations[std::size_t(generation)].changed);
    return way;
}

} // namespace core
