// SPDX-License-Identifier: Apache-2.0
#include "ui/base/NumberText.h"

#include <QLocale>
#include <QObject>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

QString writtenOut(double value, char format, int precision)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    const QString text = locale.toString(std::abs(value), format, precision);
    const bool isZero = std::none_of(text.begin(), text.end(),
        [](QChar character) { return character.isDigit() && character.digitValue() != 0; });
    return value < 0.0 && !isZero ? minusSign + text : text;
}

} // namespace

QString numberText(double value, int decimals)
{
    return writtenOut(value, 'f', decimals);
}

int decimalsForSpan(double span)
{
    constexpr int least = 4;
    constexpr int most = 8;
    if (span >= 100.0)
        return 0;
    if (span >= 1.0)
        return span >= 10.0 ? 1 : 2;
    // Of no range there is no logarithm, and of a minute one no int.
    return span > 1e-8 ? std::clamp(int(std::ceil(3.0 - std::log10(span))), least, most)
                       : (span > 0.0 ? most : least);
}

QString digitsText(double value, int digits)
{
    return writtenOut(value, 'g', digits);
}

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
    return QObject::tr("%1 mL").arg(numberText(millilitres, millilitres < 1.0 ? 2 : 1));
}

QString millilitreText(std::int64_t voxels, double voxelVolumeMm3)
{
    if (voxels == 0)
        return QStringLiteral("—");
    const double millilitres = double(voxels) * voxelVolumeMm3 / 1000.0;
    if (millilitres >= 1000.0)
        return QObject::tr("%1 mL").arg(countText(std::llround(millilitres)));
    const int digits = millilitres < 10.0 ? 2 : 1;
    return QObject::tr("%1 mL").arg(numberText(millilitres, digits));
}

} // namespace ui
