// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ui {

class MainWindow;

/// Adds to the window's table of actions everything that needs neither a tool nor a panel.
void addWindowActions(MainWindow& window);

} // namespace ui
