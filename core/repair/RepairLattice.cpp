// SPDX-License-Identifier: Apache-2.0
#include "core/repair/RepairLattice.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

/// Nearer to a whole voxel than this counts as whole: such slices keep their very values.
constexpr std::int64_t nearlyWhole = wholeVoxel / 100;
/// A few slices that lie close are no reason for hundreds in between.
constexpr double finestShare = 0.25;
constexpr double splitRatio = 1.5;
/// What positions that make no sense would otherwise ask for.
constexpr double mostVoxelsAlong = 65535.0;

std::int64_t floorVoxel(std::int64_t place)
{
    return place >> 16;
}

std::int64_t quantised(double voxels)
{
    const auto place = std::int64_t(std::llround(voxels * double(wholeVoxel)));
    const std::int64_t whole = floorVoxel(place + wholeVoxel / 2) * wholeVoxel;
    return std::abs(place - whole) <= nearlyWhole ? whole : place;
}

glm::dvec3 positionOf(const VolumeGeometry& slices, int k)
{
    return slices.slicePositions.empty() ? slices.toWorld({0.0, 0.0, double(k)})
                                         : slices.slicePositions[std::size_t(k)];
}

glm::dvec3 normalOf(const VolumeGeometry& slices)
{
    const glm::dmat3 axes(slices.indexToWorld);
    return glm::normalize(glm::cross(axes[0], axes[1]));
}

double usualOf(std::vector<double> gaps)
{
    const std::size_t middle = (gaps.size() - 1) / 2;
    std::nth_element(gaps.begin(), gaps.begin() + std::ptrdiff_t(middle), gaps.end());
    return gaps[middle];
}

/// How many steps the lattice makes from the first slice to the last.
double stepsOf(const std::vector<double>& gaps, double depth, SeriesRepair::Lattice lattice)
{
    const double usual = usualOf(gaps);
    if (lattice == SeriesRepair::Lattice::Filled) {
        double steps = 0.0;
        for (const double gap : gaps)
            steps += std::max(1.0, std::round(gap / usual));
        return steps;
    }
    const double finest =
        std::max(*std::min_element(gaps.begin(), gaps.end()), finestShare * usual);
    return std::max(1.0, std::round(depth / finest));
}

/// Why positions are none of a stack, or want too much; empty if they are sound.
Clause unsound(const VolumeGeometry& slices, const SeriesRepair& repair)
{
    const std::vector<double> gaps = sliceGapsMm(slices);
    const bool ascending =
        std::all_of(gaps.begin(), gaps.end(), [](double gap) { return gap > 0.0; });
    const glm::dvec3 whole = positionOf(slices, slices.size.z - 1) - positionOf(slices, 0);
    const glm::dvec3 spacing = slices.spacingMm();
    const double sideways = glm::length(whole) / std::min(spacing.x, spacing.y);
    if (!ascending || !(sideways < 16.0 * mostVoxelsAlong))
        return Clause::saying("its slices do not follow each other");
    const double steps = stepsOf(gaps, glm::dot(whole, normalOf(slices)), repair.lattice);
    if (repair.lattice != SeriesRepair::Lattice::AsIs && !(steps < mostVoxelsAlong))
        return Clause::saying("it would need %1 slices", steps);
    if (repair.tilt
        && !(sideways + double(std::max(slices.size.x, slices.size.y)) < mostVoxelsAlong))
        return Clause::saying("its slices lie too far apart sideways");
    return {};
}

/// Moves the lattice's first voxel to the least place, and lets it reach the greatest.
void growInPlane(RepairLattice& lattice, std::int64_t LatticePlace::*axis, int column)
{
    const auto [least, greatest] = std::minmax_element(lattice.places.begin(), lattice.places.end(),
        [axis](const LatticePlace& a, const LatticePlace& b) { return a.*axis < b.*axis; });
    // As far as the nearest voxel of every slice's: positions that wander by less add none.
    const std::int64_t low = floorVoxel((*least).*axis + wholeVoxel / 2);
    const std::int64_t high = floorVoxel((*greatest).*axis + wholeVoxel / 2);
    VolumeGeometry& geometry = lattice.geometry;
    geometry.size[column] += int(high - low);
    const glm::dvec4 shift = geometry.indexToWorld[column] * double(low);
    geometry.indexToWorld[3] += shift;
    for (glm::dvec3& position : geometry.slicePositions)
        position += glm::dvec3(shift);
    for (LatticePlace& place : lattice.places)
        place.*axis -= low * wholeVoxel;
}

} // namespace

glm::ivec3 LatticePlace::nearest() const
{
    constexpr std::int64_t half = wholeVoxel / 2;
    return {int(floorVoxel(x + half)), int(floorVoxel(y + half)), int(floorVoxel(z + half))};
}

std::vector<double> sliceGapsMm(const VolumeGeometry& slices)
{
    const glm::dvec3 normal = normalOf(slices);
    std::vector<double> gaps;
    for (int k = 1; k < slices.size.z; ++k)
        gaps.push_back(glm::dot(positionOf(slices, k) - positionOf(slices, k - 1), normal));
    return gaps;
}

RepairLattice repairLattice(const VolumeGeometry& slices, const SeriesRepair& repair)
{
    const int count = slices.size.z;
    const glm::dvec3 normal = normalOf(slices);
    const glm::dvec3 first = positionOf(slices, 0);
    const glm::dvec3 whole = positionOf(slices, count - 1) - first;
    const double depth = glm::dot(whole, normal);
    // From one plane to the next, per millimetre along the normal.
    const glm::dvec3 along = repair.tilt ? normal : whole / depth;
    const bool even = repair.lattice != SeriesRepair::Lattice::AsIs;
    const int steps = even ? int(stepsOf(sliceGapsMm(slices), depth, repair.lattice)) : count - 1;
    const double step = depth / double(steps);

    RepairLattice lattice;
    VolumeGeometry& geometry = lattice.geometry;
    geometry.size = {slices.size.x, slices.size.y, steps + 1};
    geometry.indexToWorld[0] = slices.indexToWorld[0];
    geometry.indexToWorld[1] = slices.indexToWorld[1];
    geometry.indexToWorld[2] = glm::dvec4(along * step, 0.0);
    geometry.indexToWorld[3] = glm::dvec4(first, 1.0);
    const glm::dmat3 axes(slices.indexToWorld);
    const glm::dmat3 toPlane = glm::inverse(glm::dmat3(axes[0], axes[1], normal));
    for (int k = 0; k < count; ++k) {
        const glm::dvec3 position = positionOf(slices, k);
        const double height = glm::dot(position - first, normal);
        const glm::dvec3 onLine = first + along * height;
        const glm::dvec3 sideways = toPlane * (position - onLine);
        lattice.places.push_back({.x = quantised(sideways.x),
            .y = quantised(sideways.y),
            .z = even ? quantised(height / step) : std::int64_t(k) * wholeVoxel});
        // Without another lattice the planes stay where they are.
        if (!even && !slices.slicePositions.empty())
            geometry.slicePositions.push_back(onLine);
    }
    growInPlane(lattice, &LatticePlace::x, 0);
    growInPlane(lattice, &LatticePlace::y, 1);
    return lattice;
}

std::vector<SliceRun> gapParts(const VolumeGeometry& slices)
{
    const std::vector<double> gaps = sliceGapsMm(slices);
    std::vector<SliceRun> parts{{.first = 0, .count = 1}};
    for (std::size_t gap = 0; gap < gaps.size(); ++gap) {
        const double before = gap > 0 ? gaps[gap - 1] : gaps[gap];
        const double after = gap + 1 < gaps.size() ? gaps[gap + 1] : gaps[gap];
        if (gaps[gap] > splitRatio * std::min(before, after))
            parts.push_back({.first = int(gap) + 1, .count = 1});
        else
            ++parts.back().count;
    }
    return parts;
}

VolumeGeometry geometryOfPart(const VolumeGeometry& slices, const SliceRun& part)
{
    if (part.count == slices.size.z)
        return slices;
    VolumeGeometry geometry = slices;
    geometry.size.z = part.count;
    geometry.slicePositions.clear();
    const glm::dvec3 first = positionOf(slices, part.first);
    geometry.indexToWorld[3] = glm::dvec4(first, 1.0);
    if (part.count == 1)
        return geometry;
    const glm::dvec3 step =
        (positionOf(slices, part.first + part.count - 1) - first) / double(part.count - 1);
    geometry.indexToWorld[2] = glm::dvec4(step, 0.0);
    double worst = 0.0;
    std::vector<glm::dvec3> positions;
    for (int k = 0; k < part.count; ++k) {
        positions.push_back(positionOf(slices, part.first + k));
        worst = std::max(worst, glm::length(positions.back() - (first + step * double(k))));
    }
    if (worst > evenSlicesToleranceMm(glm::length(step)))
        geometry.slicePositions = std::move(positions);
    return geometry;
}

Clause repairObstacle(const VolumeGeometry& slices, const SeriesRepair& repair)
{
    VolumeGeometry part = slices;
    if (repair.part != 0) {
        const std::vector<SliceRun> parts = gapParts(slices);
        if (repair.part > int(parts.size()))
            return parts.size() == 1
                ? Clause::saying("it has no gap to be split at")
                : Clause::saying("its gaps divide it into %1 parts only", parts.size());
        part = geometryOfPart(slices, parts[std::size_t(repair.part - 1)]);
    }
    if (repair.movesVoxels() && part.size.z < 2)
        return Clause::saying("it is a single image");
    // Slices that follow each other sideways are no stack that could be set upright.
    constexpr double mostShearDegrees = 60.0;
    if (repair.tilt && part.shearAngleDegrees() > mostShearDegrees)
        return Clause::saying("its slices lean by more than %1°", mostShearDegrees);
    return repair.movesVoxels() ? unsound(part, repair) : Clause();
}

VolumeGeometry repairedGeometry(const VolumeGeometry& slices, const SeriesRepair& repair)
{
    VolumeGeometry geometry = slices;
    if (repair.givenSpacingMm) {
        const glm::dvec3 spacing = slices.spacingMm();
        for (int axis = 0; axis < 3; ++axis)
            geometry.indexToWorld[axis] = geometry.indexToWorld[axis] / spacing[axis]
                * (*repair.givenSpacingMm)[std::size_t(axis)];
    }
    if (repair.part != 0)
        geometry = geometryOfPart(slices, gapParts(slices)[std::size_t(repair.part - 1)]);
    return repair.movesVoxels() ? repairLattice(geometry, repair).geometry : geometry;
}

} // namespace core
