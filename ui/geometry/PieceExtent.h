// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/document/Piece.h"
#include "core/volume/VolumeGeometry.h"

#include <glm/vec3.hpp>

#include <vector>

namespace ui {

/// Where the voxels of a piece lie, at its true place.
struct PieceExtent {
    std::vector<glm::dvec3> pointsLps; ///< an evenly chosen part of the voxels
    glm::dvec3 middleLps{0.0}; ///< of their bounding box
    glm::dvec3 sizeLps{0.0}; ///< of the same box
};

/// The extent of what some bricks hold. It reads their voxels, so it is called on a worker.
/// @param bricks all of a label plane, or all of the coverage of a layer
/// @param segment its label; 0: what is carved
[[nodiscard]] PieceExtent extentOf(
    const std::vector<core::BrickImage>& bricks, const core::VolumeGeometry& geometry, int segment);

/// The pose in which a piece stands open like a lid: it is turned outwards about the edge of its
/// cut that is highest in the view.
/// @param extent of the piece; it holds at least one point
/// @param upLps the view's upward direction
[[nodiscard]] core::PiecePose lidPose(const core::Piece& lid, const PieceExtent& extent,
    const core::VolumeGeometry& geometry, const glm::dvec3& upLps);

} // namespace ui
