// SPDX-License-Identifier: Apache-2.0
#include "core/volume/WorldToIndex.h"

#include <algorithm>

namespace core {

WorldToIndex::WorldToIndex(const VolumeGeometry& geometry)
    : m_geometry(geometry)
    , m_inverse(geometry.worldToIndex())
{
    const glm::dmat3 axes(geometry.indexToWorld);
    m_normal = glm::normalize(glm::cross(axes[0], axes[1]));
    m_inSlice = glm::inverse(glm::dmat3(axes[0], axes[1], m_normal));
    for (const glm::dvec3& position : geometry.slicePositions)
        m_heights.push_back(glm::dot(position, m_normal));
}

glm::dvec3 WorldToIndex::operator()(const glm::dvec3& lps) const
{
    if (m_heights.size() < 2)
        return glm::dvec3(m_inverse * glm::dvec4(lps, 1.0));
    const double height = glm::dot(lps, m_normal);
    const auto above = std::upper_bound(m_heights.begin() + 1, m_heights.end() - 1, height);
    const auto k = std::size_t(above - m_heights.begin()) - 1;
    const double share = (height - m_heights[k]) / (m_heights[k + 1] - m_heights[k]);
    const glm::dvec3 origin =
        glm::mix(m_geometry.slicePositions[k], m_geometry.slicePositions[k + 1], share);
    const glm::dvec3 inSlice = m_inSlice * (lps - origin);
    return {inSlice.x, inSlice.y, double(k) + share};
}

} // namespace core
