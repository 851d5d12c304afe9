// SPDX-License-Identifier: Apache-2.0
#pragma once

class QWidget;

namespace ui {

/// The tab key goes through a dialog as it is laid out, row by row, whatever was made first. To be
/// called when the layout is complete.
void tabAsLaidOut(QWidget& dialog);

} // namespace ui
