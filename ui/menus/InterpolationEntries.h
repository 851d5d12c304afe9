// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/scene/Scene.h"

#include <QString>

#include <optional>
#include <vector>

class QMenu;

namespace ui {

class Workspace;

/// A way to interpolate slices, as the View menu and context menus offer it.
struct InterpolationEntry {
    const char* id; ///< of the window's action
    QString text;
    std::optional<gpu::Interpolation> interpolation; ///< as in Workspace::ViewOptions
};

/// All of them, in the order of a menu; the first is the usual way.
[[nodiscard]] const std::vector<InterpolationEntry>& interpolationEntries();

/// Sets how slices and the cutting plane are interpolated, in all views.
void interpolate(Workspace& workspace, std::optional<gpu::Interpolation> interpolation);

/// Adds a submenu with all of them to a context menu. The present one is checked.
void addInterpolations(QMenu& menu, Workspace& workspace);

} // namespace ui
