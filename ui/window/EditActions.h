// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ui {

class MainWindow;

/// Adds the actions of the menu Edit to the window. Undo takes back, in this order: a step of what
/// the active tool is drawing, the last change of what is shown (ViewSteps), or the last step of
/// the history.
void addEditActions(MainWindow& window);

} // namespace ui
