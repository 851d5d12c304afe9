// SPDX-License-Identifier: Apache-2.0
#include "core/repair/SeriesRepair.h"

#include <QLocale>
#include <QStringList>

#include <vector>

namespace core {

namespace {

const QString spacingStart = QStringLiteral("spacing=");
const QString splitWord = QStringLiteral("gap=split:");
constexpr int highestPart = 9999;

/// As short as says the very number.
QString numberText(double value)
{
    return QString::number(value, 'g', QLocale::FloatingPointShortest);
}

std::optional<std::array<double, 3>> spacingFrom(const QString& text)
{
    constexpr double leastMm = 1e-7;
    constexpr double mostMm = 1e5;
    const QStringList parts = QString(text).replace(u',', u'x').split(u'x');
    std::array<double, 3> spacing{};
    if (parts.size() != qsizetype(spacing.size()))
        return std::nullopt;
    for (std::size_t axis = 0; axis < spacing.size(); ++axis) {
        bool isNumber = false;
        spacing[axis] = parts[qsizetype(axis)].trimmed().toDouble(&isNumber);
        if (!isNumber || !(spacing[axis] >= leastMm) || !(spacing[axis] <= mostMm))
            return std::nullopt;
    }
    return spacing;
}

/// @return what is wrong; empty if nothing is
Clause take(const QString& word, SeriesRepair& repair)
{
    const auto again = [&] { return Clause::saying("'%1' contradicts what is before it", word); };
    using Lattice = SeriesRepair::Lattice;
    using Duplicates = SeriesRepair::Duplicates;
    if (word == QLatin1String("tilt")) {
        repair.tilt = true;
    } else if (word == QLatin1String("spacing=even") || word == QLatin1String("gap=fill")) {
        const Lattice wanted = word.startsWith(u'g') ? Lattice::Filled : Lattice::Even;
        if (repair.lattice != Lattice::AsIs && repair.lattice != wanted)
            return again();
        repair.lattice = wanted;
    } else if (const auto given = word.startsWith(spacingStart)
            ? spacingFrom(word.mid(spacingStart.size()))
            : std::nullopt) {
        if (repair.givenSpacingMm && repair.givenSpacingMm != given)
            return again();
        repair.givenSpacingMm = given;
    } else if (word == QLatin1String("duplicates=first")
        || word == QLatin1String("duplicates=last")) {
        const Duplicates wanted =
            word.endsWith(QLatin1String("first")) ? Duplicates::First : Duplicates::Last;
        if (repair.duplicates != Duplicates::Keep && repair.duplicates != wanted)
            return again();
        repair.duplicates = wanted;
    } else if (word.startsWith(splitWord)) {
        bool isNumber = false;
        const int part = word.mid(splitWord.size()).toInt(&isNumber);
        if (!isNumber || part < 1 || part > highestPart)
            return Clause::saying("'%1' does not say which part", word);
        if (repair.part != 0 && repair.part != part)
            return again();
        repair.part = part;
    } else {
        return Clause::saying("'%1' is no repair; there are tilt, spacing=even, gap=fill, "
                              "gap=split:NUMBER, duplicates=first, duplicates=last and "
                              "spacing=COLUMNSxROWSxSLICES",
            word);
    }
    return {};
}

} // namespace

QString SeriesRepair::toText() const
{
    QStringList words;
    if (duplicates != Duplicates::Keep)
        words += duplicates == Duplicates::First ? QStringLiteral("duplicates=first")
                                                 : QStringLiteral("duplicates=last");
    if (part != 0)
        words += splitWord + QString::number(part);
    if (lattice != Lattice::AsIs)
        words += lattice == Lattice::Filled ? QStringLiteral("gap=fill")
                                            : QStringLiteral("spacing=even");
    if (tilt)
        words += QStringLiteral("tilt");
    if (givenSpacingMm) {
        const auto& mm = *givenSpacingMm;
        words += spacingStart
            + QStringList{numberText(mm[0]), numberText(mm[1]), numberText(mm[2])}.join(u'x');
    }
    return words.join(u',');
}

Clause SeriesRepair::inWords() const
{
    std::vector<Clause> words;
    if (duplicates != Duplicates::Keep)
        words.push_back(duplicates == Duplicates::First
                ? Clause::saying("the first of several images at one place taken")
                : Clause::saying("the last of several images at one place taken"));
    if (part != 0)
        words.push_back(Clause::saying("split at gaps, part %1 taken", part));
    if (lattice != Lattice::AsIs)
        words.push_back(lattice == Lattice::Filled ? Clause::saying("missing slices filled in")
                                                   : Clause::saying("resampled to even spacing"));
    if (tilt)
        words.push_back(Clause::saying("tilt sheared out"));
    if (givenSpacingMm) {
        const auto& mm = *givenSpacingMm;
        words.push_back(Clause::saying("voxels of %1 × %2 × %3 mm as given", numberText(mm[0]),
            numberText(mm[1]), numberText(mm[2])));
    }
    Clause all;
    for (const Clause& word : words)
        all = all.isEmpty() ? word : Clause::saying("%1, %2", all, word);
    return all;
}

std::optional<SeriesRepair> SeriesRepair::fromText(const QString& text, Clause* why)
{
    SeriesRepair repair;
    for (const QString& word : text.split(u',', Qt::SkipEmptyParts)) {
        if (const Clause wrong = take(word.trimmed(), repair); !wrong.isEmpty()) {
            if (why != nullptr)
                *why = wrong;
            return std::nullopt;
        }
    }
    return repair;
}

SeriesRepair SeriesRepair::withoutSpacing() const
{
    SeriesRepair rest = *this;
    rest.givenSpacingMm.reset();
    return rest;
}

std::optional<QString> spacingWord(const QString& sizes, Clause* why)
{
    const std::optional<std::array<double, 3>> spacing = spacingFrom(sizes);
    if (spacing)
        return SeriesRepair{.givenSpacingMm = spacing}.toText();
    if (why != nullptr)
        *why = Clause::saying("'%1' is no spacing; three lengths in mm are: columns, rows, slices, "
                              "as in 0.5,0.5,2",
            sizes);
    return std::nullopt;
}

QString repairStamp(const QString& repair)
{
    const std::optional<SeriesRepair> read = SeriesRepair::fromText(repair);
    return read && !read->isNone()
        ? QStringLiteral("Drawn on the series repaired on loading: %1 (%2)")
              .arg(read->inWords(), repair)
        : QString();
}

QString withRepair(const QString& series, const QString& repair)
{
    return repair.isEmpty() ? series : series + u'+' + repair;
}

} // namespace core
