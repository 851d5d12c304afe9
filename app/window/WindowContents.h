// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ui {
class MainWindow;
}

namespace app {

/// Adds the workstation's contents to the window: tools, panels, their menus and keys, and the
/// export dialogs. The order here is their order in the window. Call it once, before a study is
/// opened.
void addContents(ui::MainWindow& window);

} // namespace app
