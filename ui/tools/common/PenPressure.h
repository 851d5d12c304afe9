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

/// Creates the switch with the pressed pen of a tool's options. On: the radius follows the pressure
/// of the pen. Off: pressure has no effect.
[[nodiscard]] QToolButton* pressureButton(QWidget* parent);

} // namespace ui
