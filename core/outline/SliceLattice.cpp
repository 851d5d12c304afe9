// SPDX-License-Identifier: Apache-2.0
#include "core/outline/SliceLattice.h"

#include "core/edits/engine/SlicePlane.h"
#include "core/volume/ClipRegion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace core {

namespace {

SliceLattice latticeOnGrid(const VolumeGeometry& geometry, const SlicePlane::OnGrid& onGrid)
{
    SliceLattice lattice;
    if (onGrid.slice < 0 || onGrid.slice >= geometry.size[onGrid.axis])
        return lattice;
    // Columns run along the first of the other two axes, because voxels of a box come x fastest.
    const int column = onGrid.axis == 0 ? 1 : 0;
    const int row = onGrid.axis == 2 ? 1 : 2;
    VoxelBox box{.minimum = glm::ivec3(0), .maximum = geometry.size};
    box.minimum[onGrid.axis] = onGrid.slice;
    box.maximum[onGrid.axis] = onGrid.slice + 1;
    lattice.size = {geometry.size[column], geometry.size[row]};
    lattice.originLps = geometry.toWorld(glm::dvec3(box.minimum));
    lattice.columnLps = glm::dvec3(geometry.indexToWorld[column]);
    lattice.rowLps = glm::dvec3(geometry.indexToWorld[row]);
    lattice.box = box;
    return lattice;
}

SliceLattice obliqueLattice(const VolumeGeometry& geometry, const glm::dvec3& placeLps,
    const glm::dvec3& rightLps, const glm::dvec3& downLps)
{
    SliceLattice lattice;
    const glm::dvec3 normal = glm::cross(rightLps, downLps);
    const std::vector<glm::dvec3> section =
        boxSection(wholeVolume(geometry).box, geometry, placeLps, normal);
    if (section.size() < 3)
        return lattice;
    // From the middle of the volume, so that it does not matter through which point it was asked.
    const glm::dvec3 middle = geometry.toWorld((glm::dvec3(geometry.size) - 1.0) / 2.0);
    const glm::dvec3 foot = middle + glm::dot(placeLps - middle, normal) * normal;
    glm::dvec2 low(std::numeric_limits<double>::max());
    glm::dvec2 high(std::numeric_limits<double>::lowest());
    for (const glm::dvec3& corner : section) {
        const glm::dvec3 way = corner - foot;
        const glm::dvec2 place(glm::dot(way, rightLps), glm::dot(way, downLps));
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    const glm::dvec3 spacing = geometry.spacingMm();
    const glm::dvec2 extent = high - low;
    const double finest = std::min({spacing.x, spacing.y, spacing.z});
    // A pixel more at each end is left for rounding.
    const double coarsest = std::sqrt(
        (extent.x + finest) * (extent.y + finest) / (SliceLattice::mostObliquePixels / 2));
    const double stepMm = std::max(finest, coarsest);
    lattice.size = glm::ivec2(glm::floor(extent / stepMm)) + 1;
    const glm::dvec2 first = (low + high) / 2.0 - glm::dvec2(lattice.size - 1) * stepMm / 2.0;
    lattice.originLps = foot + first.x * rightLps + first.y * downLps;
    lattice.columnLps = stepMm * rightLps;
    lattice.rowLps = stepMm * downLps;
    return lattice;
}

bool areNear(const glm::dvec3& a, const glm::dvec3& b)
{
    constexpr double sameMm = 1e-3;
    return glm::all(glm::lessThan(glm::abs(a - b), glm::dvec3(sameMm)));
}

} // namespace

bool SliceLattice::isAt(const SliceLattice& other) const
{
    if (size != other.size || box.has_value() != other.box.has_value())
        return false;
    if (box)
        return box->minimum == other.box->minimum && box->maximum == other.box->maximum;
    return areNear(cornerLps({0, 0}), other.cornerLps({0, 0}))
        && areNear(cornerLps({size.x, 0}), other.cornerLps({size.x, 0}))
        && areNear(cornerLps({0, size.y}), other.cornerLps({0, size.y}));
}

glm::dvec3 SliceLattice::cornerLps(const glm::ivec2& corner) const
{
    return originLps + (corner.x - 0.5) * columnLps + (corner.y - 0.5) * rowLps;
}

glm::dvec2 SliceLattice::inPixels(const glm::dvec3& placeLps) const
{
    // The foot of the place in the slice, whose axes need not be perpendicular.
    const glm::dvec3 way = placeLps - originLps;
    const double columns = glm::dot(columnLps, columnLps);
    const double rows = glm::dot(rowLps, rowLps);
    const double both = glm::dot(columnLps, rowLps);
    const double x = glm::dot(way, columnLps);
    const double y = glm::dot(way, rowLps);
    return glm::dvec2(x * rows - y * both, y * columns - x * both) / (columns * rows - both * both);
}

glm::ivec2 SliceLattice::cornerAt(const glm::dvec3& placeLps) const
{
    const glm::dvec2 nearest = glm::floor(inPixels(placeLps) + 1.0);
    return glm::ivec2(glm::clamp(nearest, glm::dvec2(0.0), glm::dvec2(size)));
}

std::optional<glm::ivec2> SliceLattice::pixelAt(const glm::dvec3& placeLps) const
{
    const glm::dvec2 nearest = glm::floor(inPixels(placeLps) + 0.5);
    if (!(nearest.x >= 0.0 && nearest.y >= 0.0 && nearest.x < size.x && nearest.y < size.y))
        return std::nullopt;
    return glm::ivec2(nearest);
}

SliceLattice sliceLattice(const VolumeGeometry& geometry, const glm::dvec3& throughLps,
    const glm::dvec3& rightLps, const glm::dvec3& downLps)
{
    const SlicePlane plane = slicePlane(geometry, glm::cross(rightLps, downLps), throughLps);
    return plane.onGrid ? latticeOnGrid(geometry, *plane.onGrid)
                        : obliqueLattice(geometry, throughLps, rightLps, downLps);
}

std::vector<glm::ivec3> nearestVoxels(const SliceLattice& lattice, const VolumeGeometry& geometry)
{
    std::vector<glm::ivec3> voxels;
    if (lattice.empty())
        return voxels;
    voxels.reserve(std::size_t(lattice.size.x) * std::size_t(lattice.size.y));
    const glm::dmat3 toIndex(geometry.worldToIndex());
    const glm::dvec3 origin = geometry.toIndex(lattice.originLps);
    const glm::dvec3 column = toIndex * lattice.columnLps;
    const glm::dvec3 row = toIndex * lattice.rowLps;
    const glm::dvec3 last(geometry.size - 1);
    for (int y = 0; y < lattice.size.y; ++y) {
        for (int x = 0; x < lattice.size.x; ++x) {
            const glm::dvec3 place = origin + double(x) * column + double(y) * row;
            voxels.emplace_back(glm::clamp(glm::floor(place + 0.5), glm::dvec3(0.0), last));
        }
    }
    return voxels;
}

} // namespace core
