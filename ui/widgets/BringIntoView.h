// SPDX-License-Identifier: Apache-2.0
#pragma once

class QWidget;

namespace ui {

/// Scrolls every area around a part of a panel until the part is seen; of what is too high, @p
/// head. Does nothing if it is not visible. What has been shown just now is laid out first.
void bringIntoView(QWidget& part, QWidget& head);

} // namespace ui
