// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/filling/ContourTrial.h"

#include "core/contour/ContourEvolution.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/kinds/filling/EvolveContour.h"
#include "core/sculpt/labels/HeldVoxels.h"

#include <cstddef>
#include <optional>

namespace core {

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
    planes.merge(planesOf(**editable));
    return planes;
}

Result<ContourGround> trialGround(
    const EvolveContour& edit, const Document& document, std::span<const LabelPlane> planes)
{
    if (const Result<void> checked = check(edit, document); !checked)
        return tl::unexpected(checked.error());
    return contourGround(
        edit, document, labelsOfPlane(planes, document.segment(edit.segment)->plane));
}

Result<void> holdUneditable(const EvolveContour& edit, const Document& document,
    std::span<const LabelPlane> planes, ContourGround& ground)
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
