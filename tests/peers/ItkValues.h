// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/peers/ItkMask.h"

namespace peer {

/// itk::BinaryThresholdImageFilter, bounds inclusive.
/// @param values x fastest
[[nodiscard]] ItkMask itkThreshold(
    const glm::ivec3& size, std::span<const float> values, float lower, float upper);

/// What divides values into parts: up to and including each of the thresholds.
struct ItkOtsu {
    std::vector<double> thresholds; ///< ascending
    double milliseconds = 0.0;
};
/// itk::OtsuMultipleThresholdsCalculator on a histogram of equal bins.
[[nodiscard]] ItkOtsu itkOtsu(
    std::span<const std::uint32_t> counts, double minimum, double maximum, int thresholds);

/// itk::BinaryNotImageFilter: what is not in the mask.
[[nodiscard]] ItkMask itkInverted(const GridMask& mask);
enum class ItkSetOperation {
    Union, ///< itk::OrImageFilter
    Subtract, ///< itk::AndImageFilter with the other one inverted (itk::BinaryNotImageFilter)
    Intersect, ///< itk::AndImageFilter
};
/// Two masks of one grid.
[[nodiscard]] ItkMask itkCombined(
    const GridMask& mask, const GridMask& other, ItkSetOperation operation);
/// itk::FlipImageFilter across one axis.
[[nodiscard]] ItkMask itkFlipped(const GridMask& mask, int axis);
/// A mask and its mirror image about the plane across an axis that goes through the centres of
/// these voxels: itk::FlipImageFilter about the origin, itk::ResampleImageFilter by the nearest
/// voxel onto the grid of the mask, and itk::OrImageFilter.
[[nodiscard]] ItkMask itkWithMirrorImage(const GridMask& mask, int axis, int voxel);

/// What filters made of values.
struct ItkValues {
    std::vector<float> values;
    double milliseconds = 0.0; ///< of the filters alone
};
/// itk::MaskImageFilter: the values of a mask, and another one outside of it.
/// @param values of the grid of the mask, x fastest
[[nodiscard]] ItkValues itkMasked(
    std::span<const float> values, const GridMask& mask, float outside);

} // namespace peer
