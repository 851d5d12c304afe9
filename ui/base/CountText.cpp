// SPDX-License-Identifier: Apache-2.0
#include "ui/base/CountText.h"

namespace ui {

QString countText(qlonglong count)
{
    QString digits = QString::number(count);
    const qsizetype first = count < 0 ? 1 : 0;
    for (qsizetype place = digits.size() - 3; place > first; place -= 3)
        digits.insert(place, QLatin1Char(' '));
    return digits;
}

} // namespace ui
