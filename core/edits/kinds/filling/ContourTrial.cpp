// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/filling/ContourTrial.h"

#include "core/contour/ContourEvolution.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/kinds/filling/EvolveContour.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace core {

namespace {

std::span<const std::uint8_t> labelsOfPlane(
    std::span<const ContourPlane> planes, std::uint8_t plane)
{
    const auto found = std::find_if(planes.begin(), planes.end(),
        [plane](const ContourPlane& each) { return each.plane == plane; });
    return found == planes.end() ? std::span<const std::uint8_t>() : found->labels;
}

/// The rule of EditableVoxels, voxel by voxel, on planes as a whole.
class HeldVoxels {
public:
    HeldVoxels(const EditableVoxels& editable, std::span<const ContourPlane> planes)
        : m_editable(editable)
        , m_outside(read(editable.outside, planes))
    {
        if (editable.inside)
            m_inside = read(*editable.inside, planes);
    }
    /// @param place of the voxel in the volume, x fastest
    [[nodiscard]] bool holds(const glm::ivec3& voxel, std::size_t place, int code) const
    {
        if (code < m_editable.lowCode || code > m_editable.highCode)
            return true;
        if (const std::optional<VoxelBox>& box = m_editable.box; box
            && (glm::any(glm::lessThan(voxel, box->minimum))
                || glm::any(glm::greaterThanEqual(voxel, box->maximum))))
            return true;
        return (m_inside && !isInOneOf(*m_inside, place)) || isInOneOf(m_outside, place);
    }

private:
    struct Read {
        std::span<const std::uint8_t> labels;
        std::bitset<256> wanted;
    };
    [[nodiscard]] static std::vector<Read> read(
        const std::vector<EditableVoxels::PlaneLabels>& listed,
        std::span<const ContourPlane> planes)
    {
        std::vector<Read> found;
        for (const EditableVoxels::PlaneLabels& each : listed)
            found.push_back({labelsOfPlane(planes, each.plane), each.labels});
        return found;
    }
    [[nodiscard]] static bool isInOneOf(const std::vector<Read>& listed, std::size_t place)
    {
        return std::any_of(listed.begin(), listed.end(), [place](const Read& each) {
            return place < each.labels.size() && each.labels[place] != 0
                && each.wanted[each.labels[place]];
        });
    }

    const EditableVoxels& m_editable;
    std::optional<std::vector<Read>> m_inside;
    std::vector<Read> m_outside;
};

} // namespace

Result<std::set<std::uint8_t>> contourPlanes(const EvolveContour& edit, const Document& document)
{
    if (const Result<void> checked = check(edit, document); !checked)
        return tl::unexpected(checked.error());
    std::set<std::uint8_t> planes{document.segment(edit.segment)->plane};
    const Result<std::optional<EditableVoxels>> editable =
        editableVoxels(edit.editable, document, "evolveContour");
    if (!editable)
        return tl::unexpected(editable.error());
    if (!*editable)
        return planes;
    for (const EditableVoxels::PlaneLabels& each : (*editable)->outside)
        planes.insert(each.plane);
    if ((*editable)->inside) {
        for (const EditableVoxels::PlaneLabels& each : *(*editable)->inside)
            planes.insert(each.plane);
    }
    return planes;
}

Result<ContourGround> trialGround(
    const EvolveContour& edit, const Document& document, std::span<const ContourPlane> planes)
{
    if (const Result<void> checked = check(edit, document); !checked)
        return tl::unexpected(checked.error());
    return contourGround(
        edit, document, labelsOfPlane(planes, document.segment(edit.segment)->plane));
}

Result<void> holdUneditable(const EvolveContour& edit, const Document& document,
    std::span<const ContourPlane> planes, ContourGround& ground)
{
    const Result<std::optional<EditableVoxels>> editable =
        editableVoxels(edit.editable, document, "evolveContour");
    if (!editable)
        return tl::unexpected(editable.error());
    if (!*editable)
        return {};
    const HeldVoxels held(**editable, planes);
    const VoxelBox& box = ground.box;
    std::size_t inBox = 0;
    for (int z = box.minimum.z; z < box.maximum.z; ++z) {
        for (int y = box.minimum.y; y < box.maximum.y; ++y) {
            const std::size_t row =
                (std::size_t(z) * std::size_t(ground.volumeSize.y) + std::size_t(y))
                * std::size_t(ground.volumeSize.x);
            for (int x = box.minimum.x; x < box.maximum.x; ++x, ++inBox) {
                if (held.holds({x, y, z}, row + std::size_t(x), ground.codes[inBox]))
                    ground.voxels[inBox] |= ContourGround::held;
            }
        }
    }
    return {};
}

} // namespace core
