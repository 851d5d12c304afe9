// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/Tool.h"

class QToolButton;
class QWidget;

namespace ui {

/// The share of a tool's radius at a report of the pen. What only touches still has a tenth of it,
/// since a tool of no size would do nothing and tell nobody why; a mouse has all of it.
[[nodiscard]] double pressedShare(const PointerSample& sample);

/// Whether a pen that rests is pressed so much harder that its tool has to cover more.
[[nodiscard]] bool pressesHarder(double share, double before);

/// The switch "p" in a tool's options, as the drill has one for its depth: the radius follows the
/// pressure of the pen, or nothing does.
[[nodiscard]] QToolButton* pressureButton(QWidget* parent);

} // namespace ui
