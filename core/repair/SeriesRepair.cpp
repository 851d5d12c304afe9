// SPDX-License-Identifier: Apache-2.0
#include "core/repair/SeriesRepair.h"

#include <QStringList>

namespace core {

namespace {

const QString splitWord = QStringLiteral("gap=split:");
constexpr int mostParts = 9999;

/// @return what is wrong; empty if nothing is
QString take(const QString& word, SeriesRepair& repair)
{
    const auto again = [&] {
        return QStringLiteral("'%1' contradicts what is before it").arg(word);
    };
    using Lattice = SeriesRepair::Lattice;
    using Duplicates = SeriesRepair::Duplicates;
    if (word == QLatin1String("tilt")) {
        repair.tilt = true;
    } else if (word == QLatin1String("spacing=even") || word == QLatin1String("gap=fill")) {
        const Lattice wanted = word.startsWith(u'g') ? Lattice::Filled : Lattice::Even;
        if (repair.lattice != Lattice::AsIs && repair.lattice != wanted)
            return again();
        repair.lattice = wanted;
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
        if (!isNumber || part < 1 || part > mostParts)
            return QStringLiteral("'%1' does not say which part").arg(word);
        if (repair.part != 0 && repair.part != part)
            return again();
        repair.part = part;
    } else {
        return QStringLiteral("'%1' is no repair; there are tilt, spacing=even, gap=fill, "
                              "gap=split:NUMBER, duplicates=first and duplicates=last")
            .arg(word);
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
    return words.join(u',');
}

QString SeriesRepair::inWords() const
{
    QStringList words;
    if (duplicates != Duplicates::Keep)
        words += duplicates == Duplicates::First
            ? QStringLiteral("the first of several images at one place taken")
            : QStringLiteral("the last of several images at one place taken");
    if (part != 0)
        words += QStringLiteral("split at gaps, part %1 taken").arg(part);
    if (lattice != Lattice::AsIs)
        words += lattice == Lattice::Filled ? QStringLiteral("missing slices filled in")
                                            : QStringLiteral("resampled to even spacing");
    if (tilt)
        words += QStringLiteral("tilt sheared out");
    return words.join(QStringLiteral(", "));
}

std::optional<SeriesRepair> SeriesRepair::fromText(const QString& text, QString* why)
{
    SeriesRepair repair;
    for (const QString& word : text.split(u',', Qt::SkipEmptyParts)) {
        if (const QString wrong = take(word.trimmed(), repair); !wrong.isEmpty()) {
            if (why != nullptr)
                *why = wrong;
            return std::nullopt;
        }
    }
    return repair;
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
