// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"

#include <vector>

class QPainter;

namespace ui {

class Workspace;
struct ViewContext;

/// Draws the seeds that wait for a growth over a slice: dots in the segments' colours for seeds in
/// this slice, rings for those that do not meet the criteria. (The 3D view draws them in its
/// picture, gpu::SceneSeed.)
void paintSeedMarks(QPainter& painter, const ViewContext& slice, const Workspace& workspace);

/// The seeds in a view that no growth has accepted; for a slice those that lie in it.
[[nodiscard]] std::vector<gpu::SceneSeed> seedsShownIn(
    const ViewContext& view, const Workspace& workspace);

} // namespace ui
