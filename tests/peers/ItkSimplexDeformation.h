// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace peer {

struct ItkDeformed {
    std::vector<glm::dvec3> positions; ///< of the simplex mesh's vertices
    double milliseconds = 0.0; ///< of the deformation alone
};

struct ItkDeformation {
    int iterations = 40;
    double alpha = 0.2; ///< of the internal force
    double beta = 1.0; ///< of the external force
    double gamma = 0.05;
    double damping = 0.65;
    unsigned rigidity = 1;
};

/// itk::DeformableSimplexMesh3DFilter on the dual of a triangle mesh, in voxels.
/// @param gradients by voxel, x fastest: the way on which a vertex there is drawn
[[nodiscard]] ItkDeformed itkDeformed(std::span<const glm::dvec3> points,
    std::span<const glm::uvec3> triangles, const glm::ivec3& size,
    std::span<const glm::vec3> gradients, const ItkDeformation& settings);

} // namespace peer
