// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/peers/ItkMask.h"

namespace peer {

/// itk::ConnectedComponentImageFilter over corners (26) and itk::RelabelComponentImageFilter: the
/// parts of at least so many voxels.
[[nodiscard]] ItkMask itkPartsFrom(const GridMask& mask, int leastVoxels);
/// The same filters: the largest part.
[[nodiscard]] ItkMask itkLargestPart(const GridMask& mask);
/// The same filters: how many parts there are.
[[nodiscard]] int itkPartCount(const GridMask& mask);

/// itk::BinaryFillholeImageFilter, whose background is connected over faces.
[[nodiscard]] ItkMask itkFilledHoles(const GridMask& mask);

} // namespace peer
