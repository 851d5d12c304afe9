// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/header/ImageQuantity.h"

#include <QStringList>

#include <algorithm>
#include <iterator>

namespace core {

namespace {

struct Word {
    const char* value; ///< of an image type
    const char* quantity;
};

/// Worked out from the images of which it bears the component, too.
constexpr Word maps[] = {
    {"B0", "field map"},
    {"B0 MAP", "field map"},
    {"FIELD MAP", "field map"},
    {"FIELDMAP", "field map"},
    {"B1", "transmit field map"},
    {"B1 MAP", "transmit field map"},
    {"ADC", "ADC map"},
    {"ADC MAP", "ADC map"},
    {"FA", "anisotropy map"},
    {"FRACTIONAL ANISOTROPY", "anisotropy map"},
    {"T1", "T1 map"},
    {"T1 MAP", "T1 map"},
    {"T2", "T2 map"},
    {"T2 MAP", "T2 map"},
    {"T2 STAR MAP", "T2* map"},
    {"R2 MAP", "R2 map"},
    {"R2 STAR MAP", "R2* map"},
    {"VELOCITY", "velocity"},
    {"VELOCITY MAP", "velocity"},
    {"W", "water"},
    {"WATER", "water"},
    {"F", "fat"},
    {"FAT", "fat"},
    {"FAT FRACTION", "fat fraction"},
    {"FF", "fat fraction"},
    {"IP", "in phase"},
    {"IN PHASE", "in phase"},
    {"OP", "opposed phase"},
    {"OUT PHASE", "opposed phase"},
    {"OPP PHASE", "opposed phase"},
};

constexpr Word components[] = {
    {"M", "magnitude"},
    {"MAGNITUDE", "magnitude"},
    {"P", "phase"},
    {"PHASE", "phase"},
    {"PHASE MAP", "phase"},
    {"R", "real part"},
    {"REAL", "real part"},
    {"I", "imaginary part"},
    {"IMAGINARY", "imaginary part"},
};

/// The quantity of the first value that the table knows; empty if it knows none.
template <typename Words> QString lookUp(const Words& words, const QStringList& values)
{
    for (const QString& value : values) {
        const auto found = std::find_if(std::begin(words), std::end(words),
            [&](const Word& word) { return value == QLatin1String(word.value); });
        if (found != std::end(words))
            return QString::fromLatin1(found->quantity);
    }
    return {};
}

QString normalized(const QString& value)
{
    return value.trimmed().toUpper().replace(QLatin1Char('_'), QLatin1Char(' '));
}

} // namespace

QString imageQuantity(const QString& imageType, const QString& complexComponent)
{
    QStringList values;
    for (const QString& value : imageType.split(QLatin1Char('\\')).mid(2))
        values.append(normalized(value));
    if (const QString map = lookUp(maps, values); !map.isEmpty())
        return map;
    if (const QString component = lookUp(components, {normalized(complexComponent)});
        !component.isEmpty())
        return component;
    // "M FFE", "R IR": the component, and the sequence.
    for (const QString& value : QStringList(values)) {
        if (value.size() > 2 && value[1] == QLatin1Char(' '))
            values.append(value.first(1));
    }
    return lookUp(components, values);
}

} // namespace core
