// SPDX-License-Identifier: Apache-2.0
#pragma once

class QWidget;

namespace ui {

/// Scrolls every area around a part of a panel until the part is seen; of what is too high, @p
/// head. Does nothing if it is not visible. To be called when it is laid out.
void bringIntoView(QWidget& part, QWidget& head);

} // namespace ui
