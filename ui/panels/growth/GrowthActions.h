// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

namespace ui {

class Actions;
class GrowthPanel;
class Workspace;

/// Adds the actions of growth for menu and keys. Each presses its button in the panel, whether or
/// not the panel is visible, and says why if the button is disabled.
/// @return their ids, for a menu
QStringList addGrowthActions(Actions& actions, GrowthPanel& panel, Workspace& workspace);

} // namespace ui
