// SPDX-License-Identifier: Apache-2.0
#include "core/masks/LatticeMap.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace core {

namespace {

/// Points of the lattice from voxel to voxel, and from the origin: what 64 bits leave room for.
constexpr double longestStep = 16384.0;
constexpr double farthest = 536870912.0;

/// @return whether it is within @p most
bool toFixed(const glm::dvec3& place, double most, LatticeMap::Place& fixed)
{
    for (int axis = 0; axis < 3; ++axis) {
        if (!(std::abs(place[axis]) <= most))
            return false;
        fixed[std::size_t(axis)] = std::llround(place[axis] * double(LatticeMap::one));
    }
    return true;
}

constexpr std::int64_t offAtMost = LatticeMap::one / 100;

std::int64_t offPoint(std::int64_t place)
{
    return std::llabs(place - LatticeMap::nearest(place) * LatticeMap::one);
}

/// Along one axis of the lattice to the next point, and on points after so many steps too.
bool isUnit(const LatticeMap::Place& step, int steps)
{
    std::int64_t length = 0;
    for (const std::int64_t part : step) {
        length += std::llabs(LatticeMap::nearest(part));
        if (offPoint(part) > offAtMost / std::max(steps, 1))
            return false;
    }
    return length == 1;
}

} // namespace

LatticeMap::LatticeMap(const VolumeGeometry& volume, const glm::dmat4& worldToLattice)
    : m_size(volume.size)
{
    const glm::dmat3 directions =
        glm::dmat3(worldToLattice) * glm::dmat3(glm::dmat4(volume.indexToWorld));
    m_sound =
        toFixed(directions[0], longestStep, m_perI) && toFixed(directions[1], longestStep, m_perJ);
    for (int k = 0; k < m_size.z; ++k) {
        const glm::dvec3 first = volume.slicePositions.empty()
            ? glm::dvec3(volume.indexToWorld * glm::dvec4(0.0, 0.0, double(k), 1.0))
            : volume.slicePositions[std::size_t(k)];
        Place place{};
        m_sound = m_sound
            && toFixed(glm::dvec3(worldToLattice * glm::dvec4(first, 1.0)), farthest, place);
        m_slices.push_back(place);
    }
}

bool LatticeMap::isPoint(std::int64_t place)
{
    return offPoint(place) <= offAtMost;
}

bool LatticeMap::hasUnitSteps() const
{
    return isUnit(m_perI, m_size.x) && isUnit(m_perJ, m_size.y);
}

bool LatticeMap::isOneToOne() const
{
    if (!hasUnitSteps())
        return false;
    for (std::size_t k = 0; k < m_slices.size(); ++k) {
        if (!std::all_of(m_slices[k].begin(), m_slices[k].end(), isPoint))
            return false;
        Place step{};
        for (std::size_t axis = 0; k > 0 && axis < 3; ++axis)
            step[axis] = m_slices[k][axis] - m_slices[k - 1][axis];
        if (k > 0 && !isUnit(step, 1))
            return false;
    }
    return true;
}

LatticeMap::Place LatticeMap::rowStart(int j, int k) const
{
    Place place = m_slices[std::size_t(k)];
    for (std::size_t axis = 0; axis < 3; ++axis)
        place[axis] += m_perJ[axis] * j;
    return place;
}

} // namespace core
