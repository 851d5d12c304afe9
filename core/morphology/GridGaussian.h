// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace core {

struct VolumeGeometry;

/// A Gaussian of millimetres on a volume's grid, in whole numbers: one after the other along the
/// grid's three axes, with as many voxels on each as its standard deviation has there. On a sheared
/// grid it lies along the sheared axes.
///
/// Millimetres become integers once, in gaussianOf(): half of the squared ratio of a step and the
/// standard deviation, in 2⁻³². The heights exp(−k² · that) follow from it by whole numbers alone,
/// so they are the same with every library of mathematics. They end after three standard
/// deviations, and are rounded so that all of an axis add up to `whole`.
struct GridGaussian {
    static constexpr std::uint32_t whole = 65536;
    /// For each axis the weight of the voxel itself, and of the ones that are 1, 2 … steps away on
    /// either side; the last one may be 0, the first never is.
    std::array<std::vector<std::uint32_t>, 3> weights;

    /// The most voxels on one side along any axis.
    [[nodiscard]] glm::ivec3 reach() const
    {
        return {int(weights[0].size()) - 1, int(weights[1].size()) - 1, int(weights[2].size()) - 1};
    }
};

/// How many standard deviations away the weights end.
constexpr double gaussianReach = 3.0;

/// @pre ballVoxels() of gaussianReach times @p sigmaMm is at most mostBallVoxels
[[nodiscard]] GridGaussian gaussianOf(const VolumeGeometry& geometry, double sigmaMm);

} // namespace core
