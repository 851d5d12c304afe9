// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <vector>

class QMenu;

namespace ui {

class Workspace;

/// The voxel that a context menu is about, and what the session knows of it.
struct PointedVoxel {
    glm::ivec3 voxel{0}; ///< index space
    glm::dvec3 centreLps{0.0};
    int code = 0; ///< its value as the volume stores it
    int label = 0; ///< label of its segment; 0: it belongs to none
    std::vector<int> others{}; ///< labels of the other segments at this voxel, if segments overlap
};

/// Adds the entries that every view offers about a voxel: activate, lock or isolate its segment;
/// activate another segment there; put the crosshair there; undo the last step at this voxel only;
/// the window presets; copy value and position. The entries do nothing once another session is
/// open. The tool tip of a disabled entry says why it is disabled.
void addPlaceEntries(QMenu& menu, Workspace& workspace, const PointedVoxel& pointed);
/// Adds a submenu with the window presets of the open volume.
void addWindowPresets(QMenu& menu, Workspace& workspace);

} // namespace ui
