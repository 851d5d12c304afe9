// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QString>

#include <optional>

namespace ui {

class Workspace;

/// Adds a sculpt layer named "Sculpt 2" or so and makes it the active one. @return its id
core::Result<int> addLayer(Workspace& workspace);

/// What a tool that carves says of its target: "carves layer Sculpt 1, not Carotid".
[[nodiscard]] QString carvingTarget(const Workspace& workspace, bool restores);

// Each of the following is one step of undo; what cannot be done is told by the workspace.

/// Deletes a layer with what it has carved, and says so; the next one becomes the active one.
void removeLayer(Workspace& workspace, int id);
/// Lays a layer into another one, which becomes the active one.
void mergeLayers(Workspace& workspace, int from, int into);
/// What a layer has carved becomes voxels of a segment. @param label none: of a new one, named like
/// the layer
void layerToSegment(Workspace& workspace, int layer, std::optional<int> label);
/// What a segment holds is carved into a layer.
void segmentToLayer(Workspace& workspace, int label, int layer);
/// "Segment what I see": in the 3D view, whatever side one looks from. @param label none: a new one
void segmentWhatIsSeen(Workspace& workspace, std::optional<int> label);

} // namespace ui
