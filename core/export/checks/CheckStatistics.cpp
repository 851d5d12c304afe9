// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/deidentify/Deidentifier.h"
#include "core/dicom/objects/SegReader.h"
#include "core/dicom/objects/SrReader.h"
#include "core/export/common/CheckSources.h"
#include "core/measure/MeasuredSize.h"
#include "core/measure/region/RegionStatistics.h"

#include <QFile>
#include <QHash>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <map>

namespace core {

namespace {

constexpr double relativeTolerance = 1e-9;
/// A decimal string has 16 characters.
constexpr double reportTolerance = 1e-8;

using Numbers = std::map<QString, double>;

/// What can be said of a segment by looking at one voxel after the other, in no clever way.
Numbers countedAnew(const ExportExpectation& expected, const Segment& segment)
{
    const Volume& volume = expected.volume;
    const glm::ivec3 size = volume.geometry.size;
    std::span<const std::uint8_t> labels;
    for (const LabelPlaneView& plane : expected.planes) {
        if (plane.plane == segment.plane)
            labels = plane.labels;
    }
    std::vector<double> values;
    glm::dvec3 sum(0.0);
    glm::ivec3 first = size;
    glm::ivec3 last(-1);
    std::size_t i = 0;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x, ++i) {
                if (i >= labels.size() || labels[i] != segment.label)
                    continue;
                values.push_back(volume.encoding.value(expected.codes[i]));
                sum += sliceOrigin(volume.geometry, z)
                    + glm::dmat3(volume.geometry.indexToWorld) * glm::dvec3(x, y, 0);
                first = glm::min(first, glm::ivec3(x, y, z));
                last = glm::max(last, glm::ivec3(x, y, z));
            }
        }
    }
    std::sort(values.begin(), values.end());
    const auto count = double(values.size());
    double total = 0.0;
    for (const double value : values)
        total += value;
    double squares = 0.0;
    for (const double value : values)
        squares += (value - total / count) * (value - total / count);
    const auto share = [&](double percent) {
        return values[std::size_t(std::max(1.0, std::ceil(count * percent / 100.0))) - 1];
    };
    Numbers numbers{{QStringLiteral("voxels"), count}, {QStringLiteral("firstColumn"), first.x},
        {QStringLiteral("firstRow"), first.y}, {QStringLiteral("firstSlice"), first.z},
        {QStringLiteral("lastColumn"), last.x}, {QStringLiteral("lastRow"), last.y},
        {QStringLiteral("lastSlice"), last.z}, {QStringLiteral("centroidLeftMm"), sum.x / count},
        {QStringLiteral("centroidPosteriorMm"), sum.y / count},
        {QStringLiteral("centroidSuperiorMm"), sum.z / count},
        {QStringLiteral("minimum"), values.front()}, {QStringLiteral("maximum"), values.back()},
        {QStringLiteral("mean"), total / count},
        {QStringLiteral("standardDeviation"), std::sqrt(squares / count)},
        {QStringLiteral("median"), share(50)}};
    for (const int percent : {5, 10, 25, 75, 90, 95})
        numbers[QStringLiteral("percentile%1").arg(percent)] = share(percent);
    // Where there are no gaps between slices, every voxel is as large as the grid's.
    const bool isEven = volume.geometry.slicePositions.empty();
    const double voxelMl = volume.geometry.voxelVolumeMm3() / 1000.0;
    if (isEven)
        numbers[QStringLiteral("volumeMl")] = count * voxelMl;
    for (const ImportedVoxels& imported : expected.imported) {
        if (imported.label != segment.label)
            continue;
        std::vector<bool> was(labels.size(), false);
        for (const VoxelRun& run : imported.voxels.runs()) {
            for (std::uint64_t at = run.first; at < run.first + run.count; ++at)
                was[std::size_t(at)] = true;
        }
        double added = 0.0;
        double taken = 0.0;
        for (std::size_t at = 0; at < was.size(); ++at) {
            const bool is = labels[at] == segment.label;
            added += is && !was[at] ? 1.0 : 0.0;
            taken += was[at] && !is ? 1.0 : 0.0;
        }
        // What both have counts twice in the sum of both.
        numbers[QStringLiteral("importDice")] =
            2.0 * (count - added) / (2.0 * (count - added) + added + taken);
        if (isEven) {
            numbers[QStringLiteral("importAddedMl")] = added * voxelMl;
            numbers[QStringLiteral("importTakenMl")] = taken * voxelMl;
        }
    }
    return numbers;
}

/// One cell after the other of a line of RFC 4180.
QStringList cellsOf(const QString& line)
{
    QStringList cells(1);
    bool quoted = false;
    for (qsizetype i = 0; i < line.size(); ++i) {
        const QChar c = line[i];
        if (quoted && c == QLatin1Char('"') && i + 1 < line.size()
            && line[i + 1] == QLatin1Char('"'))
            cells.back() += line[++i];
        else if (c == QLatin1Char('"'))
            quoted = !quoted;
        else if (c == QLatin1Char(',') && !quoted)
            cells += QString();
        else
            cells.back() += c;
    }
    return cells;
}

/// What a text file says of a segment.
struct SegmentNumbers {
    int label = 0;
    QString name;
    Numbers numbers;
};

/// Without the apostrophe that keeps a spreadsheet from taking a text for a formula.
QString withoutApostrophe(const QString& cell)
{
    static const QRegularExpression kept(QStringLiteral("^'+[-=+@]"));
    return kept.match(cell).hasMatch() ? cell.mid(1) : cell;
}

std::vector<SegmentNumbers> saidInCsv(const QByteArray& text)
{
    QStringList lines = QString::fromUtf8(text).split(QStringLiteral("\r\n"), Qt::SkipEmptyParts);
    if (lines.isEmpty())
        return {};
    const QStringList names = cellsOf(lines.takeFirst());
    std::vector<SegmentNumbers> all;
    for (const QString& line : lines) {
        const QStringList cells = cellsOf(line);
        if (cells.size() != names.size())
            return {};
        SegmentNumbers said{
            .label = cells[0].toInt(), .name = withoutApostrophe(cells[1]), .numbers = {}};
        for (qsizetype i = 0; i < cells.size(); ++i) {
            bool isNumber = false;
            const double number = cells[i].toDouble(&isNumber);
            if (isNumber)
                said.numbers[names[i]] = number;
        }
        all.push_back(said);
    }
    return all;
}

std::vector<SegmentNumbers> saidInJson(const QByteArray& text)
{
    std::vector<SegmentNumbers> all;
    const QJsonArray segments =
        QJsonDocument::fromJson(text).object()[QLatin1String("segments")].toArray();
    for (const QJsonValue& value : segments) {
        const QJsonObject entry = value.toObject();
        SegmentNumbers said{.label = entry[QLatin1String("label")].toInt(),
            .name = entry[QLatin1String("name")].toString(),
            .numbers = {}};
        for (auto field = entry.constBegin(); field != entry.constEnd(); ++field) {
            if (field->isDouble())
                said.numbers[field.key()] = field->toDouble();
        }
        all.push_back(said);
    }
    return all;
}

bool agree(double a, double b, double tolerance)
{
    return std::abs(a - b) <= tolerance * std::max({1.0, std::abs(a), std::abs(b)});
}

/// @return what differs; empty if nothing does
Clause differenceOf(const SegmentNumbers& said, const Numbers& right, double tolerance)
{
    for (const auto& [name, number] : right) {
        const auto found = said.numbers.find(name);
        if (found == said.numbers.end())
            return Clause::saying("%1 of '%2' is missing", name, said.name);
        if (!agree(found->second, number, tolerance))
            return Clause::saying(
                "%1 of '%2' is %3 instead of %4", name, said.name, found->second, number);
    }
    return {};
}

/// The surface is not measured anew; of its diameters, none across is longer than the longest.
/// @return what is wrong; empty if nothing is
Clause differenceOfDiameters(const SegmentNumbers& said)
{
    const auto numberOf = [&said](const char* name) {
        const auto found = said.numbers.find(QLatin1String(name));
        return found == said.numbers.end() ? 0.0 : found->second;
    };
    const double longest = numberOf("longestDiameterMm");
    const double across = numberOf("acrossDiameterMm");
    return across > 0.0 && across <= longest * (1.0 + reportTolerance)
        ? Clause()
        : Clause::saying("diameters of '%1'", said.name);
}

/// What measurements of the document come to, by the codes of a report. Arrows and texts come to
/// nothing.
std::vector<std::map<QString, double>> measuredAnew(const ExportExpectation& expected)
{
    std::vector<std::map<QString, double>> all;
    for (const Measurement& measurement : expected.measurements) {
        if (measurement.kind == Measurement::Kind::Arrow
            || measurement.kind == Measurement::Kind::Text)
            continue;
        const MeasuredSize size = measuredSize(measurement, expected.volume);
        std::map<QString, double> numbers;
        const auto expect = [&numbers](const char* code, const std::optional<double>& value) {
            if (value)
                numbers[QLatin1String(code)] = *value;
        };
        expect("410668003", size.length);
        expect("1483009", size.angleDegrees);
        expect("42798000", size.area);
        expect(size.shortAxis ? "103339001" : "81827009", size.longAxis);
        expect("103340004", size.shortAxis);
        if (size.volume)
            expect("118565006", size.inVoxels ? *size.volume : *size.volume / 1000.0);
        const auto values = regionStatistics(measurement, expected.volume, expected.codes);
        if (values && measurement.isRegion()) {
            expect("373098007", values->mean);
            expect("386136009", values->deviation);
            expect("255605001", values->minimum);
            expect("56851009", values->maximum);
        }
        all.push_back(std::move(numbers));
    }
    return all;
}

/// @return what differs in the groups behind those of the segments; empty if nothing does
Clause differenceOfMeasured(const SrFile& report, const ExportExpectation& expected)
{
    const std::vector<std::map<QString, double>> right = measuredAnew(expected);
    if (report.groups.size() != expected.segments.size() + right.size())
        return Clause::saying("the number of measurement groups");
    for (std::size_t i = 0; i < right.size(); ++i) {
        const SrFileGroup& group = report.groups[expected.segments.size() + i];
        for (const auto& [code, number] : right[i]) {
            const auto found = group.numbers.find(code);
            if (found == group.numbers.end() || !agree(found->second, number, reportTolerance))
                return Clause::saying("%1 of '%2'", code, group.name);
        }
    }
    return {};
}

Result<std::vector<SegmentNumbers>> saidInReport(
    const QString& file, const ExportExpectation& expected, const Progress& progress)
{
    const auto mismatch = [&](const Clause& what) {
        return failure(ErrorCode::ExportMismatch, file, what);
    };
    const auto headers = checkedSourceHeaders(file, expected, progress);
    if (!headers)
        return tl::unexpected(headers.error());
    const auto report = readSr(file);
    if (!report)
        return tl::unexpected(report.error());
    if (const Clause what = differenceFromSource(report->patient, headers->front().patient);
        !what.isEmpty())
        return mismatch(what);
    if (report->studyUid != headers->front().studyUid)
        return mismatch(QStringLiteral("study"));
    for (const SourceHeader& header : *headers) {
        if (!report->evidence.contains(header.sopInstanceUid))
            return mismatch(Clause::saying("a source image is not among the evidence"));
    }
    std::vector<SegmentNumbers> all;
    for (std::size_t i = 0; i < report->groups.size() && i < expected.segments.size(); ++i) {
        const SrFileGroup& group = report->groups[i];
        if (group.segmentNumber != int(i) + 1 || !report->evidence.contains(group.segUid)
            || group.sourceSeriesUid != headers->front().seriesUid)
            return mismatch(Clause::saying("what measurement group %1 refers to", i + 1));
        SegmentNumbers said{.label = expected.segments[i].label, .name = group.name, .numbers = {}};
        const std::map<QString, QString> names{
            {QStringLiteral("118565006"), QStringLiteral("volumeMl")},
            {QStringLiteral("L0JK"), QStringLiteral("longestDiameterMm")},
            {QStringLiteral("103340004"), QStringLiteral("acrossDiameterMm")},
            {QStringLiteral("373098007"), QStringLiteral("mean")},
            {QStringLiteral("386136009"), QStringLiteral("standardDeviation")},
            {QStringLiteral("255605001"), QStringLiteral("minimum")},
            {QStringLiteral("56851009"), QStringLiteral("maximum")},
            {QStringLiteral("373099004"), QStringLiteral("median")},
            {QStringLiteral("IMPORT-ADDED"), QStringLiteral("importAddedMl")},
            {QStringLiteral("IMPORT-TAKEN"), QStringLiteral("importTakenMl")},
            {QStringLiteral("IMPORT-DICE"), QStringLiteral("importDice")}};
        for (const auto& [code, number] : group.numbers) {
            const auto name = names.find(code);
            if (name != names.end())
                said.numbers[name->second] = number;
        }
        all.push_back(said);
    }
    if (const Clause what = differenceOfMeasured(*report, expected); !what.isEmpty())
        return mismatch(what);
    return all;
}

} // namespace

Result<ReportLines> checkStatisticsExport(
    const QString& file, const ExportExpectation& expected, const Progress& progress)
{
    const auto mismatch = [&](const Clause& what) {
        return failure(ErrorCode::ExportMismatch, file, what);
    };
    const bool isReport = expected.format == ExportFormat::Sr;
    std::vector<SegmentNumbers> all;
    if (isReport) {
        auto said = saidInReport(file, expected, progress);
        if (!said)
            return tl::unexpected(said.error());
        all = *std::move(said);
    } else {
        if (!expected.volume.sources.empty()) {
            if (const auto headers = checkedSourceHeaders(file, expected, progress); !headers)
                return tl::unexpected(headers.error());
        }
        QFile in(file);
        if (!in.open(QIODevice::ReadOnly))
            return failure(ErrorCode::FileUnreadable, file, in.errorString());
        const QByteArray text = in.readAll();
        all = expected.format == ExportFormat::Csv ? saidInCsv(text) : saidInJson(text);
    }
    if (all.size() != expected.segments.size())
        return mismatch(Clause::saying("the number of segments"));
    const bool isInVoxels = unknownSpacing(expected.volume) != UnknownSpacing::Nothing;
    std::size_t numbers = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Segment& segment = expected.segments[i];
        if (all[i].label != segment.label || (!isReport && all[i].name != segment.name))
            return mismatch(Clause::saying("name or label of segment %1", i + 1));
        Numbers right = countedAnew(expected, segment);
        if (isInVoxels) {
            for (const char* name : {"volumeMl", "importAddedMl", "importTakenMl"})
                right.erase(QString::fromLatin1(name));
            // They would be sizes that nobody measured.
            for (const char* name : {"volumeMl", "surfaceMm2", "sphericity", "longestDiameterMm",
                     "acrossDiameterMm", "importAddedMl", "importTakenMl"}) {
                if (!isReport && all[i].numbers.contains(QLatin1String(name)))
                    return mismatch(Clause::saying("%1 of segment %2, although the source does not "
                                                   "state the spacing",
                        QLatin1String(name), i + 1));
            }
            // A report has them as the segment's volume.
            if (isReport)
                right[QStringLiteral("volumeMl")] = right[QStringLiteral("voxels")];
        }
        if (isReport) {
            std::erase_if(right, [](const auto& each) {
                static const QStringList kept{QStringLiteral("volumeMl"), QStringLiteral("mean"),
                    QStringLiteral("standardDeviation"), QStringLiteral("minimum"),
                    QStringLiteral("maximum"), QStringLiteral("median"),
                    QStringLiteral("importAddedMl"), QStringLiteral("importTakenMl"),
                    QStringLiteral("importDice")};
                return !kept.contains(each.first);
            });
        }
        const Clause what =
            differenceOf(all[i], right, isReport ? reportTolerance : relativeTolerance);
        if (!what.isEmpty())
            return mismatch(what);
        if (const Clause wrong = isInVoxels ? Clause() : differenceOfDiameters(all[i]);
            !wrong.isEmpty())
            return mismatch(wrong);
        numbers += right.size();
    }
    return ReportLines{ReportSentence{ReportCode::NumbersEqual,
        {countedInReport(ReportCode::Numbers, std::int64_t(numbers)),
            countedInReport(ReportCode::Segments, std::int64_t(all.size()))}}};
}

} // namespace core
