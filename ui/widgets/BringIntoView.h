// SPDX-License-Identifier: Apache-2.0
#pragma once

class QWidget;

namespace ui {

/// Scrolls every scroll area around a part of a panel until the part is visible or, if it is too
/// tall, its @p head. Does nothing if the part is hidden. Widgets that were just shown are laid out
/// first.
void bringIntoView(QWidget& part, QWidget& head);

} // namespace ui
