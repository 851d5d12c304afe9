// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/EngineEdits.h"

#include <algorithm>
#include <tuple>

namespace core {

QString pointText(const glm::dvec3& lps)
{
    return QStringLiteral("[%1, %2, %3]").arg(lps.x).arg(lps.y).arg(lps.z);
}

std::optional<glm::ivec3> voxelNearest(const glm::dvec3& point, const VolumeGeometry& geometry)
{
    // Cells reach half a voxel around their centres; a border belongs to the cell above it.
    const glm::dvec3 nearest =
        glm::floor(glm::dvec3(geometry.worldToIndex() * glm::dvec4(point, 1.0)) + 0.5);
    const glm::dvec3 size(geometry.size);
    if (!(glm::all(glm::greaterThanEqual(nearest, glm::dvec3(0.0)))
            && glm::all(glm::lessThan(nearest, size))))
        return std::nullopt;
    return glm::ivec3(nearest);
}

Result<std::vector<glm::ivec3>> seedVoxels(
    const std::vector<glm::dvec3>& pointsLps, const VolumeGeometry& geometry, const char* field)
{
    std::vector<glm::ivec3> voxels;
    for (const glm::dvec3& point : pointsLps) {
        const std::optional<glm::ivec3> nearest = voxelNearest(point, geometry);
        if (!nearest)
            return failure(ErrorCode::SeedOutsideVolume, pointText(point),
                Clause::saying("in field 'seed.%1'", QLatin1String(field)));
        voxels.push_back(*nearest);
    }
    const auto slicesFirst = [](const glm::ivec3& a, const glm::ivec3& b) {
        return std::tie(a.z, a.y, a.x) < std::tie(b.z, b.y, b.x);
    };
    std::sort(voxels.begin(), voxels.end(), slicesFirst);
    voxels.erase(std::unique(voxels.begin(), voxels.end()), voxels.end());
    return voxels;
}

Result<glm::dmat3> viewAxes(const OrthographicView& view, const QString& field)
{
    const glm::dvec3 towards = view.targetLps - view.eyeLps;
    if (!(glm::length(towards) > 1e-6))
        return failure(ErrorCode::InvalidField, field,
            Clause::saying("eyeLps and targetLps are the same point"));
    const glm::dvec3 forward = glm::normalize(towards);
    const glm::dvec3 across = glm::cross(forward, view.up);
    if (!(glm::length(across) > 1e-6))
        return failure(ErrorCode::InvalidField, field + QStringLiteral(".up"),
            Clause::saying("points along the view direction"));
    const glm::dvec3 right = glm::normalize(across);
    return glm::dmat3(right, glm::cross(right, forward), forward);
}

} // namespace core
