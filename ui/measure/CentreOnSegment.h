// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ui {

class Workspace;

/// Puts the crosshair on the voxel of a segment that is nearest to the centre of the segment's
/// bounding box, and moves every view to that centre; the zoom stays. It returns at once: the
/// engine reads the labels and a background thread finds the place. A further call, or closing the
/// session, drops the request. The workspace reports errors.
void centreOnSegment(Workspace& workspace, int label);

} // namespace ui
