// SPDX-License-Identifier: Apache-2.0
#include "ui/workspace/OpeningView.h"

#include <QSize>

#include <algorithm>
#include <cmath>

namespace ui {

Camera openingCamera(const core::VolumeGeometry& geometry)
{
    Camera camera;
    camera.orbit(-24.0, 12.0);
    camera.targetLps = geometry.toWorld(0.5 * glm::dvec3(geometry.size - 1));
    return camera;
}

double fittingHeightMm(
    const Camera& camera, const core::VolumeGeometry& geometry, const QSize& picture)
{
    // The mean extent rather than the box's corners: these are air in nearly every study.
    glm::dvec2 half(0.0);
    for (const glm::dvec3& corner : geometry.cornersLps()) {
        const glm::dvec3 from = corner - camera.targetLps;
        half.x = std::max(half.x, std::abs(glm::dot(from, camera.right())));
        half.y = std::max(half.y, std::abs(glm::dot(from, camera.up)));
    }
    const double aspect = double(std::max(picture.width(), 1)) / std::max(picture.height(), 1);
    return 2.0 * std::max(half.y, half.x / aspect);
}

gpu::VolumeScene volumeScene(const Camera& camera, const Workspace::VolumeDisplay& display)
{
    gpu::VolumeScene scene;
    scene.eyeLps = camera.eyeLps();
    scene.targetLps = camera.targetLps;
    scene.up = camera.up;
    scene.heightMm = camera.heightMm;
    scene.mode = display.mode;
    scene.surfaceThreshold = display.surfaceThreshold;
    scene.transferFunction = display.transferFunction;
    scene.mipWindow = display.mipWindow;
    scene.xrayWindow = display.xrayWindow;
    scene.cutFaces = display.cutFaces;
    scene.context = display.context;
    // Not where it does not show: another opacity is no other picture then.
    if (display.context == gpu::Context::Translucent)
        scene.contextOpacity = float(display.contextOpacity);
    return scene;
}

gpu::ScenePiece scenePiece(const core::Piece& piece, const core::Document& document)
{
    const core::Segment* segment = document.segment(piece.segment);
    gpu::ScenePiece drawn;
    drawn.id = piece.id;
    drawn.layer = piece.layer;
    drawn.segment = piece.segment;
    drawn.shownFromTrue = core::shownFromTrue(piece, document.volumes.front().geometry);
    drawn.solid = segment != nullptr;
    drawn.rgb = segment ? segment->rgb : 0xFFFFFFU;
    return drawn;
}

gpu::SegmentDisplay segmentDisplay(const core::Document& document, bool shown)
{
    gpu::SegmentDisplay display;
    for (const core::Segment& segment : document.segments) {
        display.rgb[segment.label] = segment.rgb;
        display.visible[segment.label] = segment.visible && shown;
    }
    return display;
}

} // namespace ui
