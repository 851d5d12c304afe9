// SPDX-License-Identifier: Apache-2.0
#include "core/volume/StudyListing.h"

namespace core {

QString SeriesEntry::line() const
{
    QStringList words;
    const QString patient =
        identity.patientName.isEmpty() ? identity.patientId : identity.patientName;
    words << key << (patient.isEmpty() ? QStringLiteral("no patient name") : patient);
    if (!identity.studyDate.isEmpty())
        words << identity.studyDate;
    const QString description =
        QString(identity.modality + QLatin1Char(' ') + identity.seriesDescription).trimmed();
    if (!description.isEmpty())
        words << description;
    if (!part.isEmpty())
        words << part;
    words << (slices() == 1 ? QStringLiteral("1 slice")
                            : QStringLiteral("%1 slices").arg(slices()));
    QString line = words.join(QLatin1String(", "));
    for (const VolumeProblem& problem : problems)
        line += QStringLiteral(" · ") + problem.text;
    return line;
}

std::vector<const SeriesEntry*> StudyListing::candidates() const
{
    std::vector<const SeriesEntry*> volumes;
    std::vector<const SeriesEntry*> all;
    for (const StudyEntry& study : studies) {
        for (const SeriesEntry& entry : study.series) {
            all.push_back(&entry);
            if (entry.isVolume())
                volumes.push_back(&entry);
        }
    }
    return volumes.empty() ? all : volumes;
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

} // namespace core
