// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/geometry/Camera.h"
#include "ui/workspace/Workspace.h"

namespace ui {

/// What the 3D view shows of a study before anybody has moved it, as plain functions: the view uses
/// them, and whoever draws a picture without a window.

/// From the front, a little from the patient's left and above: depth shows at once.
[[nodiscard]] Camera openingCamera(const core::VolumeGeometry& geometry);
/// The height at which @p camera shows the whole volume in a picture of so many pixels.
[[nodiscard]] double fittingHeightMm(
    const Camera& camera, const core::VolumeGeometry& geometry, const QSize& picture);
[[nodiscard]] gpu::VolumeScene volumeScene(
    const Camera& camera, const Workspace::VolumeDisplay& display);
/// A piece as it looks before anybody has changed that: opaque, of a segment its body in its
/// colour.
[[nodiscard]] gpu::ScenePiece scenePiece(const core::Piece& piece, const core::Document& document);
/// @param shown false: none of the segments
[[nodiscard]] gpu::SegmentDisplay segmentDisplay(const core::Document& document, bool shown = true);

} // namespace ui
