// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/peers/ItkMask.h"

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

} // namespace peer
