// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

namespace ui {

class MainWindow;

/// The 3D view as a stage (seed B §3): turned by keys, for the hand that does not draw, and seen by
/// two eyes. @return their names, for a menu
QStringList addStageActions(MainWindow& window);

} // namespace ui
