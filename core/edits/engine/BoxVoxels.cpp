// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/BoxVoxels.h"

namespace core {

Result<VoxelSpan> voxelsOf(const GrowBox& box, const VolumeGeometry& geometry, const QString& field)
{
    const glm::dvec3 a = glm::floor(geometry.toIndex(box.fromLps) + 0.5);
    const glm::dvec3 b = glm::floor(geometry.toIndex(box.toLps) + 0.5);
    const glm::dvec3 last(geometry.size - 1);
    const glm::dvec3 from = glm::max(glm::min(a, b), glm::dvec3(0.0));
    const glm::dvec3 to = glm::min(glm::max(a, b), last);
    if (!glm::all(glm::lessThanEqual(from, to)))
        return failure(ErrorCode::InvalidField, field, Clause::saying("lies outside the volume"));
    return VoxelSpan{.from = glm::ivec3(from), .to = glm::ivec3(to)};
}

} // namespace core
