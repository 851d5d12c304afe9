// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/peers/ItkMask.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace peer {

struct ItkDistances {
    /// Of each voxel outside of the mask to the nearest one in it; of those in it 0 or less.
    std::vector<float> squared;
    double milliseconds = 0.0; ///< of the filter alone
};

/// itk::SignedMaurerDistanceMapImageFilter, in millimetres of an upright grid.
/// @param mask 0 or 1, x fastest
ItkDistances itkDistances(
    const glm::ivec3& size, const glm::dvec3& spacingMm, std::span<const std::uint8_t> mask);

struct ItkGap {
    double mm = 0.0; ///< 0: they touch, or share a voxel
    double milliseconds = 0.0; ///< of the filters alone
};
/// The shortest way from the cells of one mask's voxels to those of another's, of an upright grid.
/// One of them is dilated by a voxel along every axis and across (itk::BinaryDilateImageFilter),
/// which makes every way between voxels' centres as much shorter as cells are nearer than these.
/// Then itk::SignedMaurerDistanceMapImageFilter, and its least value in the other one
/// (itk::MaskImageFilter, itk::MinimumMaximumImageCalculator).
/// @pre both have voxels
[[nodiscard]] ItkGap itkGap(const GridMask& mask, const GridMask& other);

} // namespace peer
