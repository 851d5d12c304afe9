// SPDX-License-Identifier: Apache-2.0
#include "core/base/ParallelFor.h"
#include "core/dicom/objects/SegReader.h"
#include "core/masks/LatticeMap.h"
#include "core/masks/MaskParts.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <set>

namespace core {

namespace {

using Place = LatticeMap::Place;

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

double heightMm(const FrameLattice& lattice, const glm::dvec3& lps)
{
    return glm::dot(lattice.normal, lps - glm::dvec3(lattice.world[3]));
}

/// The smallest step between heights that are not the same; 0: there is none.
double smallestStep(std::vector<double> heights)
{
    constexpr double sameMm = 1e-3;
    std::sort(heights.begin(), heights.end());
    double smallest = 0.0;
    for (std::size_t i = 1; i < heights.size(); ++i) {
        const double step = heights[i] - heights[i - 1];
        if (step > sameMm && (smallest == 0.0 || step < smallest))
            smallest = step;
    }
    return smallest;
}

std::vector<double> sliceHeights(const FrameLattice& lattice, const VolumeGeometry& geometry)
{
    std::vector<double> heights;
    for (int k = 0; k < geometry.size.z; ++k) {
        const glm::dvec3 first = geometry.slicePositions.empty()
            ? geometry.toWorld({0.0, 0.0, double(k)})
            : geometry.slicePositions[std::size_t(k)];
        heights.push_back(heightMm(lattice, first));
    }
    return heights;
}

bool isAcross(const FrameLattice& lattice, const VolumeGeometry& geometry)
{
    constexpr double mostMm = 0.01;
    for (int axis = 0; axis < 2; ++axis) {
        const double rise = glm::dot(lattice.normal, glm::dvec3(geometry.indexToWorld[axis]));
        if (std::abs(rise) * geometry.size[axis] > mostMm)
            return false;
    }
    return true;
}

/// Only frames that hold something are there, so that their distances do not say how thick a plane
/// is: where all of them are slices of the volume each belongs to its slice and to no other.
Result<FrameLattice> latticeOf(
    const SegFile& seg, const VolumeGeometry& geometry, const QString& path)
{
    const HeaderPlane& first = seg.frames.front().plane;
    FrameLattice lattice;
    lattice.normal = glm::cross(first.rowDirection, first.columnDirection);
    const double length = glm::length(lattice.normal);
    if (!(length > 0.5) || !(first.rowSpacing > 0.0) || !(first.columnSpacing > 0.0))
        return failure(ErrorCode::InvalidGeometry, path,
            QStringLiteral("orientation or spacing of its first frame"));
    lattice.normal /= length;
    lattice.world = glm::dmat4(glm::dvec4(first.rowDirection * first.columnSpacing, 0.0),
        glm::dvec4(first.columnDirection * first.rowSpacing, 0.0), glm::dvec4(lattice.normal, 0.0),
        glm::dvec4(first.position, 1.0));
    std::vector<double> planes;
    for (std::size_t i = 0; i < seg.frames.size(); ++i) {
        const HeaderPlane& plane = seg.frames[i].plane;
        constexpr double alike = 1e-3;
        const bool same = glm::distance(plane.rowDirection, first.rowDirection) < alike
            && glm::distance(plane.columnDirection, first.columnDirection) < alike
            && std::abs(plane.rowSpacing - first.rowSpacing) < alike * first.rowSpacing
            && std::abs(plane.columnSpacing - first.columnSpacing) < alike * first.columnSpacing;
        if (!same)
            return failure(ErrorCode::UnsupportedFormat, path,
                QStringLiteral("frame %1 has another orientation or spacing than the first")
                    .arg(i + 1));
        planes.push_back(heightMm(lattice, plane.position));
    }
    const std::vector<double> slices = sliceHeights(lattice, geometry);
    const double step = smallestStep(slices);
    const double mostMm = std::max(0.01, 0.01 * step);
    lattice.onSlices =
        isAcross(lattice, geometry) && std::all_of(planes.begin(), planes.end(), [&](double plane) {
            return std::any_of(slices.begin(), slices.end(),
                [&](double slice) { return std::abs(slice - plane) <= mostMm; });
        });
    const double apart = smallestStep(planes);
    const double spacing = geometry.spacingMm().z;
    const double own = seg.planeDistance > 0.0 ? seg.planeDistance : apart;
    if (lattice.onSlices)
        lattice.planeMm = step > 0.0 ? step : spacing;
    else
        lattice.planeMm = own > 0.0 ? own : spacing;
    return lattice;
}

/// The frames of one segment, by height.
class SegmentPlanes {
public:
    SegmentPlanes(const SegFile& seg, int number, const glm::dmat4& toLattice)
        : m_seg(seg)
        , m_number(number)
    {
        std::map<std::int64_t, std::vector<std::size_t>> byHeight;
        m_places.resize(seg.frames.size());
        for (std::size_t i = 0; i < seg.frames.size(); ++i) {
            if (seg.type != SegFile::Type::LabelMap && seg.frames[i].segment != number)
                continue;
            const glm::dvec3 at(toLattice * glm::dvec4(seg.frames[i].plane.position, 1.0));
            for (int axis = 0; axis < 3; ++axis)
                m_places[i][std::size_t(axis)] =
                    std::llround(std::clamp(at[axis], -1e8, 1e8) * double(LatticeMap::one));
            byHeight[m_places[i][2]].push_back(i);
        }
        for (auto& [height, frames] : byHeight)
            m_planes.push_back({height, std::move(frames)});
    }

    [[nodiscard]] bool empty() const { return m_planes.empty(); }

    /// The plane that a height belongs to; null: none.
    [[nodiscard]] const PlaneFrames* at(std::int64_t height) const
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

    /// Whether a place in a plane belongs to the segment.
    [[nodiscard]] bool holds(const PlaneFrames& plane, const Place& place) const
    {
        return std::any_of(plane.frames.begin(), plane.frames.end(), [&](std::size_t frame) {
            const std::int64_t column = LatticeMap::nearest(place[0] - m_places[frame][0]);
            const std::int64_t row = LatticeMap::nearest(place[1] - m_places[frame][1]);
            return column >= 0 && row >= 0 && column < m_seg.columns && row < m_seg.rows
                && isIn(frame, int(column), int(row));
        });
    }
    [[nodiscard]] std::uint64_t pixelCount() const
    {
        std::uint64_t count = 0;
        for (const PlaneFrames& plane : m_planes) {
            for (const std::size_t frame : plane.frames) {
                for (int row = 0; row < m_seg.rows; ++row) {
                    for (int column = 0; column < m_seg.columns; ++column)
                        count += isIn(frame, column, row) ? 1 : 0;
                }
            }
        }
        return count;
    }
    /// The voxels of each slice lie on pixels of its plane's frames.
    [[nodiscard]] bool areUnder(const LatticeMap& map, int slices) const
    {
        for (int k = 0; k < slices; ++k) {
            const Place first = map.rowStart(0, k);
            const PlaneFrames* plane = at(first[2]);
            for (std::size_t i = 0; plane && i < plane->frames.size(); ++i) {
                const Place& frame = m_places[plane->frames[i]];
                if (!LatticeMap::isPoint(first[0] - frame[0])
                    || !LatticeMap::isPoint(first[1] - frame[1]))
                    return false;
            }
        }
        return map.hasUnitSteps();
    }

private:
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
    std::vector<Place> m_places; ///< of frames
    std::vector<PlaneFrames> m_planes;
};

VoxelRuns voxelsOf(const SegmentPlanes& planes, const LatticeMap& map, const glm::ivec3& size)
{
    std::vector<VoxelRuns> slices(std::size_t(size.z));
    parallelFor(size.z, [&](int k) {
        for (int j = 0; j < size.y; ++j) {
            const std::uint64_t row = (std::uint64_t(k) * std::uint64_t(size.y) + std::uint64_t(j))
                * std::uint64_t(size.x);
            Place place = map.rowStart(j, k);
            // Along a line, what lies between two places of one plane belongs to it.
            const PlaneFrames* begin = planes.at(place[2]);
            const bool whole = begin == planes.at(place[2] + map.step()[2] * (size.x - 1));
            if (whole && !begin && map.step()[2] == 0)
                continue;
            for (int i = 0; i < size.x; ++i) {
                const PlaneFrames* plane = whole && begin ? begin : planes.at(place[2]);
                if (plane && planes.holds(*plane, place))
                    slices[std::size_t(k)].append(row + std::uint64_t(i), 1);
                for (std::size_t axis = 0; axis < 3; ++axis)
                    place[axis] += map.step()[axis];
            }
        }
    });
    VoxelRuns all;
    for (const VoxelRuns& slice : slices)
        all.append(slice);
    return all;
}

} // namespace

Result<MaskOnVolume> readSegMask(
    const QString& path, const Volume& volume, const Progress& progress)
{
    const Result<SegFile> seg = readSeg(path);
    if (!seg)
        return tl::unexpected(seg.error());
    const Result<FrameLattice> lattice = latticeOf(*seg, volume.geometry, path);
    if (!lattice)
        return tl::unexpected(lattice.error());
    const glm::dmat4 toLattice = lattice->toLattice();
    const LatticeMap map(volume.geometry, toLattice);
    if (!map.isSound())
        return failure(ErrorCode::UnsupportedFormat, path,
            QStringLiteral("its pixels are out of all proportion to the study's"));
    MaskOnVolume mask;
    mask.notes = notesOnOrigin(seg->patient.id, seg->frameOfReferenceUid, volume);
    if (seg->type == SegFile::Type::Fractional)
        mask.notes.push_back({.code = MaskNote::Code::Fractional});
    MaskFit fit{.oneToOne = true};
    std::uint64_t taken = 0;
    int without = 0;
    for (std::size_t i = 0; i < seg->segments.size(); ++i) {
        const SegSegment& segment = seg->segments[i];
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        progress.report(QStringLiteral("Placing the mask"), int(i), int(seg->segments.size()));
        const SegmentPlanes planes(*seg, segment.number, toLattice);
        VoxelRuns voxels;
        // Number 0 is what a label map calls its background.
        if (!planes.empty() && segment.number != 0) {
            fit.labelled += planes.pixelCount();
            fit.oneToOne =
                fit.oneToOne && lattice->onSlices && planes.areUnder(map, volume.geometry.size.z);
            voxels = voxelsOf(planes, map, volume.geometry.size);
        }
        taken += voxels.voxelCount();
        if (voxels.empty()) {
            without += segment.number != 0 ? 1 : 0;
            continue;
        }
        const QString name = segment.label.simplified();
        mask.segments.push_back(
            {.name = name.isEmpty() ? QStringLiteral("Segment %1").arg(segment.number) : name,
                .rgb = segment.rgb,
                .code = segment.type,
                .voxels = std::move(voxels)});
    }
    if (fit.labelled == 0)
        return failure(
            ErrorCode::UnsupportedFormat, path, QStringLiteral("no pixel belongs to a segment"));
    const HeaderPlane& plane = seg->frames.front().plane;
    fit.labelledMl =
        double(fit.labelled) * plane.rowSpacing * plane.columnSpacing * lattice->planeMm / 1000.0;
    fit.takenMl = millilitres(taken, volume.geometry);
    if (fit.oneToOne && fit.labelled > taken)
        fit.outside = fit.labelled - taken;
    const std::vector<MaskNote> onFit = notesOn(fit);
    mask.notes.insert(mask.notes.end(), onFit.begin(), onFit.end());
    if (without != 0 && !mask.segments.empty())
        mask.notes.push_back({.code = MaskNote::Code::SegmentsWithoutVoxel,
            .some = std::uint64_t(without),
            .all = seg->segments.size()});
    return mask;
}

} // namespace core
