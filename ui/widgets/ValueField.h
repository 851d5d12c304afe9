// SPDX-License-Identifier: Apache-2.0
#pragma once

class QDoubleSpinBox;
class QWidget;

namespace ui {

/// Wide enough for the values of a CT.
constexpr int valueFieldWidth = 96;

/// A field for a number among the values of any volume, for a row of options: it has no buttons,
/// and takes what is typed when the typing has ended.
[[nodiscard]] QDoubleSpinBox* valueField(QWidget* parent, const char* name);

} // namespace ui
