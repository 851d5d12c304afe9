// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ui {

class MainWindow;

/// Adds the menu entries for pieces: lift the active layer, open like a lid, all home.
void addPieceActions(MainWindow& window);

} // namespace ui
