// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace core {

/// A closed outline in a slice; its last point is connected with its first. A point (x, y) is a
/// corner shared by four pixels: half a pixel before the centre of pixel (x, y) in both directions.
using SliceContour = std::vector<glm::ivec2>;

/// The outlines of a label's pixels, along their borders, so they enclose exactly the area of the
/// pixels and stay half a pixel away from any pixel's centre. There is one for each part whose
/// pixels are connected by their sides. A hole is connected with the outside by a slit of width 0
/// between pixels (keyhole), so that each outline is correct by itself, filled by even-odd or by
/// winding.
///
/// @param labels of one slice, columns fastest
[[nodiscard]] std::vector<SliceContour> sliceContours(
    std::span<const std::uint8_t> labels, std::uint8_t label, const glm::ivec2& size);

} // namespace core
