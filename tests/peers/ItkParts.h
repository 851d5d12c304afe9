// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/peers/ItkMask.h"

namespace peer {

/// itk::ConnectedComponentImageFilter over corners (26) and itk::RelabelComponentImageFilter: the
/// parts of at least so many voxels.
[[nodiscard]] ItkMask itkPartsFrom(const GridMask& mask, int leastVoxels);
/// The same filters: the largest part.
[[nodiscard]] ItkMask itkLargestPart(const GridMask& mask);
/// The same filters: the parts of at least so many voxels, numbered from the largest, 1, which 255
/// holds. The other voxels of the mask bear the number of the largest part.
[[nodiscard]] ItkMask itkNumberedParts(const GridMask& mask, int leastVoxels);
/// The same filters: how many parts of at least so many voxels there are.
[[nodiscard]] int itkPartCount(const GridMask& mask, int leastVoxels = 0);

/// itk::BinaryFillholeImageFilter, whose background is connected over faces.
[[nodiscard]] ItkMask itkFilledHoles(const GridMask& mask);

} // namespace peer
