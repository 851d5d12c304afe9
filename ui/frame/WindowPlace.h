// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QRect>

class QWidget;

namespace ui {

/// Pixels that a title bar takes with most window managers, and a little more.
constexpr int titleBarPixels = 36;

/// Where a window goes that is to lie within a screen's free area, with room for its title bar: no
/// larger than that, and moved no further than it has to be.
[[nodiscard]] QRect placeWithin(const QRect& window, const QRect& available);

/// Moves a window into its screen, unless it is whole on the screens that are there (it may lie
/// over two) or fills one. Qt only moves what it restores, and never makes it smaller.
void bringOntoScreens(QWidget& window);

} // namespace ui
