// SPDX-License-Identifier: Apache-2.0
#include "core/volume/UnevenSlices.h"

#include <algorithm>
#include <cmath>

namespace core {

std::vector<double> sliceThicknessesMm(const VolumeGeometry& geometry)
{
    const glm::dmat3 axes(geometry.indexToWorld);
    const glm::dvec3 normal = glm::normalize(glm::cross(axes[0], axes[1]));
    const auto slices = std::size_t(geometry.size.z);
    if (geometry.slicePositions.empty() || slices < 2)
        return std::vector<double>(slices, std::abs(glm::dot(normal, axes[2])));
    std::vector<double> thickness(slices);
    const auto gap = [&](std::size_t k) {
        return std::abs(
            glm::dot(normal, geometry.slicePositions[k + 1] - geometry.slicePositions[k]));
    };
    for (std::size_t k = 0; k < slices; ++k) {
        const double below = gap(k == 0 ? 0 : k - 1);
        const double above = gap(k + 1 == slices ? k - 1 : k);
        thickness[k] = (below + above) / 2.0;
    }
    return thickness;
}

glm::dvec3 worldBetweenSlices(const VolumeGeometry& geometry, const glm::dvec3& index)
{
    if (geometry.slicePositions.empty())
        return geometry.toWorld(index);
    const int last = int(geometry.slicePositions.size()) - 1;
    const int k = std::clamp(int(std::floor(index.z)), 0, std::max(0, last - 1));
    const glm::dvec3 here = geometry.slicePositions[std::size_t(k)];
    const glm::dvec3 step = last > 0 ? geometry.slicePositions[std::size_t(k + 1)] - here
                                     : glm::dvec3(geometry.indexToWorld[2]);
    return here + step * (index.z - k)
        + glm::dmat3(geometry.indexToWorld) * glm::dvec3(index.x, index.y, 0.0);
}

} // namespace core
