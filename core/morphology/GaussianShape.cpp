// SPDX-License-Identifier: Apache-2.0
#include "core/morphology/GaussianShape.h"

#include "core/brick/LabelBox.h"
#include "core/morphology/BoxRows.h"
#include "core/morphology/GaussianFilter.h"
#include "core/morphology/GridGaussian.h"
#include "core/volume/MemoryLimit.h"

namespace core {

Result<ShapeChange> gaussianChange(std::span<const std::uint8_t> labels, const glm::ivec3& size,
    std::uint8_t label, const GridGaussian& gaussian, const Progress& progress)
{
    const VoxelBox own = boxOfLabel(labels, size, label);
    if (own.empty())
        return ShapeChange();
    const BoxRows rows(own, size);
    if (const Result<void> enough =
            checkBytes(gaussianBytes(rows.boxSize()), QStringLiteral("the segment"));
        !enough)
        return tl::unexpected(enough.error());
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    const Result<BoxValues> blurry =
        blurred(rows.mask(labels, label), gaussian, rows.ends(), {.progress = progress});
    if (!blurry)
        return tl::unexpected(blurry.error());
    const std::vector<std::uint16_t>& values = blurry->values;
    return ShapeChange{.given = rows.voxels(labels, 0,
                           [&](std::size_t voxel) { return values[voxel] > BoxValues::half; }),
        .taken = rows.voxels(
            labels, label, [&](std::size_t voxel) { return values[voxel] < BoxValues::half; })};
}

} // namespace core
