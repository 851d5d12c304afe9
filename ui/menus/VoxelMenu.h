// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

class QPoint;
class QWidget;

namespace ui {

class Workspace;

/// Opens what a view offers about the voxel under the pointer: the island of a segment that it
/// lies in is removed, kept alone, or given to another segment. The session is asked first whose
/// the voxel is, so the menu opens a moment later; outside the volume there is none.
/// @param view is where the menu belongs: no menu opens once it has gone
/// @param placeLps the voxel nearest to it is meant
/// @param at on the screen
void openVoxelMenu(
    Workspace& workspace, QWidget& view, const glm::dvec3& placeLps, const QPoint& at);

} // namespace ui
