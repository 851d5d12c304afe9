// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QJsonObject>

#include <vector>

namespace ui {

class Tool;
class Workspace;

/// The settings of all tools as a session keeps them (DisplayState): those that the workspace holds
/// under names of their own, and under `tools` what each tool keeps itself.
[[nodiscard]] QJsonObject toolSettings(const Workspace& workspace, const std::vector<Tool*>& tools);

/// Fields that are missing or make no sense are passed over.
void applyToolSettings(
    const QJsonObject& state, Workspace& workspace, const std::vector<Tool*>& tools);

} // namespace ui
