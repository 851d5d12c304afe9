// SPDX-License-Identifier: Apache-2.0
#include "ui/base/CountText.h"

#include <QLocale>
#include <QObject>

#include <cmath>

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

QString millilitreText(std::int64_t voxels, double voxelVolumeMm3)
{
    if (voxels == 0)
        return QStringLiteral("—");
    const double millilitres = double(voxels) * voxelVolumeMm3 / 1000.0;
    if (millilitres >= 1000.0)
        return QObject::tr("%1 mL").arg(countText(std::llround(millilitres)));
    const int digits = millilitres < 10.0 ? 2 : 1;
    return QObject::tr("%1 mL").arg(QLocale().toString(millilitres, 'f', digits));
}

} // namespace ui
