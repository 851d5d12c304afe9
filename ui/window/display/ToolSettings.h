// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QJsonObject>

#include <vector>

namespace ui {

class Tool;
class Workspace;

/// The settings of all tools in the form that a session stores (DisplayState): those that the
/// workspace holds have names of their own, and those that each tool holds are under `tools`.
[[nodiscard]] QJsonObject toolSettings(const Workspace& workspace, const std::vector<Tool*>& tools);

/// Restores them. Fields that are missing or invalid are ignored.
void applyToolSettings(
    const QJsonObject& state, Workspace& workspace, const std::vector<Tool*>& tools);

} // namespace ui
