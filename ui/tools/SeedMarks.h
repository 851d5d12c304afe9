// SPDX-License-Identifier: Apache-2.0
#pragma once

class QPainter;

namespace ui {

class Workspace;
struct ViewContext;

/// Draws the seeds that wait for a growth over a slice: dots in the segments' colours, those that
/// lie in it, and rings for those that do not qualify. (The 3D view has them in its picture,
/// gpu::SceneSeed.)
void paintSeedMarks(QPainter& painter, const ViewContext& slice, const Workspace& workspace);

} // namespace ui
