// SPDX-License-Identifier: Apache-2.0
#include "core/images/ImageSpacing.h"

#include <QList>

#include <algorithm>
#include <cmath>

namespace core {

namespace {

/// Nothing between voxels of pictures is smaller or larger.
constexpr double leastMm = 1e-7;
constexpr double mostMm = 1e5;

double sensible(double millimetres)
{
    return millimetres >= leastMm && millimetres <= mostMm ? millimetres : 0.0;
}

bool isOfScreens(double perInch)
{
    constexpr double nearly = 0.05;
    return std::abs(perInch - 72.0) < nearly || std::abs(perInch - 96.0) < nearly;
}

double millimetresOf(const QByteArray& unit)
{
    if (unit == "mm" || unit.startsWith("millimet"))
        return 1.0;
    // The last two as ImageJ escapes the Greek letter, and in Latin-1.
    if (unit == "um" || unit == "micron" || unit == "microns" || unit == "\\u00B5m"
        || unit == "\xb5m" || unit == "\xc2\xb5m" || unit.startsWith("micromet"))
        return 1e-3;
    if (unit == "nm" || unit.startsWith("nanomet"))
        return 1e-6;
    if (unit == "cm" || unit.startsWith("centimet"))
        return 10.0;
    if (unit == "inch" || unit == "in")
        return millimetresPerInch;
    return unit == "m" ? millimetresPerMetre : 0.0;
}

int countIn(const QByteArray& value)
{
    constexpr int most = 1 << 24;
    return std::clamp(value.toInt(), 1, most);
}

} // namespace

void setResolution(
    glm::dvec3& spacingMm, double columnsPerUnit, double rowsPerUnit, double millimetresPerUnit)
{
    const double perInch = columnsPerUnit * millimetresPerInch / millimetresPerUnit;
    if (!(columnsPerUnit > 0.0) || !(rowsPerUnit > 0.0) || isOfScreens(perInch))
        return;
    spacingMm.x = sensible(millimetresPerUnit / columnsPerUnit);
    spacingMm.y = sensible(millimetresPerUnit / rowsPerUnit);
}

ImageJWords imageJWords(const QByteArray& description)
{
    ImageJWords words;
    words.isImageJ = description.startsWith("ImageJ=");
    if (!words.isImageJ)
        return words;
    int channels = 1;
    int frames = 1;
    for (const QByteArray& line : description.split('\n')) {
        const qsizetype mark = line.indexOf('=');
        const QByteArray name = line.left(mark);
        const QByteArray value = line.mid(mark + 1).trimmed();
        if (name == "images")
            words.images = countIn(value);
        else if (name == "channels")
            channels = countIn(value);
        else if (name == "frames")
            frames = countIn(value);
        else if (name == "spacing")
            words.spacing = std::abs(value.toDouble());
        else if (name == "unit")
            words.millimetresPerUnit = millimetresOf(value);
    }
    words.perPlace = std::max(channels, frames);
    words.spacing = sensible(words.spacing * words.millimetresPerUnit) > 0.0 ? words.spacing : 0.0;
    return words;
}

} // namespace core
