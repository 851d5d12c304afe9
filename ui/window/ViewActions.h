// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ui {

class MainWindow;

/// Adds to the window's table of actions what concerns views: layouts, what is drawn over them, how
/// they draw, and grey scales.
void addViewActions(MainWindow& window);

} // namespace ui
