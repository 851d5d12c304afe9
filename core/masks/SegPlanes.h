// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/ParallelFor.h"
#include "core/chunks/ProbabilityMap.h"
#include "core/dicom/objects/SegReader.h"
#include "core/masks/LatticeMap.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <optional>
#include <vector>

namespace core {

// Where the frames of a DICOM SEG lie on a volume, for SegMask.cpp.

/// Frames whose planes lie at one place along their normal; several where a file repeats one.
struct PlaneFrames {
    std::int64_t height = 0; ///< LatticeMap, in planes
    std::vector<std::size_t> frames;
};

/// The lattice that frames span: columns and rows of the first one, and its normal.
struct FrameLattice {
    glm::dvec3 normal{0.0};
    glm::dmat4 world{1.0}; ///< with 1 mm along the normal
    double planeMm = 1.0; ///< how far a plane reaches, from half of it below to half above
    bool onSlices = false; ///< every plane is one of the volume's slices

    [[nodiscard]] glm::dmat4 toLattice() const
    {
        glm::dmat4 matrix = world;
        matrix[2] *= planeMm;
        return glm::inverse(matrix);
    }
};

/// The frames' lattice on a volume.
struct PlacedFrames {
    FrameLattice lattice;
    glm::dmat4 toLattice;
    LatticeMap map;
};
/// Errors: InvalidGeometry (the first frame's), UnsupportedFormat (frames of several orientations
/// or spacings, or out of all proportion to the volume). All name the file.
[[nodiscard]] Result<PlacedFrames> placedFrames(
    const SegFile& seg, const VolumeGeometry& geometry, const QString& path);

/// The frames of one segment, by height.
class SegmentPlanes {
public:
    SegmentPlanes(const SegFile& seg, int number, const glm::dmat4& toLattice);

    [[nodiscard]] bool empty() const { return m_planes.empty(); }

    /// The plane that a height belongs to; null: none.
    [[nodiscard]] const PlaneFrames* at(std::int64_t height) const;

    /// Whether a place in a plane belongs to the segment.
    [[nodiscard]] bool holds(const PlaneFrames& plane, const LatticeMap::Place& place) const
    {
        return std::any_of(plane.frames.begin(), plane.frames.end(), [&](std::size_t frame) {
            const std::optional<glm::ivec2> pixel = pixelAt(frame, place);
            return pixel && isIn(frame, pixel->x, pixel->y);
        });
    }
    /// How likely a place in a plane belongs to the segment: what the frame says that says most.
    [[nodiscard]] std::uint8_t probability(
        const PlaneFrames& plane, const LatticeMap::Place& place) const
    {
        std::uint8_t most = 0;
        for (const std::size_t frame : plane.frames) {
            if (const std::optional<glm::ivec2> pixel = pixelAt(frame, place))
                most = std::max(most,
                    ProbabilityMap::byteOf(double(m_seg.value(frame, pixel->x, pixel->y))
                        / std::max(1, m_seg.fullPixel)));
        }
        return most;
    }
    [[nodiscard]] std::uint64_t pixelCount() const;
    /// The voxels of each slice lie on pixels of its plane's frames.
    [[nodiscard]] bool areUnder(const LatticeMap& map, int slices) const;

private:
    /// The pixel of a frame nearest to a place; none: beside the frame.
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
        switch (m_seg.type) {
        case SegFile::Type::Binary:
            break;
        case SegFile::Type::Fractional:
            return 2 * value >= m_seg.fullPixel;
        case SegFile::Type::LabelMap:
            return value == m_number;
        }
        return value != 0;
    }

    const SegFile& m_seg;
    int m_number;
    std::vector<LatticeMap::Place> m_places; ///< of frames
    std::vector<PlaneFrames> m_planes;
};

/// Calls @p visit(slice, voxel of the volume, plane, place in it) for every voxel that lies in one
/// of the segment's planes; slices on all cores.
template <class Visit>
void forEachVoxelIn(
    const SegmentPlanes& planes, const LatticeMap& map, const glm::ivec3& size, const Visit& visit)
{
    parallelFor(size.z, [&](int k) {
        for (int j = 0; j < size.y; ++j) {
            const std::uint64_t row = (std::uint64_t(k) * std::uint64_t(size.y) + std::uint64_t(j))
                * std::uint64_t(size.x);
            LatticeMap::Place place = map.rowStart(j, k);
            // Along a line, what lies between two places of one plane belongs to it.
            const PlaneFrames* begin = planes.at(place[2]);
            const bool whole = begin == planes.at(place[2] + map.step()[2] * (size.x - 1));
            if (whole && !begin && map.step()[2] == 0)
                continue;
            for (int i = 0; i < size.x; ++i) {
                if (const PlaneFrames* plane = whole && begin ? begin : planes.at(place[2]))
                    visit(k, row + std::uint64_t(i), *plane, place);
                for (std::size_t axis = 0; axis < 3; ++axis)
                    place[axis] += map.step()[axis];
            }
        }
    });
}

} // namespace core
