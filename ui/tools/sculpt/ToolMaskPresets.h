// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/sculpt/ToolMask.h"
#include "ui/workspace/Workspace.h"

#include <QString>

#include <vector>

namespace ui {

/// A mask that the user has saved under a name: shape, size, rotation and edge.
struct ToolMaskPreset {
    QString name;
    core::ToolMask::Kind shape = core::ToolMask::Kind::Circle;
    double radiusMm = 8.0; ///< half the width for shapes other than the circle
    double heightRatio = 0.5;
    double rotationDegrees = 0.0;
    double softnessMm = 0.0;
    ToolMaskOutline outline{}; ///< replaces the shape; empty: the shape counts
    bool operator==(const ToolMaskPreset&) const = default;
};

// Presets are kept in the user's settings and serve every study. Entries that cannot be read are
// left out.
[[nodiscard]] std::vector<ToolMaskPreset> toolMaskPresets();
void setToolMaskPresets(const std::vector<ToolMaskPreset>& presets);

/// Adds a preset, or replaces the one of the same name. Presets are sorted by name.
void saveToolMaskPreset(const ToolMaskPreset& preset);
void removeToolMaskPreset(const QString& name);

/// The mask of the settings as a preset; and the settings with the mask of a preset.
[[nodiscard]] ToolMaskPreset presetOf(
    const Workspace::DrillSettings& settings, const QString& name);
[[nodiscard]] Workspace::DrillSettings withPreset(
    Workspace::DrillSettings settings, const ToolMaskPreset& preset);

} // namespace ui
