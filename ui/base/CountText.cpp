// SPDX-License-Identifier: Apache-2.0
#include "ui/base/CountText.h"

#include <QLocale>
#include <QObject>

namespace ui {

QString countText(qlonglong count)
{
    QString digits = QString::number(count);
    const qsizetype first = count < 0 ? 1 : 0;
    for (qsizetype place = digits.size() - 3; place > first; place -= 3)
        digits.insert(place, QLatin1Char(' '));
    return digits;
}

QString volumeText(double millilitres)
{
    return QObject::tr("%1 mL").arg(
        QLocale().toString(millilitres, 'f', millilitres < 1.0 ? 2 : 1));
}

} // namespace ui
