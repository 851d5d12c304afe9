// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

namespace ui {

class Actions;
class Workspace;

/// Adds the actions on the surface that is being refined for menu and keys.
/// @return their ids, for a menu
QStringList addRefineActions(Actions& actions, Workspace& workspace);

} // namespace ui
