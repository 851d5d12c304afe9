// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workspace/Workspace.h"

#include <QString>

#include <vector>

namespace ui {

/// How a volume looks in 3D before the user has said anything (core::usualSurfaceThreshold()).
[[nodiscard]] Workspace::VolumeDisplay initialVolumeDisplay(const core::Volume& volume);

/// Where the crosshair stands at first: in the middle of the voxel in the middle.
[[nodiscard]] glm::dvec3 initialCrosshairLps(const core::VolumeGeometry& geometry);

/// A grey mapping with a name, for a digit key.
struct WindowPreset {
    QString name;
    core::WindowLevel window;
};

/// What the digits 1, 2, 3 … stand for: named windows for CT, the source's own and shares of the
/// value range for everything else.
[[nodiscard]] std::vector<WindowPreset> windowPresets(const core::Volume& volume);

} // namespace ui
