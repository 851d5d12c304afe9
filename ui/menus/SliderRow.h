// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <functional>

class QMenu;
class QSlider;

namespace ui {

/// A row of a menu with a slider in percent, which the wheel moves, too.
struct SliderRow {
    const char* id; ///< the slider's object name
    QString text; ///< before the slider
    QString accessibleName;
    QString tip;
    int least = 0; ///< up to 100
    int now = 100;
    std::function<void(int)> changed;
};

/// Adds it; the menu stays open while it is moved.
/// @return the slider
QSlider* addSliderRow(QMenu& menu, const SliderRow& row);

} // namespace ui
