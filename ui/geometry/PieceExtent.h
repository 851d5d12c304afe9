// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/document/Piece.h"
#include "core/volume/VolumeGeometry.h"

#include <glm/vec3.hpp>

#include <vector>

namespace ui {

/// Where the voxels of a piece lie, in world space (LPS mm) and without the piece's pose.
struct PieceExtent {
    std::vector<glm::dvec3> pointsLps; ///< centres of every third voxel; one if there is any voxel
    glm::dvec3 middleLps{0.0}; ///< centre of their bounding box
    glm::dvec3 sizeLps{0.0}; ///< size of the bounding box
};

/// Measures the extent of the voxels of one segment, or of the carved voxels, in some bricks. It
/// reads every voxel of the bricks, so call it on a worker thread.
/// @param bricks all bricks of a label plane, or of the coverage of a layer
/// @param segment the label; 0: the carved voxels (coverage of at least 128)
[[nodiscard]] PieceExtent extentOf(
    const std::vector<core::BrickImage>& bricks, const core::VolumeGeometry& geometry, int segment);

/// Returns the pose in which a piece stands open like a lid. It is rotated outwards by 105° about a
/// hinge at the edge of its cut that is highest in the view.
/// @param extent of the piece; it holds at least one point
/// @param upLps the view's upward direction
[[nodiscard]] core::PiecePose lidPose(const core::Piece& lid, const PieceExtent& extent,
    const core::VolumeGeometry& geometry, const glm::dvec3& upLps);

} // namespace ui
