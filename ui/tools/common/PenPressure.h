// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/Tool.h"

class QToolButton;
class QWidget;

namespace ui {

/// Returns the share of a tool's radius for a pointer sample, 0.1 … 1: the pen's pressure, but at
/// least a tenth, because a tool of no size would do nothing and the user would not see why. A
/// mouse always gives 1.
[[nodiscard]] double pressedShare(const PointerSample& sample);

/// Whether a pen at rest is pressed so much harder than before that its tool has to cover more.
[[nodiscard]] bool pressesHarder(double share, double before);

/// How hard a pen is pressed at most in a stroke that has one size, such as the depth of a curve:
/// it touches down and is lifted lightly, and a hand does not hold one pressure all along a curve.
class StrokePressure {
public:
    /// @param counts whether the pen's pressure is the size; that of a mouse never is
    void begin(const PointerSample& sample, bool counts);
    void extend(const PointerSample& sample);
    void end() { *this = {}; }

    /// Whether the size is not known before the stroke ends.
    [[nodiscard]] bool counts() const { return m_counts; }
    /// The size so far, mm: the share of what is set that is pressed, to a tenth of a millimetre.
    /// Where pressure does not count, all of it.
    [[nodiscard]] double of(double setMm, double leastMm) const;

private:
    bool m_counts = false;
    double m_share = 1.0;
};

/// Creates the switch with the pressed pen of a tool's options. On: the radius follows the pressure
/// of the pen. Off: pressure has no effect.
[[nodiscard]] QToolButton* pressureButton(QWidget* parent);
/// The same for the depth of a curve.
[[nodiscard]] QToolButton* depthPressureButton(QWidget* parent);

} // namespace ui
