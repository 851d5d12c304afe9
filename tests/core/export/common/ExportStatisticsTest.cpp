// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/objects/SrReader.h"
#include "core/export/common/CheckExport.h"
#include "core/export/common/SegmentStatistics.h"
#include "core/study/StudyLoader.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SyntheticSeries.h"
#include "tests/support/servers/Python.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace exportStatisticsTest {

using namespace core;

namespace {

Segment segmentOf(int label, const char* name)
{
    Segment segment;
    segment.label = std::uint8_t(label);
    segment.name = QString::fromUtf8(name);
    segment.code = {.scheme = QStringLiteral("SCT"),
        .value = QStringLiteral("10200004"),
        .meaning = QStringLiteral("Liver")};
    return segment;
}

QString messageOf(const Error& error)
{
    return error.arguments.join(QStringLiteral(" | "));
}

struct Measured {
    QTemporaryDir folder;
    LoadedVolume study;
    std::vector<std::uint8_t> labels;
    std::vector<LabelPlaneView> planes;

    explicit Measured(const test::SyntheticSeries& series)
    {
        test::writeSeries(series, folder.filePath(QStringLiteral("study")));
        Result<LoadedVolume> loaded = loadVolume(folder.filePath(QStringLiteral("study")));
        if (!loaded)
            qFatal("%s", qPrintable(messageOf(loaded.error())));
        study = *std::move(loaded);
        labels.assign(study.codes.size(), 0);
        planes = {{.plane = 0, .labels = labels}};
    }
    std::uint8_t& at(int x, int y, int z)
    {
        const glm::ivec3 size = study.volume.geometry.size;
        return labels[(std::size_t(z) * std::size_t(size.y) + std::size_t(y)) * std::size_t(size.x)
            + std::size_t(x)];
    }
    [[nodiscard]] QString file(const char* name) const
    {
        return folder.filePath(QLatin1String(name));
    }
    [[nodiscard]] ExportRequest request(ExportFormat format, const char* name) const
    {
        return {.format = format,
            .file = file(name),
            .segments = {segmentOf(1, "Leber, \"rechts\""), segmentOf(2, "Rest")},
            .planes = planes,
            .codes = study.codes};
    }
    [[nodiscard]] std::vector<SegmentStatistics> statistics() const
    {
        const ExportRequest what = request(ExportFormat::Csv, "a.csv");
        const auto selection = selectMask(study.volume, what);
        const auto all = segmentStatistics(study.volume, what, *selection, {});
        return *all;
    }
};

/// Values 0, 1, 2 … along x, ten more a slice.
test::SyntheticSeries ramp()
{
    test::SyntheticSeries series;
    series.stored = [](const glm::ivec3& index) { return 1000 + index.x + 10 * index.z; };
    return series;
}

} // namespace

/// Numbers about segments: counted right, and written so that others read the same.
class ExportStatisticsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void aBlockByHand();
    void unevenSlicesCountByTheirRoom();
    void surfaceOfBalls();
    void aRodIsLongAndNoBall();
    void othersReadTheSame();
    void whatWasChangedSinceTheImport();
    void theReportTellsOfTheImport();
    void report();
    void aReportAndItsSegComeAndGoTogether();
    void aNumberThatIsWrongIsFound();
    void aDiameterAcrossThatIsTooLongIsFound();
    void withoutValuesNothingIsWritten();
};

/// Four voxels, all numbers worked out on paper.
void ExportStatisticsTest::aBlockByHand()
{
    Measured on(ramp());
    on.at(3, 2, 1) = on.at(4, 2, 1) = on.at(5, 2, 1) = on.at(5, 2, 2) = 1;
    on.at(0, 0, 0) = 2;
    const SegmentStatistics found = on.statistics().front();
    // Spacing 0.75 x 1.25 x 2.5; -24 + x + 10 z.
    QCOMPARE(found.voxels, std::int64_t(4));
    QCOMPARE(found.millilitres, 4 * 0.75 * 1.25 * 2.5 / 1000.0);
    QCOMPARE(found.minimum, -11.0);
    QCOMPARE(found.maximum, 1.0);
    QCOMPARE(found.mean, (-11.0 - 10.0 - 9.0 + 1.0) / 4);
    QCOMPARE(found.median, -10.0);
    QCOMPARE(found.percentiles[0], -11.0);
    QCOMPARE(found.percentiles[3], -9.0); // 75 %
    QCOMPARE(found.percentiles[5], 1.0);
    QVERIFY(std::abs(found.deviation - std::sqrt(23.1875)) < 1e-12);
    QCOMPARE(found.first, glm::ivec3(3, 2, 1));
    QCOMPARE(found.last, glm::ivec3(5, 2, 2));
    const glm::dvec3 origin(-9.0, -11.25, 40.0);
    QVERIFY(glm::distance(found.centroidLps, origin + glm::dvec3(0.75 * 17 / 4, 2.5, 2.5 * 5 / 4.0))
        < 1e-9);
    QVERIFY(glm::distance(found.lowestLps, origin + glm::dvec3(2.25, 2.5, 2.5)) < 1e-9);
    QVERIFY(glm::distance(found.highestLps, origin + glm::dvec3(3.75, 2.5, 5.0)) < 1e-9);
}

void ExportStatisticsTest::unevenSlicesCountByTheirRoom()
{
    test::SyntheticSeries series = ramp();
    series.size.z = 4;
    for (const double z : {0.0, 2.0, 3.0, 7.0})
        series.positions.emplace_back(-9.0, -11.25, z);
    Measured on(series);
    QVERIFY(!on.study.volume.geometry.slicePositions.empty());
    on.at(1, 1, 2) = 1;
    on.at(1, 1, 3) = 2;
    const auto all = on.statistics();
    QCOMPARE(all[0].millilitres, 0.75 * 1.25 * 2.5 / 1000.0);
    QCOMPARE(all[1].millilitres, 0.75 * 1.25 * 4.0 / 1000.0);
    QVERIFY(std::abs(all[1].centroidLps.z - 7.0) < 1e-9);
}

/// The smoothed surface is honest: within 4 % of what a ball has, where its steps alone would have
/// half as much again.
void ExportStatisticsTest::surfaceOfBalls()
{
    test::SyntheticSeries series;
    series.size = {48, 48, 48};
    series.spacing = {1.0, 1.0};
    series.step = {0, 0, 1.0};
    Measured on(series);
    for (const double radius : {6.0, 10.0, 20.0}) {
        std::fill(on.labels.begin(), on.labels.end(), std::uint8_t(0));
        for (int z = 0; z < 48; ++z)
            for (int y = 0; y < 48; ++y)
                for (int x = 0; x < 48; ++x)
                    on.at(x, y, z) =
                        glm::length(glm::dvec3(x - 23.6, y - 23.2, z - 23.9)) <= radius ? 1 : 2;
        const SegmentStatistics ball = on.statistics().front();
        const double right = 4.0 * std::numbers::pi * radius * radius;
        qInfo("ball of %g mm: %.1f mm2 of %.1f", radius, ball.surfaceMm2, right);
        QVERIFY(std::abs(ball.surfaceMm2 - right) < 0.04 * right);
        QVERIFY(ball.sphericity > 0.95 && ball.sphericity < 1.0);
        QVERIFY(std::abs(ball.longestMm - 2.0 * radius) < 1.0);
        QVERIFY(std::abs(ball.acrossMm - 2.0 * radius) < 1.0 && ball.acrossMm <= ball.longestMm);
        // Around the ball: more surface, and as long as the whole volume's diagonal.
        const SegmentStatistics rest = on.statistics().back();
        QVERIFY(rest.sphericity > 0.0 && rest.sphericity < ball.sphericity);
        QVERIFY(std::abs(rest.longestMm - 48.0 * std::sqrt(3.0)) < 1.8);
    }
}

/// In millimetres, though slices are farther apart than voxels of a row are.
void ExportStatisticsTest::aRodIsLongAndNoBall()
{
    test::SyntheticSeries series = ramp();
    series.size = {20, 20, 20};
    series.spacing = {1.0, 1.0};
    series.step = {0, 0, 3.0};
    Measured on(series);
    for (int i = 2; i < 18; ++i)
        on.at(3, 3, i) = on.at(i, 10, 10) = 1;
    // Two rods of one segment: one of 16 slices, one of 16 columns, far apart.
    on.at(0, 0, 0) = 2;
    const SegmentStatistics rods = on.statistics().front();
    // From an end of the rod along z (3, 3, 1.5 … 17.5) to the far end of the other's (17.5, 10,
    // 10) is 14.5, 7 and 25.5 mm or less; the rod along z itself is 48 mm long.
    QVERIFY(std::abs(rods.longestMm - 48.0) < 3.0);
    // Perpendicular to it only the other rod is long.
    QVERIFY2(std::abs(rods.acrossMm - 16.0) < 1.0, qPrintable(QString::number(rods.acrossMm)));
    QVERIFY2(rods.sphericity > 0.2 && rods.sphericity < 0.4,
        qPrintable(QString::number(rods.sphericity)));
}

void ExportStatisticsTest::othersReadTheSame()
{
    Measured on(ramp());
    for (int i = 0; i < 7; ++i)
        on.at(i, i % 3, 2 + i % 4) = std::uint8_t(1 + i % 2);
    const auto csv = exportMask(on.study.volume, on.request(ExportFormat::Csv, "a.csv"), {});
    QVERIFY2(csv, qPrintable(csv ? QString() : messageOf(csv.error())));
    const auto json = exportMask(on.study.volume, on.request(ExportFormat::Json, "a.json"), {});
    QVERIFY2(json, qPrintable(json ? QString() : messageOf(json.error())));
    QVERIFY(csv->sha256.size() == 64 && !csv->checked.isEmpty());

    QFile file(on.file("a.json"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QJsonObject said = QJsonDocument::fromJson(file.readAll()).object();
    QCOMPARE(said["unit"].toString(), QStringLiteral("HU"));
    QCOMPARE(said["study"]["seriesUid"].toString(), on.study.volume.identity.seriesUid);
    // Python's reader of CSV, as of JSON.
    const auto read = test::runScript(QStringLiteral("csv_rows.py"), {on.file("a.csv")});
    QVERIFY2(read.exitCode == 0, qPrintable(read.errors));
    const QJsonArray rows = QJsonDocument::fromJson(read.output).array();
    QCOMPARE(rows.size(), 2);
    for (int i = 0; i < 2; ++i) {
        const QJsonObject segment = said["segments"].toArray()[i].toObject();
        QCOMPARE(rows[i]["name"].toString(), segment["name"].toString());
        QCOMPARE(rows[i]["meaning"].toString(), QStringLiteral("Liver"));
        int numbers = 0;
        for (auto field = segment.constBegin(); field != segment.constEnd(); ++field) {
            if (!field->isDouble())
                continue;
            QCOMPARE(rows[i][field.key()].toString().toDouble(), field->toDouble());
            ++numbers;
        }
        QCOMPARE(numbers, 33);
    }
}

/// Of four voxels two were imported, of three.
void ExportStatisticsTest::whatWasChangedSinceTheImport()
{
    Measured on(ramp());
    on.at(1, 1, 1) = on.at(2, 1, 1) = on.at(3, 1, 1) = on.at(4, 1, 1) = 1;
    on.at(0, 0, 0) = 2;
    const glm::ivec3 size = on.study.volume.geometry.size;
    VoxelRuns network;
    network.append(std::uint64_t((size.y + 1) * size.x + 3), 3);
    ExportRequest request = on.request(ExportFormat::Csv, "a.csv");
    request.imported = {{.label = 1, .voxels = network}};
    const auto selection = selectMask(on.study.volume, request);
    const auto all = segmentStatistics(on.study.volume, request, *selection, {});
    QVERIFY(all.has_value());
    QVERIFY(all->front().sinceImport && !all->back().sinceImport);
    const double voxelMl = 0.75 * 1.25 * 2.5 / 1000.0;
    QCOMPARE(all->front().sinceImport->addedMl, 2 * voxelMl);
    QCOMPARE(all->front().sinceImport->takenMl, voxelMl);
    QCOMPARE(all->front().sinceImport->dice, 4.0 / 7.0);

    const auto made = exportMask(on.study.volume, request, {});
    QVERIFY2(made, qPrintable(made ? QString() : messageOf(made.error())));
    QCOMPARE(std::count_if(made->written.begin(), made->written.end(),
                 [](const ReportLine& line) {
                     const auto* sentence = std::get_if<ReportSentence>(&line);
                     return sentence && sentence->code == ReportCode::SinceImport;
                 }),
        std::ptrdiff_t(1));
    const QList<QByteArray> lines = test::bytesOf(on.file("a.csv")).split('\n');
    QVERIFY(lines[0].endsWith(",importAddedMl,importTakenMl,importDice\r"));
    QVERIFY(lines[1].contains(QByteArray::number(2 * voxelMl) + ','));
    // The other segment was not imported.
    QVERIFY(lines[2].endsWith(",,,\r"));
    QCOMPARE(lines[2].count(','), lines[0].count(','));

    request.format = ExportFormat::Json;
    request.file = on.file("a.json");
    QVERIFY(exportMask(on.study.volume, request, {}));
    const QJsonArray said =
        QJsonDocument::fromJson(test::bytesOf(request.file)).object()["segments"].toArray();
    QCOMPARE(said[0]["importDice"].toDouble(), 4.0 / 7.0);
    QVERIFY(said[1]["importDice"].isUndefined());
    // Another import is not what the file tells of.
    ExportExpectation expected{.volume = on.study.volume,
        .segments = selection->segments,
        .planes = request.planes,
        .format = request.format,
        .codes = request.codes,
        .imported = request.imported};
    QVERIFY(checkStatisticsExport(request.file, expected, {}));
    network.append(std::uint64_t((size.y + 1) * size.x + 7), 1);
    const std::vector<ImportedVoxels> other{{.label = 1, .voxels = network}};
    expected.imported = other;
    const auto checked = checkStatisticsExport(request.file, expected, {});
    QVERIFY(!checked);
    QCOMPARE(checked.error().code, ErrorCode::ExportMismatch);
}

/// Of three voxels the import had, two remain, and two others are new. The report holds the numbers
/// with their concepts, for the imported segment alone, and the check finds a wrong one.
void ExportStatisticsTest::theReportTellsOfTheImport()
{
    Measured on(ramp());
    on.at(1, 1, 1) = on.at(2, 1, 1) = on.at(3, 1, 1) = on.at(4, 1, 1) = 1;
    on.at(0, 0, 0) = 2;
    const glm::ivec3 size = on.study.volume.geometry.size;
    VoxelRuns network;
    network.append(std::uint64_t((size.y + 1) * size.x + 3), 3);
    ExportRequest request = on.request(ExportFormat::Sr, "a.dcm");
    request.imported = {{.label = 1, .voxels = network}};
    const auto made = exportMask(on.study.volume, request, {});
    QVERIFY2(made, qPrintable(made ? QString() : messageOf(made.error())));

    const auto read = readSr(on.file("a.dcm"));
    QVERIFY(read.has_value());
    QCOMPARE(read->groups.size(), std::size_t(2));
    const auto& numbers = read->groups[0].numbers;
    for (const char* code : {"IMPORT-ADDED", "IMPORT-TAKEN", "IMPORT-DICE"}) {
        QVERIFY2(numbers.contains(QLatin1String(code)), code);
        QVERIFY2(!read->groups[1].numbers.contains(QLatin1String(code)), code);
    }
    const double voxelMl = 0.75 * 1.25 * 2.5 / 1000.0;
    QVERIFY(std::abs(numbers.at(QStringLiteral("IMPORT-ADDED")) - 2 * voxelMl) < 1e-12);
    QVERIFY(std::abs(numbers.at(QStringLiteral("IMPORT-TAKEN")) - voxelMl) < 1e-12);
    QVERIFY(std::abs(numbers.at(QStringLiteral("IMPORT-DICE")) - 4.0 / 7.0) < 1e-8);

    const auto valid = test::runProgram(QStringLiteral("dciodvfy"), {on.file("a.dcm")});
    QVERIFY2(valid.exitCode == 0 && !valid.output.contains("Error"), valid.output.constData());
    const auto dumped = test::runProgram(QStringLiteral("dsrdump"), {on.file("a.dcm")});
    QVERIFY2(dumped.exitCode == 0, dumped.output.constData());
    QCOMPARE(dumped.output.count("Volume added since import"), qsizetype(1));
    QCOMPARE(dumped.output.count("Dice coefficient with the imported segment"), qsizetype(1));

    // Another import is not what the report tells of, and one of which it does not tell is missed.
    ExportExpectation expected{.volume = on.study.volume,
        .segments = request.segments,
        .planes = request.planes,
        .format = request.format,
        .codes = request.codes,
        .imported = request.imported};
    QVERIFY(checkStatisticsExport(request.file, expected, {}));
    network.append(std::uint64_t((size.y + 1) * size.x + 7), 1);
    const std::vector<ImportedVoxels> other{{.label = 1, .voxels = network}};
    expected.imported = other;
    const auto checked = checkStatisticsExport(request.file, expected, {});
    QVERIFY(!checked);
    QCOMPARE(checked.error().code, ErrorCode::ExportMismatch);
    const std::vector<ImportedVoxels> second{{.label = 2, .voxels = network}};
    expected.imported = second;
    QVERIFY(!checkStatisticsExport(request.file, expected, {}));
}

void ExportStatisticsTest::report()
{
    Measured on(ramp());
    for (int i = 0; i < 9; ++i)
        on.at(i, i % 5, 1 + i % 4) = std::uint8_t(1 + i % 2);
    const auto made = exportMask(on.study.volume, on.request(ExportFormat::Sr, "a.dcm"), {});
    QVERIFY2(made, qPrintable(made ? QString() : messageOf(made.error())));
    QVERIFY(QFile::exists(on.file("a-seg.dcm")));
    const auto valid = test::runProgram(QStringLiteral("dciodvfy"), {on.file("a.dcm")});
    QVERIFY2(valid.exitCode == 0 && !valid.output.contains("Error"), valid.output.constData());
    const auto read = readSr(on.file("a.dcm"));
    QVERIFY(read.has_value());
    const std::vector<SegmentStatistics> all = on.statistics();
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto& numbers = read->groups.at(i).numbers;
        QVERIFY(std::abs(numbers.at(QStringLiteral("QCFX")) - all[i].sphericity) < 1e-8);
        QVERIFY(std::abs(numbers.at(QStringLiteral("L0JK")) - all[i].longestMm) < 1e-6);
        QVERIFY(numbers.at(QStringLiteral("L0JK")) > 0.0);
        QVERIFY(std::abs(numbers.at(QStringLiteral("103340004")) - all[i].acrossMm) < 1e-6);
        QVERIFY(numbers.at(QStringLiteral("103340004")) > 0.0);
    }
    // DCMTK's reader of reports knows the rules of their trees.
    const auto dumped = test::runProgram(QStringLiteral("dsrdump"), {on.file("a.dcm")});
    QVERIFY2(dumped.exitCode == 0, dumped.output.constData());
    const SegmentStatistics first = on.statistics().front();
    for (const QByteArray& text :
        {QByteArray("Imaging Measurement Report"), QByteArray("Referenced Segment"),
            QByteArray("Liver"), QByteArray("\"Leber, \\\"rechts\\\"\""),
            QByteArray::number(first.mean, 'g', 12).left(6), QByteArray("Hounsfield unit"),
            QByteArray("Sphericity"), QByteArray("Maximum 3D Diameter of a Mesh"),
            QByteArray("Short Axis")})
        QVERIFY2(dumped.output.contains(text) || text.startsWith("\"Leber"),
            (text + " in\n" + dumped.output).constData());
}

/// What lies where the SEG of a report would go is a file of somebody's like any other.
void ExportStatisticsTest::aReportAndItsSegComeAndGoTogether()
{
    Measured on(ramp());
    on.at(1, 1, 1) = 1;
    on.at(3, 1, 1) = 2;
    // A slice of the study of that name.
    const QString slice = on.study.volume.sources.front().file;
    const QString named = QFileInfo(slice).dir().filePath(QStringLiteral("IM1-seg.dcm"));
    QVERIFY(QFile::rename(slice, named));
    on.study.volume.sources.front().file = named;
    const QByteArray bytes = test::bytesOf(named);
    ExportRequest request = on.request(ExportFormat::Sr, "a.dcm");
    request.file = QFileInfo(slice).dir().filePath(QStringLiteral("IM1.dcm"));
    for (const bool force : {false, true}) {
        request.force = force;
        QVERIFY(!exportMask(on.study.volume, request, {}));
        QCOMPARE(test::bytesOf(named), bytes);
        QVERIFY(!QFile::exists(request.file));
    }
    // Called off, or with a report that cannot take its name, both old files are as they were.
    request = on.request(ExportFormat::Sr, "b.dcm");
    QVERIFY(exportMask(on.study.volume, request, {}));
    const QByteArray report = test::bytesOf(on.file("b.dcm"));
    const QByteArray seg = test::bytesOf(on.file("b-seg.dcm"));
    request.force = true;
    Progress cancelled;
    cancelled.cancel();
    QVERIFY(!exportMask(on.study.volume, request, cancelled));
    QCOMPARE(test::bytesOf(on.file("b.dcm")), report);
    QCOMPARE(test::bytesOf(on.file("b-seg.dcm")), seg);
    QVERIFY(QFile::remove(on.file("b.dcm")));
    QVERIFY(QDir(on.folder.path()).mkdir(QStringLiteral("b.dcm")));
    QVERIFY(!exportMask(on.study.volume, request, {}));
    QCOMPARE(test::bytesOf(on.file("b-seg.dcm")), seg);
    QVERIFY(QDir(on.folder.path()).rmdir(QStringLiteral("b.dcm")));
    QVERIFY(exportMask(on.study.volume, request, {}));
    QVERIFY(test::bytesOf(on.file("b-seg.dcm")) != seg);
}

void ExportStatisticsTest::aNumberThatIsWrongIsFound()
{
    Measured on(ramp());
    on.at(1, 1, 1) = on.at(2, 1, 1) = 1;
    on.at(3, 1, 1) = 2;
    for (const ExportFormat format : {ExportFormat::Csv, ExportFormat::Json, ExportFormat::Sr}) {
        ExportRequest request = on.request(format, "b.dcm");
        request.file = on.file(format == ExportFormat::Csv ? "b.csv"
                : format == ExportFormat::Json             ? "b.json"
                                                           : "b.dcm");
        QVERIFY(exportMask(on.study.volume, request, {}));
        ExportExpectation expected{.volume = on.study.volume,
            .segments = request.segments,
            .planes = request.planes,
            .format = format,
            .codes = request.codes};
        QVERIFY(checkStatisticsExport(request.file, expected, {}));
        std::vector<std::uint16_t> others = on.study.codes;
        for (std::size_t i = 0; i < others.size(); ++i) {
            if (on.labels[i] == 1)
                ++others[i];
        }
        expected.codes = others;
        const auto checked = checkStatisticsExport(request.file, expected, {});
        QVERIFY(!checked);
        QCOMPARE(checked.error().code, ErrorCode::ExportMismatch);
    }
}

void ExportStatisticsTest::aDiameterAcrossThatIsTooLongIsFound()
{
    Measured on(ramp());
    on.at(1, 1, 1) = on.at(2, 1, 1) = 1;
    on.at(3, 1, 1) = 2;
    const ExportRequest request = on.request(ExportFormat::Csv, "b.csv");
    QVERIFY(exportMask(on.study.volume, request, {}));
    const ExportExpectation expected{.volume = on.study.volume,
        .segments = request.segments,
        .planes = request.planes,
        .format = request.format,
        .codes = request.codes};
    QVERIFY(checkStatisticsExport(request.file, expected, {}));
    QByteArray text = test::bytesOf(request.file);
    text.replace("longestDiameterMm,acrossDiameterMm", "acrossDiameterMm,longestDiameterMm");
    QFile file(request.file);
    QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
    QCOMPARE(file.write(text), text.size());
    file.close();
    const auto checked = checkStatisticsExport(request.file, expected, {});
    QVERIFY(!checked);
    QCOMPARE(checked.error().code, ErrorCode::ExportMismatch);
}

void ExportStatisticsTest::withoutValuesNothingIsWritten()
{
    Measured on(ramp());
    on.at(1, 1, 1) = 1;
    ExportRequest request = on.request(ExportFormat::Csv, "c.csv");
    request.codes = {};
    const auto made = exportMask(on.study.volume, request, {});
    QVERIFY(!made);
    QCOMPARE(made.error().code, ErrorCode::UnsupportedFormat);
    QVERIFY(!QFile::exists(request.file));
}

BURIN_TEST(ExportStatisticsTest)

} // namespace exportStatisticsTest

#include "ExportStatisticsTest.moc"
