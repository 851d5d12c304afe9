// SPDX-License-Identifier: Apache-2.0
#include "app/commands/pacs/FindCommand.h"

#include "app/steps/JsonLine.h"
#include "app/steps/SourceArguments.h"
#include "core/sources/PacsSource.h"

#include <QDate>
#include <QJsonArray>

#include <algorithm>
#include <cstdio>

namespace app {

namespace {

QString word(const char* text)
{
    return QLatin1String(text);
}

/// Nodes differ in what they make of anything else; some then list all that they hold.
bool isDateOrRange(const QString& text)
{
    const QStringList days = text.split(u'-');
    const bool isRange = days.size() == 2 && text.size() > 1;
    return (isRange || days.size() == 1)
        && std::all_of(days.begin(), days.end(), [isRange](const QString& day) {
               return (isRange && day.isEmpty())
                   || QDate::fromString(day, QStringLiteral("yyyyMMdd")).isValid();
           });
}

QJsonValue count(int number)
{
    return number < 0 ? QJsonValue() : QJsonValue(number);
}

QString countText(int number, const char* of)
{
    return QStringLiteral("%1 %2").arg(
        number < 0 ? QStringLiteral("?") : QString::number(number), QLatin1String(of));
}

QJsonObject json(const core::StudyHit& hit)
{
    return {{word("studyUid"), hit.studyUid}, {word("patientName"), hit.patientName},
        {word("patientId"), hit.patientId}, {word("birthDate"), hit.birthDate},
        {word("studyDate"), hit.studyDate}, {word("accessionNumber"), hit.accessionNumber},
        {word("description"), hit.description},
        {word("modalities"), QJsonArray::fromStringList(hit.modalities)},
        {word("seriesCount"), count(hit.series)}, {word("instanceCount"), count(hit.instances)}};
}

QJsonObject json(const core::SeriesHit& hit)
{
    return {{word("studyUid"), hit.studyUid}, {word("seriesUid"), hit.seriesUid},
        {word("modality"), hit.modality}, {word("number"), hit.number},
        {word("description"), hit.description}, {word("bodyPart"), hit.bodyPart},
        {word("instanceCount"), count(hit.instances)}};
}

void print(const core::StudyHit& hit)
{
    std::printf("%s  %s  born %s  study of %s  %s  %s, %s\n    study    %s\n",
        qUtf8Printable(hit.patientName), qUtf8Printable(hit.patientId),
        qUtf8Printable(hit.birthDate), qUtf8Printable(hit.studyDate),
        qUtf8Printable(hit.modalities.join(u'/') + u' ' + hit.description),
        qUtf8Printable(countText(hit.series, "series")),
        qUtf8Printable(countText(hit.instances, "images")), qUtf8Printable(hit.studyUid));
}

void print(const core::SeriesHit& hit)
{
    std::printf("%s %s  %s  %s\n    series   %s\n", qUtf8Printable(hit.modality),
        qUtf8Printable(hit.number), qUtf8Printable(hit.description),
        qUtf8Printable(countText(hit.instances, "images")), qUtf8Printable(hit.seriesUid));
}

template <class Hit> void printHits(const std::vector<Hit>& hits, bool asJson)
{
    for (const Hit& hit : hits) {
        if (asJson)
            printJsonLine(json(hit));
        else
            print(hit);
    }
}

int findSeriesOf(const core::PacsSource& source, const QString& studyUid, bool asJson)
{
    const core::Result<std::vector<core::SeriesHit>> found =
        core::findSeries(source, studyUid, core::Progress());
    if (!found)
        return reportFailure(found.error());
    printHits(*found, asJson);
    if (found->empty())
        std::fprintf(stderr, "burin: no series of that study is there\n");
    return 0;
}

int runFind(const Arguments& arguments)
{
    const core::Result<core::PacsSource> source = sourceOf(arguments);
    if (!source)
        return reportUsageError("find", sourceProblem(source.error()));
    if (arguments.rest().size() > 1)
        return reportUsageError("find", QStringLiteral("one source at a time"));
    const bool asJson = arguments.has("json");
    for (const char* option :
        {"patient-name", "patient-id", "date", "modality", "accession", "description", "most"}) {
        if (arguments.has("study") && arguments.has(option))
            return reportUsageError("find",
                QStringLiteral("--study lists all series of one study; --%1 is for studies")
                    .arg(QLatin1String(option)));
    }
    if (arguments.has("date") && !isDateOrRange(arguments.value("date")))
        return reportUsageError("find",
            QStringLiteral("--date takes YYYYMMDD, or two such dates with a hyphen between, of "
                           "which one may be missing"));
    if (arguments.has("study"))
        return findSeriesOf(*source, arguments.value("study"), asJson);
    constexpr int usualMost = 500;
    const int most = arguments.has("most") ? arguments.value("most").toInt() : usualMost;
    if (most < 1)
        return reportUsageError("find", QStringLiteral("--most takes a number from 1"));
    const core::StudyFilter filter{.patientName = arguments.value("patient-name"),
        .patientId = arguments.value("patient-id"),
        .studyDate = arguments.value("date"),
        .modality = arguments.value("modality"),
        .accessionNumber = arguments.value("accession"),
        .description = arguments.value("description"),
        .studyUid = {}};
    const core::Result<core::HitList<core::StudyHit>> found =
        core::findStudies(*source, filter, most, core::Progress());
    if (!found)
        return reportFailure(found.error());
    printHits(found->hits, asJson);
    // Silence would leave it open whether anybody was asked.
    if (found->hits.empty())
        std::fprintf(stderr, "burin: no study there matches\n");
    if (found->more)
        std::fprintf(stderr, "burin: there are more than %d studies; --most shows more\n", most);
    return 0;
}

} // namespace

const Command findCommand{.name = "find",
    .words = "SOURCE",
    .usage = "SOURCE [--patient-name NAME] [--patient-id ID] [--date FROM-TO] [--modality MODALITY]"
             " [--accession NUMBER] [--description TEXT] [--most NUMBER] [--json] | SOURCE --study "
             "UID",
    .summary = "lists the studies at a source, or the series of one; * and ? stand for letters, "
               "and dates are YYYYMMDD",
    .options =
        std::vector<Option>{{"patient-name", "NAME",
                                "the patient's name; * and ? stand for letters, here and below"},
            {"patient-id", "ID", "the patient's number"},
            {"date", "FROM-TO",
                "the study's date as YYYYMMDD, or two dates with a hyphen between, of which one "
                "may be missing"},
            {"modality", "MODALITY", "the modality, such as CT, MR or PT"},
            {"accession", "NUMBER", "the accession number"},
            {"description", "TEXT", "the study's description"},
            {"study", "UID", "lists the series of this study instead of studies"},
            {"most", "NUMBER", "the greatest number of results"},
            {"json", nullptr, "prints a line of JSON for each result"}}
        + sourceOptions(),
    .run = runFind};

} // namespace app
