// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"

#include <vector>

class QPainter;

namespace ui {

class Workspace;
struct ViewContext;

/// Draws the seeds that wait for a growth over a slice: dots in the segments' colours, those that
/// lie in it, and rings for those that do not qualify. (The 3D view has them in its picture,
/// gpu::SceneSeed.)
void paintSeedMarks(QPainter& painter, const ViewContext& slice, const Workspace& workspace);

/// The seeds that a view shows and that no growth has accepted: of a slice those that lie in it.
[[nodiscard]] std::vector<gpu::SceneSeed> seedsShownIn(
    const ViewContext& view, const Workspace& workspace);

} // namespace ui
