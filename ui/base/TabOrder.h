// SPDX-License-Identifier: Apache-2.0
#pragma once

class QWidget;

namespace ui {

/// Sets the tab order of a dialog to its layout, row by row, whatever the order in which its
/// widgets were made. Call it when the layout is complete.
void tabAsLaidOut(QWidget& dialog);

} // namespace ui
