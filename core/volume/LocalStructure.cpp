// SPDX-License-Identifier: Apache-2.0
#include "core/volume/LocalStructure.h"

#include <eigen3/Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace core {

bool LocalStructure::isTube() const
{
    return changes[1] > 0.3 * changes[0] && changes[2] < 0.5 * changes[1];
}

std::optional<LocalStructure> localStructure(std::span<const std::uint16_t> codes,
    const VoxelBox& box, const VolumeGeometry& geometry, const glm::dvec3& placeLps,
    double radiusMm)
{
    const glm::ivec3 size = box.maximum - box.minimum;
    const glm::dmat3 toWorld = glm::transpose(glm::dmat3(geometry.worldToIndex()));
    const double spread = 0.5 * radiusMm;
    const std::array<std::size_t, 3> strides{
        1, std::size_t(size.x), std::size_t(size.x) * std::size_t(size.y)};
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    double weights = 0.0;
    for (int z = 1; z + 1 < size.z; ++z) {
        for (int y = 1; y + 1 < size.y; ++y) {
            for (int x = 1; x + 1 < size.x; ++x) {
                const glm::ivec3 within(x, y, z);
                const double wayMm =
                    glm::distance(geometry.toWorld(glm::dvec3(box.minimum + within)), placeLps);
                if (wayMm > radiusMm)
                    continue;
                const std::size_t at =
                    std::size_t(x) + strides[1] * std::size_t(y) + strides[2] * std::size_t(z);
                glm::dvec3 slope(0.0);
                for (int axis = 0; axis < 3; ++axis)
                    slope[axis] = 0.5
                        * (double(codes[at + strides[std::size_t(axis)]])
                            - double(codes[at - strides[std::size_t(axis)]]));
                slope = toWorld * slope;
                const double weight = std::exp(-0.5 * wayMm * wayMm / (spread * spread));
                const Eigen::Vector3d gradient(slope.x, slope.y, slope.z);
                sum += weight * gradient * gradient.transpose();
                weights += weight;
            }
        }
    }
    if (weights <= 0.0 || sum.trace() <= 0.0)
        return std::nullopt;
    // Ascending.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solved(sum / weights);
    LocalStructure structure;
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d direction = solved.eigenvectors().col(2 - i);
        structure.directions[std::size_t(i)] = {direction.x(), direction.y(), direction.z()};
        structure.changes[std::size_t(i)] = std::max(solved.eigenvalues()[2 - i], 0.0);
    }
    return structure;
}

VoxelBox localStructureBox(
    const VolumeGeometry& geometry, const glm::dvec3& placeLps, double radiusMm)
{
    const glm::dvec3 middle = geometry.toIndex(placeLps);
    // The cell of a sheared volume reaches farther along its axes than its edges are long.
    const glm::dmat3 toIndex(geometry.worldToIndex());
    VoxelBox box;
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec3 row(toIndex[0][axis], toIndex[1][axis], toIndex[2][axis]);
        const double reach = radiusMm * glm::length(row) + 1.0;
        box.minimum[axis] = std::max(int(std::floor(middle[axis] - reach)), 0);
        box.maximum[axis] = std::min(int(std::ceil(middle[axis] + reach)) + 1, geometry.size[axis]);
        if (box.minimum[axis] >= box.maximum[axis])
            return {};
    }
    return box;
}

} // namespace core
