// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QString>

#include <optional>

namespace core {
struct Document;
}

namespace ui {

class Workspace;

/// Adds a sculpt layer named "Sculpt 2" or so and makes it the active one. @return its id
core::Result<int> addLayer(Workspace& workspace);

/// The target of a carving tool in words: "carves layer Sculpt 1, not Carotid".
[[nodiscard]] QString carvingTarget(const Workspace& workspace, bool restores);

// Each of the following functions is one step of undo. Failures are reported by the workspace.

/// Deletes a layer with what it has carved, and tells the user; the next layer becomes the active
/// one.
void removeLayer(Workspace& workspace, int id);
/// Merges a layer into another one, which becomes the active one.
void mergeLayers(Workspace& workspace, int from, int into);
/// Makes what a layer has carved voxels of a segment.
/// @param label none: of a new segment with the layer's name
void layerToSegment(Workspace& workspace, int layer, std::optional<int> label);
/// Why segmentToLayer() would be refused because segments are protected from sculpting; empty: it
/// would not.
[[nodiscard]] QString whyNotCarved(const core::Document& document, int label, bool outside = false);
/// Carves the voxels of a segment into a layer, or all others.
void segmentToLayer(Workspace& workspace, int label, int layer, bool outside = false);
/// "Segment what I see": segments what the 3D view shows, whatever its camera.
/// @param label none: a new segment
void segmentWhatIsSeen(Workspace& workspace, std::optional<int> label);

} // namespace ui
