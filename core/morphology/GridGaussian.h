// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace core {

struct VolumeGeometry;

/// A Gaussian with a standard deviation in millimetres on a volume's grid, in whole numbers. It is
/// separable: one filter along each of the grid's three axes, as wide in voxels as the standard
/// deviation is there. On a sheared grid it lies along the sheared axes.
///
/// Millimetres become integers once, in gaussianOf(): half of the squared ratio of a step to the
/// standard deviation, in units of 2⁻³². From this the heights exp(−k² · that) are computed in
/// whole numbers alone, so they are the same with every mathematics library. They end at three
/// standard deviations and are rounded so that the weights of an axis add up to `whole`.
struct GridGaussian {
    static constexpr std::uint32_t whole = 65536;
    /// For each axis the weight of the voxel itself, and of the voxels 1, 2 … steps away on either
    /// side. The last weight may be 0, the first never is.
    std::array<std::vector<std::uint32_t>, 3> weights;

    /// The number of voxels on either side that have a weight, along each axis.
    [[nodiscard]] glm::ivec3 reach() const
    {
        return {int(weights[0].size()) - 1, int(weights[1].size()) - 1, int(weights[2].size()) - 1};
    }
};

/// The number of standard deviations after which the weights end.
constexpr double gaussianReach = 3.0;

/// Makes a Gaussian for a grid.
/// @pre ballVoxels() of gaussianReach times @p sigmaMm is at most mostBallVoxels
[[nodiscard]] GridGaussian gaussianOf(const VolumeGeometry& geometry, double sigmaMm);

} // namespace core
