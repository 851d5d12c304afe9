// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

namespace ui {

class MainWindow;

/// Adds the actions for the 3D view as a stage (seed B §3): turning it by keys, for the hand that
/// does not draw, and stereo.
/// @return their ids, for a menu
QStringList addStageActions(MainWindow& window);

} // namespace ui
