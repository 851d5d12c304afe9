// SPDX-License-Identifier: Apache-2.0
#include "core/volume/StudyListing.h"

namespace core {

namespace {

/// A point in time that an entry has, by name; none if it is no such name.
std::optional<SeriesChoice> pointNamed(const StudyListing& listing, const QString& name)
{
    const qsizetype mark = name.lastIndexOf(QLatin1Char('@'));
    bool isNumber = false;
    const int time = name.mid(mark + 1).toInt(&isNumber);
    if (mark < 0 || !isNumber)
        return std::nullopt;
    const QString key = name.left(mark);
    for (const SeriesEntry* entry : listing.matching(key)) {
        if (time >= 1 && time <= entry->times.size())
            return SeriesChoice{.series = key, .time = time - 1};
    }
    return std::nullopt;
}

} // namespace

bool SeriesEntry::needsSpacing() const
{
    return saidSpacingMm
        && !(saidSpacingMm->x > 0.0 && saidSpacingMm->y > 0.0 && saidSpacingMm->z > 0.0);
}

QString SeriesEntry::keyAtTime(int time) const
{
    return time == 0 ? key : QStringLiteral("%1@%2").arg(key).arg(time + 1);
}

Clause SeriesEntry::line() const
{
    const QString patient =
        identity.patientName.isEmpty() ? identity.patientId : identity.patientName;
    std::vector<Clause> words{patient.isEmpty() ? Clause::saying("no patient name") : patient};
    if (!identity.studyDate.isEmpty())
        words.push_back(identity.studyDate);
    const QString description =
        QString(identity.modality + QLatin1Char(' ') + identity.seriesDescription).trimmed();
    if (!description.isEmpty())
        words.push_back(description);
    if (!part.isEmpty())
        words.push_back(part);
    words.push_back(
        slices() == 1 ? Clause::saying("1 slice") : Clause::saying("%1 slices", slices()));
    if (!times.isEmpty())
        words.push_back(Clause::saying("%1 points in time", times.size()));
    Clause line = key;
    for (const Clause& word : words)
        line = Clause::saying("%1, %2", line, word);
    for (const VolumeProblem& problem : problems)
        line = Clause::saying("%1 · %2", line, storedText(problem.said));
    return line;
}

std::vector<const SeriesEntry*> StudyListing::candidates() const
{
    std::vector<const SeriesEntry*> images;
    std::vector<const SeriesEntry*> volumes;
    std::vector<const SeriesEntry*> all;
    for (const StudyEntry& study : studies) {
        for (const SeriesEntry& entry : study.series) {
            all.push_back(&entry);
            if (entry.isVolume())
                volumes.push_back(&entry);
            if (entry.isVolume() && !entry.isDose())
                images.push_back(&entry);
        }
    }
    return !images.empty() ? images : !volumes.empty() ? volumes : all;
}

const SeriesEntry* StudyListing::find(const QString& key) const
{
    for (const StudyEntry& study : studies) {
        for (const SeriesEntry& entry : study.series) {
            if (entry.key == key)
                return &entry;
        }
    }
    return nullptr;
}

std::vector<const SeriesEntry*> StudyListing::matching(const QString& series) const
{
    if (const SeriesEntry* entry = find(series))
        return {entry};
    std::vector<const SeriesEntry*> entries;
    for (const StudyEntry& study : studies) {
        for (const SeriesEntry& entry : study.series) {
            if (entry.identity.seriesUid == series)
                entries.push_back(&entry);
        }
    }
    return entries;
}

SeriesChoice StudyListing::choice(const QString& series) const
{
    if (find(series) != nullptr)
        return {.series = series};
    // The name of a file may have a plus sign of its own.
    if (const std::optional<SeriesChoice> point = pointNamed(*this, series))
        return *point;
    SeriesChoice choice{.series = series};
    if (const qsizetype plus = series.lastIndexOf(QLatin1Char('+')); plus >= 0) {
        choice.series = series.left(plus);
        choice.repair = series.mid(plus + 1);
    }
    if (find(choice.series) != nullptr)
        return choice;
    if (const std::optional<SeriesChoice> point = pointNamed(*this, choice.series))
        return {.series = point->series, .time = point->time, .repair = choice.repair};
    return choice;
}

const SeriesEntry* StudyListing::lacksSpacing(const QString& series) const
{
    const SeriesChoice wanted = choice(series);
    const std::vector<const SeriesEntry*> found =
        wanted.series.isEmpty() ? candidates() : matching(wanted.series);
    return found.size() == 1 && wanted.repair.isEmpty() && found.front()->needsSpacing()
        ? found.front()
        : nullptr;
}

} // namespace core
