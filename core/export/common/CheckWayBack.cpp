// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/CheckWayBack.h"

#include "core/export/common/CheckSources.h"
#include "core/export/common/MaskSelection.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

/// Beyond the half: rounding of places to 1/65536, and to whole ones where they are near to it.
constexpr double mostVoxelsAway = 0.5 + 0.01 + 1e-3;

std::size_t indexIn(const glm::ivec3& size, const glm::ivec3& voxel)
{
    return (std::size_t(voxel.z) * std::size_t(size.y) + std::size_t(voxel.y)) * std::size_t(size.x)
        + std::size_t(voxel.x);
}

/// Where the repaired volume has a place; slices by their heights where they lie unevenly.
class Finder {
public:
    explicit Finder(const VolumeGeometry& repaired)
        : m_toIndex(repaired.worldToIndex())
    {
        const glm::dmat3 axes(repaired.indexToWorld);
        m_normal = glm::normalize(glm::cross(axes[0], axes[1]));
        for (const glm::dvec3& position : repaired.slicePositions)
            m_heights.push_back(glm::dot(position, m_normal));
        m_inPlane = glm::inverse(glm::dmat3(axes[0], axes[1], m_normal));
        m_positions = repaired.slicePositions;
    }

    [[nodiscard]] glm::dvec3 operator()(const glm::dvec3& place) const
    {
        if (m_heights.empty())
            return glm::dvec3(m_toIndex * glm::dvec4(place, 1.0));
        const double height = glm::dot(place, m_normal);
        const auto above = std::lower_bound(m_heights.begin(), m_heights.end(), height);
        auto nearest = std::min(above, m_heights.end() - 1);
        if (above != m_heights.begin() && height - *(above - 1) < std::abs(*nearest - height))
            nearest = above - 1;
        const auto k = nearest - m_heights.begin();
        const glm::dvec3 sideways = m_inPlane * (place - m_positions[std::size_t(k)]);
        // Such slices stay where they are: anything off their planes is wrong.
        return {sideways.x, sideways.y, double(k) + sideways.z};
    }

private:
    glm::dmat4 m_toIndex;
    glm::dvec3 m_normal{0.0};
    glm::dmat3 m_inPlane{1.0};
    std::vector<double> m_heights;
    std::vector<glm::dvec3> m_positions;
};

Clause differenceAt(const glm::ivec3& voxel, const Clause& what)
{
    return Clause::saying(
        "on the way back to slice %1, voxel (%2, %3): %4", voxel.z + 1, voxel.x, voxel.y, what);
}

} // namespace

Clause differenceOfWayBack(const WayBack& back, const Volume& volume, const ExportRequest& onSlices,
    const ExportRequest& repaired)
{
    const VolumeGeometry& slices = back.slices().geometry;
    const glm::ivec3 repairedSize = volume.geometry.size;
    const glm::dmat3 axes(slices.indexToWorld);
    const Finder find(volume.geometry);
    for (int k = 0; k < slices.size.z; ++k) {
        const glm::dvec3 origin = sliceOrigin(slices, k);
        for (int j = 0; j < slices.size.y; ++j) {
            const glm::dvec3 row = origin + axes[1] * double(j);
            for (int i = 0; i < slices.size.x; ++i) {
                const glm::dvec3 place = find(row + axes[0] * double(i));
                const glm::ivec3 first = back.firstVoxels()[std::size_t(k)];
                const glm::ivec3 taken = first + glm::ivec3(i, j, 0);
                const glm::dvec3 away = glm::abs(place - glm::dvec3(taken));
                if (std::max({away.x, away.y, away.z}) > mostVoxelsAway)
                    return differenceAt({i, j, k}, Clause::saying("it lies elsewhere"));
                if (!volume.geometry.contains(taken))
                    return differenceAt({i, j, k}, Clause::saying("it lies outside"));
                for (std::size_t p = 0; p < onSlices.planes.size(); ++p) {
                    if (onSlices.planes[p].labels[indexIn(slices.size, {i, j, k})]
                        != repaired.planes[p].labels[indexIn(repairedSize, taken)])
                        return differenceAt({i, j, k}, Clause::saying("it holds something else"));
                }
            }
        }
    }
    return {};
}

ReportLines beyondSlices(const WayBack& back, const Volume& volume, const ExportRequest& repaired)
{
    const glm::ivec3 size = volume.geometry.size;
    const glm::ivec3 ofSlice = back.slices().geometry.size;
    ReportLines sentences;
    for (const Segment& segment : repaired.segments) {
        const LabelPlaneView* plane = planeOf(repaired, segment);
        if (plane == nullptr)
            continue;
        const auto isIt = [&](std::uint8_t label) { return label == segment.label; };
        const auto all = std::count_if(plane->labels.begin(), plane->labels.end(), isIt);
        std::ptrdiff_t reached = 0;
        for (const glm::ivec3& first : back.firstVoxels()) {
            for (int j = 0; j < ofSlice.y; ++j) {
                const auto row = plane->labels.subspan(
                    indexIn(size, first + glm::ivec3(0, j, 0)), std::size_t(ofSlice.x));
                reached += std::count_if(row.begin(), row.end(), isIt);
            }
        }
        if (const std::ptrdiff_t lost = all - reached; lost > 0)
            sentences += ReportSentence{
                ReportCode::BeyondImages, {std::int64_t(lost), std::int64_t(all), segment.name}};
    }
    return sentences;
}

} // namespace core
