// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/SegmentMeter.h"

#include "core/export/common/CheckSources.h"
#include "core/surface/DistanceAcross.h"
#include "core/surface/SegmentSurface.h"
#include "core/volume/UnevenSlices.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace core {

namespace {

void measureSurface(
    SegmentStatistics& found, const SegmentSurface& surface, const VolumeGeometry& geometry)
{
    std::vector<glm::dvec3> places;
    places.reserve(surface.vertices.size());
    for (const glm::vec3& vertex : surface.vertices)
        places.push_back(worldBetweenSlices(geometry, glm::dvec3(vertex)));
    double twice = 0.0;
    double sixfold = 0.0;
    for (const glm::uvec3& triangle : surface.triangles) {
        // Volumes are counted from a point nearby; far away, rounding would take their last digits.
        const glm::dvec3 a = places[triangle.x];
        const glm::dvec3 normal = glm::cross(places[triangle.y] - a, places[triangle.z] - a);
        twice += glm::length(normal);
        sixfold += glm::dot(a - places.front(), normal);
    }
    found.surfaceMm2 = twice / 2.0;
    // Negative where the index axes are left-handed.
    const double enclosedMm3 = std::abs(sixfold) / 6.0;
    if (found.surfaceMm2 > 0.0)
        found.sphericity =
            std::cbrt(36.0 * std::numbers::pi * enclosedMm3 * enclosedMm3) / found.surfaceMm2;
    const LongestDistance longest = longestDistance(places);
    found.longestMm = longest.length();
    found.acrossMm = distanceAcross(places, surface.triangles, longest.to - longest.from).length();
}

} // namespace

SegmentMeter::SegmentMeter(const VolumeGeometry& geometry, const VoxelEncoding& encoding,
    const Segment& segment, std::span<const std::uint8_t> labels)
    : m_geometry(geometry)
    , m_encoding(encoding)
    , m_segment(segment)
    , m_labels(labels)
    , m_ofCode(VoxelEncoding::codeCount, 0)
    , m_ofSlice(std::size_t(geometry.size.z), 0)
    , m_columnSums(m_ofSlice)
    , m_rowSums(m_ofSlice)
    , m_first(geometry.size)
{
}

void SegmentMeter::count(const VoxelBox& box, std::span<const std::uint16_t> codes)
{
    const glm::ivec3& size = m_geometry.size;
    std::size_t at = 0; // in the box
    for (int z = box.minimum.z; z < box.maximum.z; ++z) {
        const auto k = std::size_t(z);
        for (int y = box.minimum.y; y < box.maximum.y; ++y) {
            const std::size_t row =
                (k * std::size_t(size.y) + std::size_t(y)) * std::size_t(size.x);
            for (int x = box.minimum.x; x < box.maximum.x; ++x, ++at) {
                if (m_labels[row + std::size_t(x)] != m_segment.label)
                    continue;
                ++m_ofCode[codes[at]];
                ++m_ofSlice[k];
                m_columnSums[k] += x;
                m_rowSums[k] += y;
                m_first = glm::min(m_first, glm::ivec3(x, y, z));
                m_last = glm::max(m_last, glm::ivec3(x, y, z));
                ++m_voxels;
            }
        }
    }
}

SegmentStatistics SegmentMeter::statistics() const
{
    SegmentStatistics found;
    found.segment = m_segment;
    found.voxels = m_voxels;
    measureValues(found);
    measurePlace(found);
    measureSurface(found, segmentSurface(m_labels, m_segment.label, m_geometry.size), m_geometry);
    return found;
}

/// The least code that @p share percent of the voxels do not exceed.
int SegmentMeter::percentileCode(int share) const
{
    const std::int64_t wanted =
        std::max<std::int64_t>(1, (m_voxels * share + 99) / 100); // rounded up
    std::int64_t reached = 0;
    for (int code = 0; code < VoxelEncoding::codeCount; ++code) {
        reached += m_ofCode[std::size_t(code)];
        if (reached >= wanted)
            return code;
    }
    return VoxelEncoding::codeCount - 1;
}

void SegmentMeter::measureValues(SegmentStatistics& found) const
{
    std::int64_t sum = 0;
    int least = VoxelEncoding::codeCount;
    int greatest = 0;
    for (int code = 0; code < VoxelEncoding::codeCount; ++code) {
        const std::int64_t many = m_ofCode[std::size_t(code)];
        if (many == 0)
            continue;
        sum += many * code;
        least = std::min(least, code);
        greatest = code;
    }
    const double meanCode = double(sum) / double(m_voxels);
    double squares = 0.0;
    for (int code = least; code <= greatest; ++code)
        squares += double(m_ofCode[std::size_t(code)]) * (code - meanCode) * (code - meanCode);
    // Values are linear in codes.
    const double step = m_encoding.rescaleSlope * m_encoding.storedStep;
    found.minimum = m_encoding.value(least);
    found.maximum = m_encoding.value(greatest);
    found.mean = m_encoding.value(0) + step * meanCode;
    found.deviation = std::abs(step) * std::sqrt(squares / double(m_voxels));
    found.median = m_encoding.value(percentileCode(50));
    for (std::size_t i = 0; i < statisticsPercentiles.size(); ++i)
        found.percentiles[i] = m_encoding.value(percentileCode(statisticsPercentiles[i]));
}

void SegmentMeter::measurePlace(SegmentStatistics& found) const
{
    found.first = m_first;
    found.last = m_last;
    const glm::dmat3 axes(m_geometry.indexToWorld);
    const double pixelMm2 = glm::length(glm::cross(axes[0], axes[1]));
    const std::vector<double> thickness = sliceThicknessesMm(m_geometry);
    glm::dvec3 sum(0.0);
    for (std::size_t k = 0; k < m_ofSlice.size(); ++k) {
        const auto many = double(m_ofSlice[k]);
        found.millilitres += many * pixelMm2 * thickness[k] / 1000.0;
        sum += many * sliceOrigin(m_geometry, int(k)) + double(m_columnSums[k]) * axes[0]
            + double(m_rowSums[k]) * axes[1];
    }
    found.centroidLps = sum / double(m_voxels);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 index((corner & 1) != 0 ? m_last.x : m_first.x,
            (corner & 2) != 0 ? m_last.y : m_first.y, (corner & 4) != 0 ? m_last.z : m_first.z);
        const glm::dvec3 place = sliceOrigin(m_geometry, index.z) + double(index.x) * axes[0]
            + double(index.y) * axes[1];
        found.lowestLps = corner == 0 ? place : glm::min(found.lowestLps, place);
        found.highestLps = corner == 0 ? place : glm::max(found.highestLps, place);
    }
}

} // namespace core
