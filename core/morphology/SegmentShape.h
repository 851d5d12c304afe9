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

/// What is done to the shape of a whole segment, with a ball of millimetres.
///
/// The image's border is no border of the segment: nothing is known beyond it, so what touches it
/// does not shrink away from it, gets no shell there and is not opened there, as with ITK's
/// BoundaryToForeground. A closing does not depend on it: it is what it would be in a larger volume
/// that is empty around this one, and only then cut to it.
enum class ShapeOperation : std::uint8_t {
    Grow, ///< voxels that have one of the segment in the ball around them become its own
    Shrink, ///< voxels that have another one than the segment's in the ball go
    Hollow, ///< of the segment a shell along its border remains (ShellPlace)
    Open, ///< what no ball within the segment holds goes: spurs, bridges, specks
    Close, ///< what no ball beside the segment holds becomes its own: clefts, holes, gaps
    /// Voxels change sides if more than half of the whole ball around them lies on the other one.
    /// What lies beyond the image's border counts for neither.
    Median,
    /// What the ball, rolled around the segment from outside, cannot get into becomes its own:
    /// holes, and all that lies behind openings that are narrower than the ball. Like a closing it
    /// does not depend on the image's border; voxels hang together by faces.
    Wrap,
    /// Voxels change sides if more than half of a Gaussian around them lies on the other one. No
    /// ball does that: see GaussianShape.h.
    Gaussian,
};

/// Where a shell lies that remains of a segment, from its border, which is halfway between voxels.
enum class ShellPlace : std::uint8_t {
    Inside, ///< voxels of the segment as far from the border as the ball reaches
    Centred, ///< such voxels on both sides; the ball is half as thick as the shell
    Outside, ///< free voxels beside the segment; its own ones all go
};

/// What a segment gains and loses.
struct ShapeChange {
    VoxelRuns given; ///< only voxels that no segment has; what is another's stays so
    VoxelRuns taken;
};

/// Exact: no float decides. Cost of the operations but Median on grids with axes at right angles:
/// two passes over the volume and a few over the box around the segment with the ball
/// (BallFilters.h), of any size of ball. Any thread that is no parallelFor's.
/// @param labels of the whole volume in the segment's plane, x fastest
/// @param operation not Gaussian
/// @param place of Hollow
/// Errors: OutOfMemory if filterBytes() of that box are more than checkBytes() allows, Cancelled.
[[nodiscard]] Result<ShapeChange> shapeChange(std::span<const std::uint8_t> labels,
    const glm::ivec3& size, std::uint8_t label, ShapeOperation operation, ShellPlace place,
    const MillimetreBall& ball, const Progress& progress);

} // namespace core
