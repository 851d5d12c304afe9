// SPDX-License-Identifier: Apache-2.0
#include "core/export/common/StatisticsText.h"

#include "core/measure/MeasuredSize.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>
#include <charconv>

namespace core {

namespace {

/// As short as brings the same number back.
QByteArray numberText(double value)
{
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), qsizetype(end.ptr - text.data())};
}

QByteArray cell(const QString& text)
{
    QByteArray bytes = noFormula(text).toUtf8();
    if (!bytes.contains(',') && !bytes.contains('"') && !bytes.contains('\n')
        && !bytes.contains('\r'))
        return bytes;
    return '"' + bytes.replace("\"", "\"\"") + '"';
}

/// Whether a number is there although the source does not state the spacing. Those that are not
/// would be millimetres that nobody measured.
bool isKnown(const StatisticsNumber& number, bool spacingIsKnown)
{
    static constexpr std::array ofSpacing{"volumeMl", "surfaceMm2", "sphericity",
        "longestDiameterMm", "acrossDiameterMm", "importAddedMl", "importTakenMl"};
    return spacingIsKnown
        || std::none_of(ofSpacing.begin(), ofSpacing.end(), [&number](const char* name) {
               return QLatin1String(name) == QLatin1String(number.name);
           });
}

} // namespace

QString noFormula(const QString& text)
{
    const auto first = std::find_if(
        text.begin(), text.end(), [](QChar letter) { return letter != QLatin1Char('\''); });
    const bool isTaken = first != text.end() && QStringLiteral("=+-@").contains(*first);
    return isTaken ? QLatin1Char('\'') + text : text;
}

std::vector<StatisticsNumber> numbersOf(const SegmentStatistics& s)
{
    static constexpr std::array percentileNames{"percentile5", "percentile10", "percentile25",
        "percentile75", "percentile90", "percentile95"};
    static_assert(percentileNames.size() == statisticsPercentiles.size());
    std::vector<StatisticsNumber> numbers{{"voxels", double(s.voxels)}, {"volumeMl", s.millilitres},
        {"surfaceMm2", s.surfaceMm2}, {"sphericity", s.sphericity},
        {"longestDiameterMm", s.longestMm}, {"acrossDiameterMm", s.acrossMm},
        {"firstColumn", double(s.first.x)}, {"firstRow", double(s.first.y)},
        {"firstSlice", double(s.first.z)}, {"lastColumn", double(s.last.x)},
        {"lastRow", double(s.last.y)}, {"lastSlice", double(s.last.z)},
        {"lowestLeftMm", s.lowestLps.x}, {"lowestPosteriorMm", s.lowestLps.y},
        {"lowestSuperiorMm", s.lowestLps.z}, {"highestLeftMm", s.highestLps.x},
        {"highestPosteriorMm", s.highestLps.y}, {"highestSuperiorMm", s.highestLps.z},
        {"centroidLeftMm", s.centroidLps.x}, {"centroidPosteriorMm", s.centroidLps.y},
        {"centroidSuperiorMm", s.centroidLps.z}, {"minimum", s.minimum}, {"maximum", s.maximum},
        {"mean", s.mean}, {"standardDeviation", s.deviation}, {"median", s.median}};
    for (std::size_t i = 0; i < percentileNames.size(); ++i)
        numbers.push_back({percentileNames[i], s.percentiles[i]});
    if (s.sinceImport) {
        numbers.push_back({"importAddedMl", s.sinceImport->addedMl});
        numbers.push_back({"importTakenMl", s.sinceImport->takenMl});
        numbers.push_back({"importDice", s.sinceImport->dice});
    }
    return numbers;
}

QByteArray statisticsCsv(const std::vector<SegmentStatistics>& all, const Volume& volume)
{
    const bool spacingIsKnown = unknownSpacing(volume) == UnknownSpacing::Nothing;
    QByteArray text = "label,name,codingScheme,code,meaning,unit";
    // Columns of the import are there if a segment was imported, and empty for the others.
    SegmentStatistics columns;
    for (const SegmentStatistics& each : all) {
        if (each.sinceImport)
            columns.sinceImport.emplace();
    }
    const std::vector<StatisticsNumber> names = numbersOf(columns);
    for (const StatisticsNumber& number : names)
        text += QByteArray(",") + number.name;
    text += "\r\n";
    for (const SegmentStatistics& each : all) {
        const Segment& segment = each.segment;
        text += QByteArray::number(int(segment.label));
        for (const QString& word : {segment.name, segment.code.scheme, segment.code.value,
                 segment.code.meaning, volume.unit})
            text += ',' + cell(word);
        const std::vector<StatisticsNumber> numbers = numbersOf(each);
        for (const StatisticsNumber& number : numbers) {
            text += ',';
            if (isKnown(number, spacingIsKnown))
                text += numberText(number.value);
        }
        text += QByteArray(qsizetype(names.size() - numbers.size()), ',') + "\r\n";
    }
    return text;
}

QByteArray statisticsJson(
    const std::vector<SegmentStatistics>& all, const Volume& volume, const StudyIdentity& identity)
{
    const bool spacingIsKnown = unknownSpacing(volume) == UnknownSpacing::Nothing;
    QJsonArray segments;
    for (const SegmentStatistics& each : all) {
        const Segment& segment = each.segment;
        QJsonObject entry{
            {QStringLiteral("label"), int(segment.label)}, {QStringLiteral("name"), segment.name}};
        if (segment.code.isSet())
            entry[QStringLiteral("code")] =
                QJsonArray{segment.code.scheme, segment.code.value, segment.code.meaning};
        for (const StatisticsNumber& number : numbersOf(each)) {
            if (isKnown(number, spacingIsKnown))
                entry[QLatin1String(number.name)] = number.value;
        }
        segments.append(entry);
    }
    QJsonObject study{{QStringLiteral("studyUid"), identity.studyUid},
        {QStringLiteral("seriesUid"), identity.seriesUid},
        {QStringLiteral("modality"), identity.modality}};
    // All points of a series in time have its UIDs.
    if (volume.alternatives && volume.alternatives->times.size() > 1) {
        study[QStringLiteral("pointInTime")] = volume.alternatives->time + 1;
        study[QStringLiteral("pointsInTime")] = qint64(volume.alternatives->times.size());
    }
    return QJsonDocument(
        QJsonObject{{QStringLiteral("study"), study}, {QStringLiteral("unit"), volume.unit},
            {QStringLiteral("segments"), segments}})
        .toJson();
}

} // namespace core
