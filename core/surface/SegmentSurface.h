// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace core {

/// A surface of triangles around voxels, in index space (voxel centres at integers). Seen from
/// outside, triangles are counter-clockwise if the index axes are right-handed.
struct SegmentSurface {
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles;
};

/// The greatest distance by which smoothing moves a point of the surface, in voxels along each
/// axis.
constexpr float greatestSurfaceShift = 0.45F;

/// The closed surface of a label's voxels: their borders, smoothed.
///
/// Every edge belongs to two triangles that run along it in opposite directions. Voxels that touch
/// only at an edge or a corner are kept apart. No point is farther from the border than
/// greatestSurfaceShift, which is less than half a voxel; so no triangle can pass a voxel's centre,
/// and exactly the centres of the label's voxels are inside.
///
/// @param labels x fastest
[[nodiscard]] SegmentSurface segmentSurface(
    std::span<const std::uint8_t> labels, std::uint8_t label, const glm::ivec3& size);

/// The same borders without smoothing. Each face between voxels is divided into two triangles along
/// the diagonal from its corner with the lowest indices to that with the highest, unless it lies at
/// an edge along which voxels touch.
[[nodiscard]] SegmentSurface segmentBorders(
    std::span<const std::uint8_t> labels, std::uint8_t label, const glm::ivec3& size);

} // namespace core
