// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/Camera.h"
#include "ui/workspace/Workspace.h"

namespace ui {

/// What the 3D view shows of a study before the user has moved it, as plain functions; used by the
/// view and by code that draws without a window.

/// The initial camera: from the front, a little from the patient's left and above, so that depth is
/// visible at once.
[[nodiscard]] Camera openingCamera(const core::VolumeGeometry& geometry);
/// The height at which @p camera shows the whole volume in a picture of so many pixels.
[[nodiscard]] double fittingHeightMm(
    const Camera& camera, const core::VolumeGeometry& geometry, const QSize& picture);
[[nodiscard]] gpu::VolumeScene volumeScene(
    const Camera& camera, const Workspace::VolumeDisplay& display);
/// How a piece looks before the user has changed its look: opaque; a segment's piece as a body in
/// the segment's colour.
[[nodiscard]] gpu::ScenePiece scenePiece(const core::Piece& piece, const core::Document& document);
/// How segments are drawn.
/// @param shown false: no segment is
[[nodiscard]] gpu::SegmentDisplay segmentDisplay(const core::Document& document, bool shown = true);

} // namespace ui
