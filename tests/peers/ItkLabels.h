// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/peers/ItkMask.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>

namespace peer {

// Labels on a grid are given and come back as masks are, a number of 0 … 255 a voxel.

struct ChangedLabel {
    std::uint8_t from = 0;
    std::uint8_t to = 0;
};
/// itk::ChangeLabelImageFilter: every voxel as it was before any change.
[[nodiscard]] ItkMask itkRelabelled(const GridMask& labels, std::span<const ChangedLabel> changes);

/// itk::MaskNegatedImageFilter: the labels outside of a mask of the same grid, and @p there in it.
[[nodiscard]] ItkMask itkOutsideOf(
    const GridMask& labels, const GridMask& mask, std::uint8_t there);

/// Where an upright or oblique grid lies.
struct GridPlace {
    glm::dvec3 originLps{0.0}; ///< of its first voxel's centre
    glm::dmat3 direction{1.0}; ///< unit vectors of its axes, as columns
};
/// What of a mask lies beyond a plane gets @p beyond, by
/// itk::Image::TransformIndexToPhysicalPoint() on all threads.
[[nodiscard]] ItkMask itkSplitByPlane(const GridMask& mask, const GridPlace& place,
    const glm::dvec3& pointLps, const glm::dvec3& normalLps, std::uint8_t beyond);

} // namespace peer
