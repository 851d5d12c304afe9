// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ui {

class Workspace;

/// Puts the crosshair on the voxel of a segment that is nearest to its middle, and has every view
/// show the middle of the box around it; how near the views look stays. The engine reads the
/// labels, another thread finds the place; the window goes on. What was asked for before is
/// dropped, and everything is when the session closes. Failures are reported by the workspace.
void centreOnSegment(Workspace& workspace, int label);

} // namespace ui
