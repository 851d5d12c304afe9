// SPDX-License-Identifier: Apache-2.0
#include "core/masks/SegPlanes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>

namespace core {

namespace {

/// As in LatticeMap. What is too far away, or not a number, is put where that still has room.
std::int64_t fixedPlace(double place)
{
    constexpr double farthestPlace = 1e8;
    const double held = place >= -farthestPlace ? std::min(place, farthestPlace) : -farthestPlace;
    return std::llround(held * double(LatticeMap::one));
}

/// @param pixel in the frame, row by row
void noteOccupied(OccupiedPixels& occupied, std::uint64_t pixel, int columns)
{
    const glm::ivec2 at(int(pixel % std::uint64_t(columns)), int(pixel / std::uint64_t(columns)));
    occupied.first = glm::min(occupied.first, at);
    occupied.last = glm::max(occupied.last, at);
}

OccupiedPixels occupiedBits(const SegFile& seg, std::size_t frame)
{
    OccupiedPixels occupied;
    const std::uint64_t pixels = std::uint64_t(seg.rows) * std::uint64_t(seg.columns);
    const std::uint64_t begin = frame * pixels;
    const std::uint64_t end = begin + pixels;
    for (std::uint64_t byte = begin / 8; byte * 8 < end; ++byte) {
        // Most of a frame is empty.
        std::uint64_t word = 0;
        if (byte + sizeof(word) <= seg.bits.size()) {
            std::memcpy(&word, seg.bits.data() + byte, sizeof(word));
            if (word == 0) {
                byte += sizeof(word) - 1;
                continue;
            }
        }
        for (unsigned rest = seg.bits[byte]; rest != 0; rest &= rest - 1) {
            const std::uint64_t bit = byte * 8 + std::uint64_t(std::countr_zero(rest));
            if (bit >= begin && bit < end)
                noteOccupied(occupied, bit - begin, seg.columns);
        }
    }
    return occupied;
}

OccupiedPixels occupiedPixels(const SegFile& seg, std::size_t frame)
{
    if (seg.bitsPerPixel == 1)
        return occupiedBits(seg, frame);
    OccupiedPixels occupied;
    // One look at a label map tells of all its segments; it is not for each of them.
    if (seg.type == SegFile::Type::LabelMap)
        return {.first = {0, 0}, .last = {seg.columns - 1, seg.rows - 1}};
    for (int row = 0; row < seg.rows; ++row) {
        for (int column = 0; column < seg.columns; ++column) {
            if (seg.value(frame, column, row) != 0)
                noteOccupied(occupied,
                    std::uint64_t(row) * std::uint64_t(seg.columns) + std::uint64_t(column),
                    seg.columns);
        }
    }
    return occupied;
}

} // namespace

std::array<int, 2> occupiedPart(const PlaneFrames& plane, const LatticeMap::Place& start,
    const LatticeMap::Place& step, int length)
{
    std::int64_t first = 0;
    std::int64_t last = length - 1;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        if (plane.low[axis] > plane.high[axis])
            return {0, 0};
        const std::int64_t toLow = plane.low[axis] - start[axis];
        const std::int64_t toHigh = plane.high[axis] - start[axis];
        if (step[axis] == 0 && (toLow > 0 || toHigh < 0))
            return {0, 0};
        if (step[axis] == 0)
            continue;
        // Division rounds towards 0, so that a voxel too many may be left, and none too few.
        const std::int64_t one = toLow / step[axis];
        const std::int64_t other = toHigh / step[axis];
        first = std::max(first, std::min(one, other) - 1);
        last = std::min(last, std::max(one, other) + 1);
    }
    return first <= last ? std::array<int, 2>{int(first), int(last) + 1} : std::array<int, 2>{0, 0};
}

SegmentPlanes::SegmentPlanes(const SegFile& seg, int number, const glm::dmat4& toLattice)
    : m_seg(seg)
{
    std::map<std::int64_t, std::vector<std::size_t>> byHeight;
    m_places.resize(seg.frames.size());
    m_occupied.resize(seg.frames.size());
    for (std::size_t i = 0; i < seg.frames.size(); ++i) {
        if (seg.type != SegFile::Type::LabelMap && seg.frames[i].segment != number)
            continue;
        const glm::dvec3 at(toLattice * glm::dvec4(seg.frames[i].plane.position, 1.0));
        for (int axis = 0; axis < 3; ++axis)
            m_places[i][std::size_t(axis)] = fixedPlace(at[axis]);
        m_occupied[i] = occupiedPixels(seg, i);
        byHeight[m_places[i][2]].push_back(i);
    }
    for (auto& [height, frames] : byHeight) {
        PlaneFrames plane{.height = height, .frames = std::move(frames)};
        bound(plane);
        m_planes.push_back(std::move(plane));
    }
}

void SegmentPlanes::bound(PlaneFrames& plane) const
{
    plane.low.fill(std::numeric_limits<std::int64_t>::max());
    plane.high.fill(std::numeric_limits<std::int64_t>::min());
    for (const std::size_t frame : plane.frames) {
        const OccupiedPixels& occupied = m_occupied[frame];
        for (int axis = 0; axis < 2; ++axis) {
            if (occupied.last[axis] < 0)
                continue;
            // A whole pixel around, since the nearest to a place is less than that away.
            const auto at = std::size_t(axis);
            const std::int64_t origin = m_places[frame][at];
            plane.low[at] =
                std::min(plane.low[at], origin + (occupied.first[axis] - 1) * LatticeMap::one);
            plane.high[at] =
                std::max(plane.high[at], origin + (occupied.last[axis] + 1) * LatticeMap::one);
        }
    }
}

const PlaneFrames* SegmentPlanes::at(std::int64_t height) const
{
    const auto above = std::lower_bound(m_planes.begin(), m_planes.end(), height,
        [](const PlaneFrames& plane, std::int64_t value) { return plane.height < value; });
    const PlaneFrames* nearest = above == m_planes.end() ? nullptr : &*above;
    if (above != m_planes.begin()) {
        const PlaneFrames& below = *(above - 1);
        if (!nearest || height - below.height < nearest->height - height)
            nearest = &below;
    }
    if (nearest && LatticeMap::nearest(height - nearest->height) != 0)
        return nullptr;
    return nearest;
}

std::uint64_t SegmentPlanes::pixelCount() const
{
    std::uint64_t count = 0;
    for (const PlaneFrames& plane : m_planes) {
        for (const std::size_t frame : plane.frames) {
            const OccupiedPixels& occupied = m_occupied[frame];
            for (int row = occupied.first.y; row <= occupied.last.y; ++row) {
                for (int column = occupied.first.x; column <= occupied.last.x; ++column)
                    count += isIn(frame, column, row) ? 1 : 0;
            }
        }
    }
    return count;
}

bool SegmentPlanes::areUnder(const LatticeMap& map, int slices) const
{
    for (int k = 0; k < slices; ++k) {
        const LatticeMap::Place first = map.rowStart(0, k);
        const PlaneFrames* plane = at(first[2]);
        for (std::size_t i = 0; plane && i < plane->frames.size(); ++i) {
            const LatticeMap::Place& frame = m_places[plane->frames[i]];
            if (!LatticeMap::isPoint(first[0] - frame[0])
                || !LatticeMap::isPoint(first[1] - frame[1]))
                return false;
        }
    }
    return map.hasUnitSteps();
}

} // namespace core
