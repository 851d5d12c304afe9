// SPDX-License-Identifier: Apache-2.0
#include "core/masks/SegLattice.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace core {

namespace {

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

/// Whether the file names one of the volume's images as what it was drawn on.
bool isDrawnOn(const SegFile& seg, const Volume& volume)
{
    std::set<QString> images(seg.referencedSopUids.begin(), seg.referencedSopUids.end());
    for (const SegFrame& frame : seg.frames)
        images.insert(frame.referencedSopUid);
    images.erase(QString());
    return std::any_of(volume.sources.begin(), volume.sources.end(),
        [&](const SourceSlice& slice) { return images.count(slice.sopInstanceUid) != 0; });
}

/// Whether planes on slices of a volume, which lie @p stepMm apart, are those of thicker ones, so
/// that slices between them belong to them too. Only SpacingBetweenSlices can tell: where frames
/// without a pixel are left out, planes may be far apart on thin slices as well. Exporters state it
/// wrongly, so it is believed only if it is clearly larger, if all planes lie on its steps, and if
/// the file does not name images of this volume, whose slices are known.
bool areThicker(
    const SegFile& seg, const Volume& volume, const std::vector<double>& planes, double stepMm)
{
    constexpr double clearly = 1.5;
    constexpr double off = 0.02;
    const double spacing = seg.spacingBetweenSlices;
    return stepMm > 0.0 && spacing >= clearly * stepMm
        && std::all_of(planes.begin(), planes.end(),
            [&](double plane) {
                const double steps = (plane - planes.front()) / spacing;
                return std::abs(steps - std::round(steps)) <= off;
            })
        && !isDrawnOn(seg, volume);
}

/// A file may contain only frames that are not empty, so the distances between frames do not tell
/// how thick a plane is. If all frames coincide with slices of the volume, each belongs to its
/// slice and to no other, unless they are of thicker slices.
Result<FrameLattice> latticeOf(const SegFile& seg, const Volume& volume, const QString& path)
{
    const VolumeGeometry& geometry = volume.geometry;
    const HeaderPlane& first = seg.frames.front().plane;
    FrameLattice lattice;
    lattice.normal = glm::cross(first.rowDirection, first.columnDirection);
    const double length = glm::length(lattice.normal);
    if (!(length > 0.5) || !(first.rowSpacing > 0.0) || !(first.columnSpacing > 0.0))
        return failure(ErrorCode::InvalidGeometry, path,
            Clause::saying("orientation or spacing of its first frame"));
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
                Clause::saying(
                    "frame %1 has another orientation or spacing than the first", i + 1));
        planes.push_back(heightMm(lattice, plane.position));
    }
    const std::vector<double> slices = sliceHeights(lattice, geometry);
    // Sorting needs numbers, and sums of great ones may be none.
    const auto isNumber = [](double height) { return std::isfinite(height); };
    if (!std::all_of(planes.begin(), planes.end(), isNumber)
        || !std::all_of(slices.begin(), slices.end(), isNumber))
        return failure(ErrorCode::UnsupportedFormat, path,
            Clause::saying("its pixels are out of all proportion to the study's"));
    const double step = smallestStep(slices);
    const double mostMm = std::max(0.01, 0.01 * step);
    lattice.onSlices =
        isAcross(lattice, geometry) && std::all_of(planes.begin(), planes.end(), [&](double plane) {
            return std::any_of(slices.begin(), slices.end(),
                [&](double slice) { return std::abs(slice - plane) <= mostMm; });
        });
    lattice.onSlices = lattice.onSlices && !areThicker(seg, volume, planes, step);
    const double apart = smallestStep(planes);
    const double spacing = geometry.spacingMm().z;
    const double own = seg.planeDistance > 0.0 ? seg.planeDistance : apart;
    if (lattice.onSlices)
        lattice.planeMm = step > 0.0 ? step : spacing;
    else
        lattice.planeMm = own > 0.0 ? own : spacing;
    return lattice;
}

} // namespace

Result<PlacedFrames> placedFrames(const SegFile& seg, const Volume& volume, const QString& path)
{
    const Result<FrameLattice> lattice = latticeOf(seg, volume, path);
    if (!lattice)
        return tl::unexpected(lattice.error());
    const glm::dmat4 toLattice = lattice->toLattice();
    PlacedFrames frames{
        .lattice = *lattice, .toLattice = toLattice, .map = LatticeMap(volume.geometry, toLattice)};
    if (!frames.map.isSound())
        return failure(ErrorCode::UnsupportedFormat, path,
            Clause::saying("its pixels are out of all proportion to the study's"));
    return frames;
}

} // namespace core
