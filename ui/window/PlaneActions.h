// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

namespace ui {

class MainWindow;

/// Adds the actions on the cutting plane for menu and keys, and the layouts that show it.
/// @return the ids of the former, for a menu
QStringList addPlaneActions(MainWindow& window);

} // namespace ui
