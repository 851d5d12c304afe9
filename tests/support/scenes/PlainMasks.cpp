// SPDX-License-Identifier: Apache-2.0
#include "tests/support/scenes/PlainMasks.h"

#include "core/edits/kinds/imports/ImportMask.h"

namespace test {

core::Edit maskImport(const QString& file, const glm::ivec3& size,
    const std::vector<MaskPart>& parts, const std::vector<int>& planes)
{
    core::ImportMask mask{.file = file};
    mask.size = size;
    mask.segments.emplace();
    for (const MaskPart& part : parts)
        mask.segments->push_back({.name = part.name,
            .rgb = part.rgb,
            .code = {},
            .voxels = core::packedRuns(part.voxels)});
    if (!planes.empty())
        mask.planes = planes;
    return mask;
}

core::Edit matterImport(const glm::ivec3& size, std::span<const core::VoxelRuns> segments)
{
    std::vector<MaskPart> parts;
    for (const core::VoxelRuns& voxels : segments)
        parts.push_back({QStringLiteral("Matter %1").arg(parts.size() + 1), voxels});
    return maskImport(QStringLiteral("matter.nii"), size, parts);
}

} // namespace test
