// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/Workspace.h"

#include <QString>

#include <vector>

namespace ui {

/// How a volume looks in 3D before the user has changed anything (core::usualSurfaceThreshold()).
[[nodiscard]] Workspace::VolumeDisplay initialVolumeDisplay(const core::Volume& volume);

/// The initial position of the crosshair: the centre of the voxel in the middle.
[[nodiscard]] glm::dvec3 initialCrosshairLps(const core::VolumeGeometry& geometry);

/// A named window/level, for a digit key.
struct WindowPreset {
    QString name;
    core::WindowLevel window;
};

/// The presets of the digit keys 1, 2, 3 …: named windows for CT; for everything else the source's
/// own window and fractions of the value range.
[[nodiscard]] std::vector<WindowPreset> windowPresets(const core::Volume& volume);

} // namespace ui
