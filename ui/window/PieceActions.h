// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ui {

class MainWindow;

/// Menu entries that concern pieces: lift the active layer, open like a lid, all home.
void addPieceActions(MainWindow& window);

} // namespace ui
