// SPDX-License-Identifier: Apache-2.0
#pragma once

class QDoubleSpinBox;
class QWidget;

namespace ui {

/// Width in pixels that is enough for the values of a CT.
constexpr int valueFieldWidth = 96;

/// Creates a field for a value of any volume, for a row of options. It has no buttons and reports a
/// typed number when typing has ended.
[[nodiscard]] QDoubleSpinBox* valueField(QWidget* parent, const char* name);

/// The decimals of a field for values of a volume whose range is @p span wide: none, except for
/// narrow ranges, as of a volume of fractions.
[[nodiscard]] int valueFieldDecimals(double span);

} // namespace ui
