// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/header/ImageQuantity.h"

#include <QStringList>

#include <algorithm>
#include <vector>

namespace core {

namespace {

struct Word {
    const char* value; ///< of an image type
    Clause quantity;
};

/// Worked out from the images of which it bears the component, too.
const std::vector<Word>& mapWords()
{
    static const std::vector<Word> words{
        {"B0", Clause::saying("field map")},
        {"B0 MAP", Clause::saying("field map")},
        {"FIELD MAP", Clause::saying("field map")},
        {"FIELDMAP", Clause::saying("field map")},
        {"B1", Clause::saying("transmit field map")},
        {"B1 MAP", Clause::saying("transmit field map")},
        {"ADC", Clause::saying("ADC map")},
        {"ADC MAP", Clause::saying("ADC map")},
        {"FA", Clause::saying("anisotropy map")},
        {"FRACTIONAL ANISOTROPY", Clause::saying("anisotropy map")},
        {"T1", Clause::saying("T1 map")},
        {"T1 MAP", Clause::saying("T1 map")},
        {"T2", Clause::saying("T2 map")},
        {"T2 MAP", Clause::saying("T2 map")},
        {"T2 STAR MAP", Clause::saying("T2* map")},
        {"R2 MAP", Clause::saying("R2 map")},
        {"R2 STAR MAP", Clause::saying("R2* map")},
        {"VELOCITY", Clause::saying("velocity")},
        {"VELOCITY MAP", Clause::saying("velocity")},
        {"W", Clause::saying("water")},
        {"WATER", Clause::saying("water")},
        {"F", Clause::saying("fat")},
        {"FAT", Clause::saying("fat")},
        {"FAT FRACTION", Clause::saying("fat fraction")},
        {"FF", Clause::saying("fat fraction")},
        {"IP", Clause::saying("in phase")},
        {"IN PHASE", Clause::saying("in phase")},
        {"OP", Clause::saying("opposed phase")},
        {"OUT PHASE", Clause::saying("opposed phase")},
        {"OPP PHASE", Clause::saying("opposed phase")},
    };
    return words;
}

const std::vector<Word>& componentWords()
{
    static const std::vector<Word> words{
        {"M", Clause::saying("magnitude")},
        {"MAGNITUDE", Clause::saying("magnitude")},
        {"P", Clause::saying("phase")},
        {"PHASE", Clause::saying("phase")},
        {"PHASE MAP", Clause::saying("phase")},
        {"R", Clause::saying("real part")},
        {"REAL", Clause::saying("real part")},
        {"I", Clause::saying("imaginary part")},
        {"IMAGINARY", Clause::saying("imaginary part")},
    };
    return words;
}

/// The quantity of the first value that the table knows; empty if it knows none.
Clause lookUp(const std::vector<Word>& words, const QStringList& values)
{
    for (const QString& value : values) {
        const auto found = std::find_if(words.begin(), words.end(),
            [&](const Word& word) { return value == QLatin1String(word.value); });
        if (found != words.end())
            return found->quantity;
    }
    return {};
}

QString normalized(const QString& value)
{
    return value.trimmed().toUpper().replace(QLatin1Char('_'), QLatin1Char(' '));
}

} // namespace

Clause imageQuantity(const QString& imageType, const QString& complexComponent)
{
    QStringList values;
    for (const QString& value : imageType.split(QLatin1Char('\\')).mid(2))
        values.append(normalized(value));
    if (const Clause map = lookUp(mapWords(), values); !map.isEmpty())
        return map;
    if (const Clause component = lookUp(componentWords(), {normalized(complexComponent)});
        !component.isEmpty())
        return component;
    // "M FFE", "R IR": the component, and the sequence.
    for (const QString& value : QStringList(values)) {
        if (value.size() > 2 && value[1] == QLatin1Char(' '))
            values.append(value.first(1));
    }
    return lookUp(componentWords(), values);
}

} // namespace core
