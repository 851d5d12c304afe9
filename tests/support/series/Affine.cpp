// SPDX-License-Identifier: Apache-2.0
#include "tests/support/series/Affine.h"

#include <QJsonArray>

#include <algorithm>

namespace test {

glm::dmat4 matrixFrom(const QJsonValue& rows)
{
    glm::dmat4 matrix(1.0);
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column)
            matrix[column][row] = rows.toArray()[row].toArray()[column].toDouble();
    }
    return matrix;
}

double cornerDistance(const glm::dmat4& indexToWorld, const core::VolumeGeometry& volume)
{
    core::VolumeGeometry moved = volume;
    moved.indexToWorld = indexToWorld;
    double worst = 0.0;
    for (std::size_t corner = 0; corner < 8; ++corner)
        worst =
            std::max(worst, glm::distance(moved.cornersLps()[corner], volume.cornersLps()[corner]));
    return worst;
}

glm::dvec3 placeOf(const core::VolumeGeometry& geometry, const glm::ivec3& voxel)
{
    if (geometry.slicePositions.empty())
        return geometry.toWorld(glm::dvec3(voxel));
    return geometry.slicePositions[std::size_t(voxel.z)]
        + glm::dmat3(geometry.indexToWorld) * glm::dvec3(voxel.x, voxel.y, 0.0);
}

} // namespace test
