// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/peers/ItkGaussian.h"
#include "tests/peers/ItkMask.h"

namespace peer {

/// By itk::NeighborhoodOperatorImageFilter, which adds up a ball of ones, once over the mask and
/// once over the rest: what has more than half of the ball around it on the other side changes
/// sides. Beyond the image there is neither.
[[nodiscard]] ItkMask itkMajority(const GridMask& mask, double radiusMm);

/// A mask blurred by itk::NeighborhoodOperatorImageFilter along each axis, with samples of a
/// Gaussian that end at three standard deviations and add up to 1; the image's border continues.
[[nodiscard]] ItkGaussian itkSampledGaussian(const GridMask& mask, double sigmaMm);

} // namespace peer
