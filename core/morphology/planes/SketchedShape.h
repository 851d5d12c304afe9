// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/morphology/planes/PlaneSketch.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace core {

/// Coordinates of a voxel relative to a plane, units · 2¹⁴.
[[nodiscard]] PlaneSketch::Fixed3 placeOf(const PlaneSketch::Plane& plane, const glm::ivec3& voxel);
/// Whether a plane takes this voxel of its column, by the voxel's height, units · 2¹⁴.
[[nodiscard]] inline bool isOn(const PlaneSketch::Plane& plane, std::int64_t height)
{
    const std::int64_t step = plane.perVoxel.at(std::size_t(plane.along))[2];
    return -step <= 2 * height && 2 * height < step;
}
/// The voxel under a pixel of a plane: the one that the plane takes of the pixel's column. None
/// outside the volume.
[[nodiscard]] std::optional<glm::ivec3> voxelUnder(
    const PlaneSketch::Plane& plane, const glm::ivec2& pixel, const glm::ivec3& size);

/// What was drawn on one plane.
struct SketchedShape {
    /// A row of pixels in which something was drawn, with its first and last such pixel.
    struct Row {
        int y = 0;
        int first = 0;
        int last = 0;
    };
    glm::ivec2 begin{0}; ///< as of the plane
    glm::ivec2 size{0};
    std::vector<Row> rows{}; ///< empty: nothing was drawn
    // Pixels under which the label is, also in parts that are left out.
    std::int64_t ownPixels = 0; ///< of voxels on no other plane
    std::int64_t sharedPixels = 0; ///< of voxels that are on another plane, too
    /// The longer side of the rectangle around the largest part, units.
    std::int64_t extent = 0;
    /// The signed distance of each pixel to the border, greater than 0 inside, units.
    std::vector<std::int32_t> distances{};

    /// The signed distance at a place in the plane, units, blended between four pixels by where it
    /// lies among them, in steps of 1/256 of a pixel; `outside` beyond the pixels.
    [[nodiscard]] std::int64_t at(const PlaneSketch::Plane& plane, std::int64_t right,
        std::int64_t up, std::int64_t outside) const;
};
/// Parts of the shape that only consist of voxels on other planes are left out: they are where what
/// was drawn there passes through this one.
[[nodiscard]] SketchedShape sketchedShape(const PlaneSketch& sketch, std::size_t plane,
    std::span<const std::uint8_t> labels, const glm::ivec3& size, std::uint8_t label);

} // namespace core
