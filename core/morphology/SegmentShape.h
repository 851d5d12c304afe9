// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/brick/VoxelRuns.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <span>

namespace core {

struct MillimetreBall;

/// Operations on the shape of a whole segment, with a ball of millimetres.
///
/// The border of the image is no border of the segment: nothing is known beyond it. A segment that
/// touches it does not shrink away from it, gets no shell there and is not opened there, as with
/// ITK's BoundaryToForeground. Closing does not depend on it: the result is that in a larger volume
/// that is empty around this one, cut to this volume.
enum class ShapeOperation : std::uint8_t {
    Grow, ///< free voxels join if a voxel of the segment lies in the ball around them
    Shrink, ///< voxels leave if a voxel outside the segment lies in the ball around them
    Hollow, ///< only a shell along the border remains (ShellPlace)
    Open, ///< voxels that no ball within the segment covers leave: spurs, bridges, specks
    Close, ///< free voxels that no ball outside the segment covers join: clefts, holes, gaps
    /// Voxels change sides if more than half of the whole ball around them lies on the other side.
    /// What lies beyond the border of the image counts for neither side; of a flat ball
    /// (flatBallOf()) nothing does along an axis on which the image has a single voxel.
    Median,
    /// Free voxels join if the ball cannot reach them when it is rolled around the segment from
    /// outside: holes, and everything behind openings that are narrower than the ball. Like closing
    /// it does not depend on the border of the image. The ball moves over faces of voxels.
    Wrap,
    /// Voxels change sides if more than half of a Gaussian around them lies on the other side. Not
    /// done by shapeChange(): see GaussianShape.h.
    Gaussian,
};

/// Where the shell lies, relative to the border of the segment, which runs halfway between voxels.
enum class ShellPlace : std::uint8_t {
    Inside, ///< voxels of the segment, as far from the border as the ball reaches
    /// Such voxels on both sides; the radius of the ball is half the thickness of the shell.
    Centred,
    /// Free voxels beside the segment, as far as the ball reaches; its own voxels all leave.
    Outside,
};

/// What a segment gains and loses.
struct ShapeChange {
    VoxelRuns given; ///< only voxels that no segment has
    VoxelRuns taken;
};

/// Computes what an operation changes. Exact: no floating-point number decides. Cost, except for
/// Median and on sheared grids: two passes over the volume and a few over the box around the
/// segment with the ball (BallFilters.h), whatever the size of the ball. Any thread outside a
/// parallelFor().
/// @param labels one for each voxel of the volume in the segment's plane, x fastest
/// @param operation any but Gaussian
/// @param place only for Hollow
/// Errors: OutOfMemory if filterBytes() of that box are more than checkBytes() allows, Cancelled.
[[nodiscard]] Result<ShapeChange> shapeChange(std::span<const std::uint8_t> labels,
    const glm::ivec3& size, std::uint8_t label, ShapeOperation operation, ShellPlace place,
    const MillimetreBall& ball, const Progress& progress);

} // namespace core
