// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/fields/ValueField.h"

#include "ui/base/NumberText.h"
#include "ui/base/Theme.h"
#include "ui/widgets/fields/NumberField.h"

#include <QDoubleSpinBox>

#include <algorithm>

namespace ui {

QDoubleSpinBox* valueField(QWidget* parent, const char* name)
{
    constexpr double farthestValue = 1e6;
    auto* field = new NumberField(parent);
    field->setObjectName(QLatin1String(name));
    field->setFixedHeight(theme::controlHeight);
    field->setKeyboardTracking(false);
    field->setButtonSymbols(QAbstractSpinBox::NoButtons);
    field->setRange(-farthestValue, farthestValue);
    return field;
}

int valueFieldDecimals(double span)
{
    return span < 50.0 ? std::max(3, decimalsForSpan(span)) : 0;
}

} // namespace ui
