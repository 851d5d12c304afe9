// SPDX-License-Identifier: Apache-2.0
#include "tests/reenactment/sighted/Inspection.h"

#include <algorithm>

namespace reenact {

namespace {

constexpr int firstStride = 2; ///< slices
/// How far from a voxel a reading is still read for it, in voxels.
constexpr double nearVoxels = 1.5;

} // namespace

Inspection::Inspection(Reader& reader, const core::VolumeGeometry& geometry, const Mask& seen)
    : m_reader(reader)
    , m_geometry(geometry)
    , m_belief(geometry)
{
    const int slices = geometry.size.z;
    for (int slice = 0; slice < slices; slice += firstStride)
        open(slice, seen);
    if (!m_belief.has(slices - 1))
        open(slices - 1, seen);
    m_organ = m_belief.organ();
    const Mask first = meant(seen);
    const auto count = std::size_t(geometry.size.x) * std::size_t(geometry.size.y);
    for (int slice = 0; slice < slices; ++slice) {
        bool isSuspect = false;
        for (int near = std::max(0, slice - 1); near <= std::min(slices - 1, slice + 1); ++near) {
            const auto begin = std::ptrdiff_t(std::size_t(near) * count);
            isSuspect = isSuspect
                || !std::equal(first.values.begin() + begin,
                    first.values.begin() + begin + std::ptrdiff_t(count),
                    seen.values.begin() + begin);
        }
        if (isSuspect && !m_belief.has(slice))
            open(slice, seen);
    }
    m_organ = m_belief.organ();
}

void Inspection::open(int slice, const Mask& seen)
{
    const glm::dvec3 normal = m_geometry.direction()[2];
    SeenPlane view = open(m_geometry.toWorld(glm::dvec3(0.0, 0.0, double(slice))), normal, seen);
    m_belief.take(slice, view);
    m_views.insert_or_assign(slice, std::move(view));
}

SeenPlane Inspection::open(
    const glm::dvec3& placeLps, const glm::dvec3& normalLps, const Mask& seen)
{
    return m_reader.look(CuttingPlane::through(m_geometry, placeLps, normalLps), seen);
}

Mask Inspection::meant(const Mask& seen) const
{
    return meantOf(seen, m_organ, m_geometry);
}

double Inspection::edgeShareNear(const std::vector<glm::ivec3>& voxels) const
{
    Mask region{m_geometry.size, std::vector<std::uint8_t>(m_organ.values.size(), 0)};
    for (const glm::ivec3& voxel : voxels)
        region.at(voxel) = 1;
    const Field off = distanceTo(region);
    const glm::dmat4 toIndex = m_geometry.worldToIndex();
    double sum = 0.0;
    int views = 0;
    for (const auto& [slice, view] : m_views) {
        bool isNear = false;
        const double share = edgeShare(view, [&](const glm::dvec3& place) {
            const glm::dvec3 index(toIndex * glm::dvec4(place, 1.0));
            const bool isHere = sampled(off, index) <= nearVoxels;
            isNear = isNear || isHere;
            return isHere;
        });
        sum += share;
        views += isNear ? 1 : 0;
    }
    return views == 0 ? 0.0 : sum / double(views);
}

} // namespace reenact
