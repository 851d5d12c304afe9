// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/OrthographicView.h"
#include "gpu/scene/Scene.h"

#include <QImage>

#include <vector>

namespace test {

/// An orthographic view along a direction, head up.
[[nodiscard]] core::OrthographicView viewFrom(
    const glm::dvec3& direction, const glm::dvec3& target, double heightMm);
[[nodiscard]] gpu::VolumeScene sceneOf(const core::OrthographicView& view);

/// Draws a sketch over a picture as the window does: a closed curve, or a stroke.
/// @param pathMm in the view's plane, from its target
void drawSketch(QImage& picture, const core::OrthographicView& view,
    const std::vector<glm::dvec2>& pathMm, bool closed = true, std::uint32_t rgb = 0xFFD040);

/// Saves panels side by side in the manual's folder if that is requested (BURIN_SCREENSHOTS).
/// @return whether they were saved, or not requested
[[nodiscard]] bool keepPanels(const std::vector<QImage>& panels, const char* name);
[[nodiscard]] bool panelsWanted();

} // namespace test
