// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ui {

class MainWindow;

/// Adds the window's actions about views: layouts, what is drawn over views, render modes and grey
/// scales.
void addViewActions(MainWindow& window);

} // namespace ui
