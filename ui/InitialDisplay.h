// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/Workspace.h"

#include <QString>

#include <vector>

namespace ui {

/// How a volume looks in 3D before the user has said anything: skin for CT, else the value that
/// parts object from background best (Otsu 1979, over the histogram).
[[nodiscard]] Workspace::VolumeDisplay initialVolumeDisplay(const core::Volume& volume);

/// A grey mapping with a name, for a digit key.
struct WindowPreset {
    QString name;
    core::WindowLevel window;
};

/// What the digits 1, 2, 3 … stand for: named windows for CT, the source's own and shares of the
/// value range for everything else.
[[nodiscard]] std::vector<WindowPreset> windowPresets(const core::Volume& volume);

/// The value between the two classes of a histogram whose variance between them is greatest.
[[nodiscard]] double otsuThreshold(const core::Histogram& histogram);

} // namespace ui
