// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace core {

/// A closed outline in a slice; its last point is joined to its first. A point (x, y) is the corner
/// that four pixels share: half a pixel before the centre of pixel (x, y) in both directions.
using SliceContour = std::vector<glm::ivec2>;

/// The outlines of a label's pixels, along their borders: they enclose the very area of the pixels,
/// and pass no pixel's centre at less than half a pixel. One for each part whose pixels hang
/// together by their sides; a hole is reached by a slit of no width between pixels (keyhole), so
/// that each outline is right by itself, filled even-odd or by winding.
///
/// @param labels of one slice, columns fastest
[[nodiscard]] std::vector<SliceContour> sliceContours(
    std::span<const std::uint8_t> labels, std::uint8_t label, const glm::ivec2& size);

} // namespace core
