// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/labels/HeldVoxels.h"

#include <algorithm>

namespace core {

std::span<const std::uint8_t> labelsOfPlane(std::span<const LabelPlane> planes, std::uint8_t plane)
{
    const auto found = std::find_if(planes.begin(), planes.end(),
        [plane](const LabelPlane& each) { return each.plane == plane; });
    return found == planes.end() ? std::span<const std::uint8_t>() : found->labels;
}

std::set<std::uint8_t> planesOf(const EditableVoxels& editable)
{
    std::set<std::uint8_t> planes;
    for (const EditableVoxels::PlaneLabels& each : editable.outside)
        planes.insert(each.plane);
    if (editable.inside) {
        for (const EditableVoxels::PlaneLabels& each : *editable.inside)
            planes.insert(each.plane);
    }
    return planes;
}

HeldVoxels::HeldVoxels(const EditableVoxels& editable, std::span<const LabelPlane> planes)
    : m_editable(editable)
    , m_outside(read(editable.outside, planes))
{
    if (editable.inside)
        m_inside = read(*editable.inside, planes);
}

bool HeldVoxels::holds(const glm::ivec3& voxel, std::size_t place, int code) const
{
    if (code < m_editable.lowCode || code > m_editable.highCode)
        return true;
    if (const std::optional<VoxelBox>& box = m_editable.box; box
        && (glm::any(glm::lessThan(voxel, box->minimum))
            || glm::any(glm::greaterThanEqual(voxel, box->maximum))))
        return true;
    return (m_inside && !isInOneOf(*m_inside, place)) || isInOneOf(m_outside, place);
}

std::vector<HeldVoxels::Read> HeldVoxels::read(
    const std::vector<EditableVoxels::PlaneLabels>& listed, std::span<const LabelPlane> planes)
{
    std::vector<Read> found;
    for (const EditableVoxels::PlaneLabels& each : listed)
        found.push_back({labelsOfPlane(planes, each.plane), each.labels});
    return found;
}

bool HeldVoxels::isInOneOf(const std::vector<Read>& listed, std::size_t place)
{
    return std::any_of(listed.begin(), listed.end(), [place](const Read& each) {
        return place < each.labels.size() && each.labels[place] != 0
            && each.wanted[each.labels[place]];
    });
}

} // namespace core
