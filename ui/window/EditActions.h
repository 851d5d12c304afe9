// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ui {

class MainWindow;

/// Adds undo and redo, of what is drawn step by step, of what is shown and of the history, in this
/// order, and what the menu Edit has besides.
void addEditActions(MainWindow& window);

} // namespace ui
