// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

namespace ui {

class Actions;
class GrowthPanel;
class Workspace;

/// Growth by menu and key: each action is a press on its button in the panel, whether that shows or
/// not, and says why where the button cannot be pressed. @return their names, for a menu
QStringList addGrowthActions(Actions& actions, GrowthPanel& panel, Workspace& workspace);

} // namespace ui
