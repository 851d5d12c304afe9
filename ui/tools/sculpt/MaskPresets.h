// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/sculpt/MaskShape.h"
#include "ui/workspace/Workspace.h"

#include <QString>

#include <vector>

namespace ui {

/// A mask that the user has given a name: shape, size, turn and edge.
struct MaskPreset {
    QString name;
    core::MaskShape::Kind shape = core::MaskShape::Kind::Circle;
    double radiusMm = 8.0; ///< of other shapes than the circle: half the width
    double heightRatio = 0.5;
    double rotationDegrees = 0.0;
    double softnessMm = 0.0;
    MaskOutline outline{}; ///< in place of the shape; empty: the shape
    bool operator==(const MaskPreset&) const = default;
};

// Kept in the user's settings, for every study. Entries that cannot be read are left out.
[[nodiscard]] std::vector<MaskPreset> maskPresets();
void setMaskPresets(const std::vector<MaskPreset>& presets);

/// Adds one, or replaces the one of that name; in the order of their names.
void saveMaskPreset(const MaskPreset& preset);
void removeMaskPreset(const QString& name);

/// The settings' mask, to be saved under a name; and the settings with a preset's mask.
[[nodiscard]] MaskPreset presetOf(const Workspace::DrillSettings& settings, const QString& name);
[[nodiscard]] Workspace::DrillSettings withPreset(
    Workspace::DrillSettings settings, const MaskPreset& preset);

} // namespace ui
