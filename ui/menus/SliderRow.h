// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <functional>

class QMenu;
class QSlider;

namespace ui {

/// A menu row with a slider in percent. The mouse wheel over the row moves the slider, too.
struct SliderRow {
    const char* id; ///< the slider's object name
    QString text; ///< label to the left of the slider
    QString accessibleName;
    QString tip;
    int least = 0; ///< lower end of its range; the upper end is 100
    int now = 100; ///< its value at first
    std::function<void(int)> changed;
};

/// Adds the row to a menu. The menu stays open while the slider is moved.
QSlider* addSliderRow(QMenu& menu, const SliderRow& row);

} // namespace ui
