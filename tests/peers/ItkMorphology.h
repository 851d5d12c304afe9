// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/peers/ItkMask.h"

#include <array>

namespace peer {

enum class ItkBallFilter {
    Dilate, ///< itk::BinaryDilateImageFilter
    Erode, ///< itk::BinaryErodeImageFilter; what lies beyond the image belongs to the mask
    Open, ///< itk::BinaryMorphologicalOpeningImageFilter, likewise
    Close, ///< itk::BinaryMorphologicalClosingImageFilter with its safe border
    /// Dilated, holes filled (itk::BinaryFillholeImageFilter) and eroded, in a padded image.
    Wrap,
};

/// Binary morphology by a flat structuring element of all steps that are at most a radius long.
[[nodiscard]] ItkMask itkByBall(const GridMask& mask, double radiusMm, ItkBallFilter filter);

/// How far a body reaches along an axis of the grid.
struct AxisReach {
    double backwardsMm = 0.0;
    double forwardsMm = 0.0;
};
/// itk::BinaryDilateImageFilter by a flat structuring element of all steps whose components, each
/// divided by the reach on its side, have squares that add up to at most 1.
[[nodiscard]] ItkMask itkDilatedBySides(
    const GridMask& mask, const std::array<AxisReach, 3>& reach);

} // namespace peer
