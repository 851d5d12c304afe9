// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <vector>

class QMenu;

namespace ui {

class Workspace;

/// A voxel that a menu is about, and what the session knows of it.
struct PointedVoxel {
    glm::ivec3 voxel{0};
    glm::dvec3 centreLps{0.0};
    int code = 0; ///< its value, as the volume stores it
    int label = 0; ///< of the segment that it belongs to; 0: of none
    std::vector<int> others{}; ///< labels of the other segments that have it; segments may overlap
};

/// Adds what every view offers about a place: whose segment becomes active, is locked or shown
/// alone; which others become active; the crosshair, undo of the step that changed this very voxel
/// last, the window presets, and its value and position for the clipboard. Another session makes
/// the entries do nothing. An entry that cannot be chosen says why by its tool tip.
void addPlaceEntries(QMenu& menu, Workspace& workspace, const PointedVoxel& pointed);
/// Adds the grey scales that are offered for the volume that is open, as a submenu.
void addWindowPresets(QMenu& menu, Workspace& workspace);

} // namespace ui
