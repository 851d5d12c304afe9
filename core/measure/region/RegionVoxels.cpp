// SPDX-License-Identifier: Apache-2.0
#include "core/measure/region/RegionVoxels.h"

#include "core/measure/MeasuredSize.h"
#include "core/volume/UnevenSlices.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace core {

namespace {

/// Points are rounded to 1/1024 mm, so those of one slice lie in it only about so well.
constexpr double offSliceVoxels = 0.05;

/// The axis across the slice along the grid in which all points lie.
std::optional<int> axisAcross(const std::vector<glm::dvec3>& points)
{
    for (int axis = 2; axis >= 0; --axis) {
        const double first = points.front()[axis];
        if (std::all_of(points.begin(), points.end(), [&](const glm::dvec3& point) {
                return std::abs(point[axis] - first) <= offSliceVoxels;
            }))
            return axis;
    }
    return std::nullopt;
}

glm::ivec3 nearest(const glm::dvec3& index)
{
    return glm::ivec3(glm::floor(index + 0.5));
}

/// The voxels whose centres may lie between two places in index space, clipped to the volume.
VoxelBox boxBetween(const glm::dvec3& low, const glm::dvec3& high, const glm::ivec3& size)
{
    const glm::dvec3 most(size);
    return {.minimum = glm::ivec3(glm::clamp(glm::floor(low), glm::dvec3(0.0), most)),
        .maximum = glm::ivec3(glm::clamp(glm::ceil(high) + 1.0, glm::dvec3(0.0), most))};
}

} // namespace

RegionVoxels::RegionVoxels(const Measurement& measurement, const VolumeGeometry& geometry)
    : m_geometry(geometry)
{
    if (geometry.voxelCount() == 0 || measurement.pointsLps.size() < pointsOf(measurement.kind))
        return;
    std::vector<glm::dvec3> indices;
    for (const glm::dvec3& point : measurement.pointsLps)
        indices.push_back(geometry.toIndex(point));
    if (measurement.kind == Measurement::Kind::Probe) {
        if (const glm::ivec3 voxel = nearest(indices.front()); geometry.contains(voxel))
            m_samples.push_back(voxel);
    } else if (measurement.kind == Measurement::Kind::Ball) {
        m_centreLps = truePlace(geometry, measurement.pointsLps[0]);
        m_radiusMm = glm::distance(m_centreLps, truePlace(geometry, measurement.pointsLps[1]));
        takeBall();
    } else if (measurement.isPlaneRegion()) {
        m_shape = planeShape(measurement);
        if (!m_shape)
            return;
        if (const std::optional<int> axis = axisAcross(indices))
            takeSlice(*axis, indices.front()[*axis]);
        else
            takeSamples();
    }
}

void RegionVoxels::takeBall()
{
    // In each slice its columns and rows reach as far as in a ball; which slices it meets is asked
    // of their places, which need not be even.
    const glm::dmat3 toIndex(m_geometry.worldToIndex());
    const glm::dmat3 rows = glm::transpose(toIndex);
    const glm::dmat3 axes(m_geometry.indexToWorld);
    const glm::dvec3 normal = glm::normalize(glm::cross(axes[0], axes[1]));
    VoxelBox box{.minimum = m_geometry.size, .maximum = glm::ivec3(0)};
    for (int z = 0; z < m_geometry.size.z; ++z) {
        const glm::dvec3 origin = worldBetweenSlices(m_geometry, {0.0, 0.0, double(z)});
        const double height = glm::dot(m_centreLps - origin, normal);
        if (std::abs(height) > m_radiusMm)
            continue;
        // Columns and rows of the centre's foot in this slice.
        const glm::dvec3 foot = toIndex * (m_centreLps - height * normal - origin);
        const glm::dvec3 reach(
            m_radiusMm * glm::length(rows[0]), m_radiusMm * glm::length(rows[1]), 0.0);
        const VoxelBox slice =
            boxBetween(foot - reach, foot + reach, {m_geometry.size.x, m_geometry.size.y, 1});
        if (slice.minimum.x >= slice.maximum.x || slice.minimum.y >= slice.maximum.y)
            continue;
        box.minimum = glm::min(box.minimum, glm::ivec3(slice.minimum.x, slice.minimum.y, z));
        box.maximum = glm::max(box.maximum, glm::ivec3(slice.maximum.x, slice.maximum.y, z + 1));
    }
    takeBox(box);
}

void RegionVoxels::takeSlice(int axis, double place)
{
    const int slice = int(std::clamp(std::floor(place + 0.5), -1.0, 1e9));
    if (slice < 0 || slice >= m_geometry.size[axis])
        return;
    m_axis = axis;
    m_place = place;
    glm::dvec3 low(std::numeric_limits<double>::max());
    glm::dvec3 high(std::numeric_limits<double>::lowest());
    for (const glm::dvec2& corner : m_shape->border()) {
        const glm::dvec3 index = m_geometry.toIndex(m_shape->toLps(corner));
        low = glm::min(low, index);
        high = glm::max(high, index);
    }
    // The corners of an ellipse lie on it; between them it reaches a little farther.
    const glm::dvec3 more = (high - low) * 0.01 + offSliceVoxels;
    VoxelBox box = boxBetween(low - more, high + more, m_geometry.size);
    box.minimum[axis] = slice;
    box.maximum[axis] = slice + 1;
    takeBox(box);
}

void RegionVoxels::takeSamples()
{
    glm::dvec2 low(std::numeric_limits<double>::max());
    glm::dvec2 high(std::numeric_limits<double>::lowest());
    for (const glm::dvec2& corner : m_shape->border()) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    const glm::dvec2 extent = (high - low) * 1.01;
    const glm::dvec3 spacing = m_geometry.spacingMm();
    const double finest = std::min({spacing.x, spacing.y, spacing.z});
    const double step = std::max(finest, std::sqrt(extent.x * extent.y / mostSamples));
    const glm::ivec2 half = glm::ivec2(glm::floor(extent / (2.0 * step))) + 1;
    const glm::dvec2 middle = (low + high) / 2.0;
    for (int y = -half.y; y <= half.y; ++y) {
        for (int x = -half.x; x <= half.x; ++x) {
            const glm::dvec2 place = middle + step * glm::dvec2(x, y);
            if (!m_shape->contains(place))
                continue;
            const glm::ivec3 voxel = nearest(m_geometry.toIndex(m_shape->toLps(place)));
            if (m_geometry.contains(voxel))
                m_samples.push_back(voxel);
        }
    }
}

void RegionVoxels::takeBox(VoxelBox box)
{
    if (glm::any(glm::lessThanEqual(box.maximum, box.minimum)))
        return;
    const glm::ivec3 extent = box.maximum - box.minimum;
    const int thick = std::max(1, mostVoxelsOfBox / std::max(1, extent.x * extent.y));
    for (int z = box.minimum.z; z < box.maximum.z; z += thick) {
        VoxelBox part = box;
        part.minimum.z = z;
        part.maximum.z = std::min(z + thick, box.maximum.z);
        m_boxes.push_back(part);
    }
}

bool RegionVoxels::contains(const glm::ivec3& voxel) const
{
    glm::dvec3 index(voxel);
    if (!m_shape) {
        // The border lies inside, whatever becomes of the last digits.
        constexpr double littleMm = 1e-6;
        return glm::distance(worldBetweenSlices(m_geometry, index), m_centreLps)
            <= m_radiusMm + littleMm;
    }
    index[m_axis] = m_place;
    return m_shape->contains(m_shape->inPlane(m_geometry.toWorld(index)));
}

std::vector<std::uint16_t> RegionVoxels::codesInside(
    const VoxelBox& box, std::span<const std::uint16_t> codes) const
{
    std::vector<std::uint16_t> inside;
    std::size_t i = 0;
    for (int z = box.minimum.z; z < box.maximum.z; ++z) {
        for (int y = box.minimum.y; y < box.maximum.y; ++y) {
            for (int x = box.minimum.x; x < box.maximum.x; ++x, ++i) {
                if (contains({x, y, z}))
                    inside.push_back(codes[i]);
            }
        }
    }
    return inside;
}

} // namespace core
