// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

namespace ui {

class Actions;
class Workspace;

/// What is done to the surface that is being refined by menu and key. @return their names, for a
/// menu
QStringList addRefineActions(Actions& actions, Workspace& workspace);

} // namespace ui
