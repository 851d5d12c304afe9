// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ui {
class MainWindow;
}

namespace app {

/// Gives the window what the workstation has: the tools, the panels, their menus and keys, and the
/// dialogs that export. Their order here is their order in the window. To be called once, before a
/// study is opened.
void addContents(ui::MainWindow& window);

} // namespace app
