// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/ParallelFor.h"
#include "core/chunks/ProbabilityMap.h"
#include "core/dicom/objects/SegReader.h"
#include "core/masks/LatticeMap.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <vector>

namespace core {

// What the frames of a segment of a DICOM SEG (PS3.3 A.51) hold, on the lattice that they span
// (SegLattice.h). Used by SegMask.cpp.

/// Frames at the same position along their normal; several if a file repeats a plane.
struct PlaneFrames {
    /// Position along the normal as in LatticeMap, in planes of the lattice.
    std::int64_t height = 0;
    std::vector<std::size_t> frames;
    /// Columns and rows on the lattice, as in LatticeMap, beyond which no pixel of these frames is
    /// other than 0.
    std::array<std::int64_t, 2> low{};
    std::array<std::int64_t, 2> high{};
};

/// The columns and rows of a frame that hold all of its pixels that are not 0.
struct OccupiedPixels {
    glm::ivec2 first{std::numeric_limits<int>::max()};
    glm::ivec2 last{-1}; ///< before `first`: all are 0
};

/// The frames of one segment, sorted by height; of a label map they are all frames.
class SegmentPlanes {
public:
    SegmentPlanes(const SegFile& seg, int number, const glm::dmat4& toLattice);

    [[nodiscard]] bool empty() const { return m_planes.empty(); }

    /// The plane that contains a height; null: none.
    [[nodiscard]] const PlaneFrames* at(std::int64_t height) const;

    /// Whether a place in a plane belongs to the segment.
    [[nodiscard]] bool holds(const PlaneFrames& plane, const LatticeMap::Place& place) const
    {
        return std::any_of(plane.frames.begin(), plane.frames.end(), [&](std::size_t frame) {
            const std::optional<glm::ivec2> pixel = pixelAt(frame, place);
            return pixel && isIn(frame, pixel->x, pixel->y);
        });
    }
    /// How likely a place in a plane belongs to the segment, 0 … 255: the greatest probability of
    /// the plane's frames.
    [[nodiscard]] std::uint8_t probability(
        const PlaneFrames& plane, const LatticeMap::Place& place) const
    {
        std::uint8_t most = 0;
        forEachPixel(plane, place, [&](int value) {
            most = std::max(
                most, ProbabilityMap::byteOf(double(value) / std::max(1, m_seg.fullPixel)));
        });
        return most;
    }
    /// Calls @p visit(value) for the pixel of each frame of a plane that covers a place in it.
    template <class Visit>
    void forEachPixel(
        const PlaneFrames& plane, const LatticeMap::Place& place, const Visit& visit) const
    {
        for (const std::size_t frame : plane.frames) {
            if (const std::optional<glm::ivec2> pixel = pixelAt(frame, place))
                visit(m_seg.value(frame, pixel->x, pixel->y));
        }
    }
    [[nodiscard]] std::uint64_t pixelCount() const;
    /// Whether the voxels of every slice coincide with pixels of the frames in its plane.
    [[nodiscard]] bool areUnder(const LatticeMap& map, int slices) const;

private:
    /// The pixel of a frame nearest to a place; none: the place lies outside the frame.
    [[nodiscard]] std::optional<glm::ivec2> pixelAt(
        std::size_t frame, const LatticeMap::Place& place) const
    {
        const std::int64_t column = LatticeMap::nearest(place[0] - m_places[frame][0]);
        const std::int64_t row = LatticeMap::nearest(place[1] - m_places[frame][1]);
        if (column < 0 || row < 0 || column >= m_seg.columns || row >= m_seg.rows)
            return std::nullopt;
        return glm::ivec2(int(column), int(row));
    }
    [[nodiscard]] bool isIn(std::size_t frame, int column, int row) const
    {
        const int value = m_seg.value(frame, column, row);
        return m_seg.type == SegFile::Type::Fractional ? 2 * value >= m_seg.fullPixel : value != 0;
    }

    void bound(PlaneFrames& plane) const;

    const SegFile& m_seg;
    /// For each frame of the segment, where its first pixel lies on the lattice, and what it holds.
    std::vector<LatticeMap::Place> m_places;
    std::vector<OccupiedPixels> m_occupied;
    std::vector<PlaneFrames> m_planes;
};

/// The voxels of a row that may lie where a plane's frames hold something, as the first and the one
/// behind the last. @param start of the row, on the lattice @param length of it
[[nodiscard]] std::array<int, 2> occupiedPart(const PlaneFrames& plane,
    const LatticeMap::Place& start, const LatticeMap::Place& step, int length);

/// Calls @p visit(slice, index of the voxel in memory, plane, place on the lattice) for every voxel
/// of the volume that lies in one of the segment's planes, but for some where its frames are 0.
/// Slices are distributed to all cores.
template <class Visit>
void forEachVoxelIn(
    const SegmentPlanes& planes, const LatticeMap& map, const glm::ivec3& size, const Visit& visit)
{
    parallelFor(size.z, [&](int k) {
        for (int j = 0; j < size.y; ++j) {
            const std::uint64_t row = (std::uint64_t(k) * std::uint64_t(size.y) + std::uint64_t(j))
                * std::uint64_t(size.x);
            LatticeMap::Place place = map.rowStart(j, k);
            // If both ends of a row lie in one plane, the whole row does.
            const PlaneFrames* begin = planes.at(place[2]);
            const bool whole = begin == planes.at(place[2] + map.step()[2] * (size.x - 1));
            if (whole && !begin && map.step()[2] == 0)
                continue;
            const std::array<int, 2> part = whole && begin
                ? occupiedPart(*begin, place, map.step(), size.x)
                : std::array<int, 2>{0, size.x};
            for (std::size_t axis = 0; axis < 3; ++axis)
                place[axis] += part[0] * map.step()[axis];
            for (int i = part[0]; i < part[1]; ++i) {
                if (const PlaneFrames* plane = whole && begin ? begin : planes.at(place[2]))
                    visit(k, row + std::uint64_t(i), *plane, place);
                for (std::size_t axis = 0; axis < 3; ++axis)
                    place[axis] += map.step()[axis];
            }
        }
    });
}

} // namespace core
