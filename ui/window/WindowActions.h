// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ui {

class MainWindow;

/// Fills the window's table of actions: everything that needs no tool and no panel.
void addWindowActions(MainWindow& window);

} // namespace ui
