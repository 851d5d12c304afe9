// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

namespace ui {

class MainWindow;

/// What is done to the cutting plane by menu and key, and the layouts that show it. @return the
/// names of the former, for a menu
QStringList addPlaneActions(MainWindow& window);

} // namespace ui
