// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/objects/SrReader.h"
#include "core/export/MeasurementsCsv.h"
#include "core/export/common/CheckExport.h"
#include "core/export/common/ExportMask.h"
#include "core/study/StudyLoader.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SyntheticSeries.h"
#include "tests/support/servers/Python.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace exportMeasurementsTest {

using namespace core;
using Kind = Measurement::Kind;

namespace {

struct Study {
    QTemporaryDir folder;
    LoadedVolume loaded;
    std::vector<std::uint8_t> labels;
    std::vector<LabelPlaneView> planes;

    /// Values −24, −23 … along x, ten more a slice: pixels of 0.75 × 1.25 mm, slices 2.5 mm apart.
    Study()
    {
        test::SyntheticSeries series;
        series.stored = [](const glm::ivec3& index) { return 1000 + index.x + 10 * index.z; };
        test::writeSeries(series, folder.filePath(QStringLiteral("study")));
        Result<LoadedVolume> read = loadVolume(folder.filePath(QStringLiteral("study")));
        if (!read)
            qFatal("%s", qPrintable(read.error().arguments.join(u' ')));
        loaded = *std::move(read);
        labels.assign(loaded.codes.size(), 0);
        labels[100] = labels[101] = 1;
        planes = {{.plane = 0, .labels = labels}};
    }
    [[nodiscard]] const Volume& volume() const { return loaded.volume; }
    [[nodiscard]] glm::dvec3 at(double x, double y, double z) const
    {
        return volume().geometry.toWorld({x, y, z});
    }
    /// One of each kind, in the middle of the volume.
    [[nodiscard]] std::vector<Measurement> measurements() const
    {
        const glm::dvec3 centre = at(12, 9, 5);
        const auto of = [](int id, Kind kind, const std::vector<glm::dvec3>& points) {
            return Measurement{.id = id, .kind = kind, .pointsLps = points};
        };
        std::vector<Measurement> all{of(1, Kind::Distance, {centre, centre + glm::dvec3(3, 4, 0)}),
            of(2, Kind::Angle,
                {centre + glm::dvec3(5, 0, 0), centre, centre + glm::dvec3(0, 0, 6)}),
            of(3, Kind::Ellipse,
                {centre, centre + glm::dvec3(3, 0, 0), centre + glm::dvec3(0, 5, 0)}),
            of(4, Kind::Rectangle,
                {centre, centre + glm::dvec3(3, 0, 0), centre + glm::dvec3(0, 5, 0)}),
            of(5, Kind::Outline,
                {centre, centre + glm::dvec3(3, 0, 0), centre + glm::dvec3(3, 5, 0)}),
            of(6, Kind::Ball, {centre, centre + glm::dvec3(0, 0, 4)}), of(7, Kind::Probe, {centre}),
            of(8, Kind::Arrow, {centre, centre + glm::dvec3(9, 9, 0)}),
            of(9, Kind::Text, {centre})};
        all[0].projected = true;
        all[7].text = QStringLiteral("Here, \"there\"");
        all[8].text = QStringLiteral("Fissure");
        return all;
    }
    [[nodiscard]] ExportRequest report(const QString& file) const
    {
        Segment segment;
        segment.label = 1;
        segment.name = QStringLiteral("Liver");
        segment.code = {.scheme = QStringLiteral("SCT"),
            .value = QStringLiteral("10200004"),
            .meaning = QStringLiteral("Liver")};
        return {.format = ExportFormat::Sr,
            .file = file,
            .segments = {segment},
            .planes = planes,
            .codes = loaded.codes,
            .measurements = measurements()};
    }
};

bool isNear(const std::map<QString, double>& numbers, const char* code, double known)
{
    const auto found = numbers.find(QLatin1String(code));
    return found != numbers.end()
        && std::abs(found->second - known) <= 1e-3 * std::max(1.0, std::abs(known));
}

std::vector<float> floatsOf(const std::vector<glm::dvec3>& places)
{
    std::vector<float> numbers;
    for (const glm::dvec3& place : places)
        numbers.insert(numbers.end(), {float(place.x), float(place.y), float(place.z)});
    return numbers;
}

} // namespace

class ExportMeasurementsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void aReportHoldsThemAll()
    {
        const Study on;
        const QString file = on.folder.filePath(QStringLiteral("a.dcm"));
        const auto made = exportMask(on.volume(), on.report(file), {});
        QVERIFY2(made, qPrintable(made ? QString() : made.error().arguments.join(u' ')));
        const auto read = readSr(file);
        QVERIFY(read);
        // A segment; arrow and text measure nothing.
        QCOMPARE(read->groups.size(), std::size_t(8));
        const auto group = [&read](int id) { return read->groups[std::size_t(id)]; };
        QCOMPARE(group(1).name, QStringLiteral("Measurement 1, projected"));
        QCOMPARE(group(7).name, QStringLiteral("Measurement 7"));
        QVERIFY(isNear(group(1).numbers, "410668003", 5.0));
        QVERIFY(isNear(group(2).numbers, "1483009", 90.0));
        QVERIFY(isNear(group(3).numbers, "42798000", M_PI * 15.0));
        QVERIFY(isNear(group(3).numbers, "103339001", 10.0));
        QVERIFY(isNear(group(3).numbers, "103340004", 6.0));
        QVERIFY(isNear(group(4).numbers, "42798000", 15.0));
        QVERIFY(isNear(group(5).numbers, "42798000", 7.5));
        QVERIFY(isNear(group(6).numbers, "118565006", 4.0 / 3.0 * M_PI * 64.0 / 1000.0));
        QVERIFY(isNear(group(6).numbers, "81827009", 8.0));
        // Around column 12 of slice 5, and as far to either side; the rectangle begins there.
        const double middle = 1000.0 - 1024.0 + 12.0 + 50.0;
        QVERIFY(isNear(group(3).numbers, "373098007", middle));
        QVERIFY(isNear(group(3).numbers, "255605001", middle - 4.0));
        QVERIFY(isNear(group(3).numbers, "56851009", middle + 4.0));
        QVERIFY(isNear(group(4).numbers, "373098007", middle + 2.0));
        QVERIFY(isNear(group(6).numbers, "373098007", middle));
        QVERIFY(isNear(group(7).numbers, "112031", middle));
        // They lie where they were measured.
        const std::vector<Measurement> all = on.measurements();
        for (int id = 1; id <= 7; ++id)
            QCOMPARE(group(id).frameOfReferenceUid, on.volume().identity.frameOfReferenceUid);
        QCOMPARE(group(1).graphicType, QStringLiteral("POLYLINE"));
        QCOMPARE(group(1).graphicData, floatsOf(all[0].pointsLps));
        QCOMPARE(group(2).graphicData, floatsOf(all[1].pointsLps));
        QCOMPARE(group(3).graphicType, QStringLiteral("ELLIPSE"));
        const glm::dvec3 centre = all[6].pointsLps[0];
        QCOMPARE(group(3).graphicData,
            floatsOf({centre - glm::dvec3(0, 5, 0), centre + glm::dvec3(0, 5, 0),
                centre - glm::dvec3(3, 0, 0), centre + glm::dvec3(3, 0, 0)}));
        QCOMPARE(group(4).graphicType, QStringLiteral("POLYGON"));
        QCOMPARE(group(4).graphicData.size(), std::size_t(15)); // closed
        QCOMPARE(group(6).graphicType, QStringLiteral("ELLIPSOID"));
        QCOMPARE(group(7).graphicType, QStringLiteral("POINT"));
        // Other readers know the rules of such trees.
        const auto valid = test::runProgram(QStringLiteral("dciodvfy"), {file});
        QVERIFY2(valid.exitCode == 0 && !valid.output.contains("Error"), valid.output.constData());
        const auto dumped = test::runProgram(QStringLiteral("dsrdump"), {file});
        QVERIFY2(dumped.exitCode == 0, dumped.output.constData());
        QVERIFY(dumped.output.contains("Comprehensive 3D SR"));
    }

    void aWrongNumberIsFound()
    {
        const Study on;
        const QString file = on.folder.filePath(QStringLiteral("a.dcm"));
        ExportRequest request = on.report(file);
        QVERIFY(exportMask(on.volume(), request, {}));
        const auto check = [&](const std::vector<Measurement>& measurements) {
            return checkStatisticsExport(file,
                {.volume = on.volume(),
                    .segments = request.segments,
                    .planes = request.planes,
                    .format = ExportFormat::Sr,
                    .codes = request.codes,
                    .measurements = measurements},
                {});
        };
        QVERIFY(check(request.measurements));
        std::vector<Measurement> others = request.measurements;
        others[0].pointsLps[1].x += 0.01;
        QVERIFY(!check(others));
        others = request.measurements;
        others[5].pointsLps[1].z += 0.5; // the ball
        QVERIFY(!check(others));
        others = request.measurements;
        others.erase(others.begin());
        QVERIFY(!check(others));
    }

    void withoutThemAReportStaysAsItWas()
    {
        const Study on;
        const QString file = on.folder.filePath(QStringLiteral("a.dcm"));
        ExportRequest request = on.report(file);
        request.measurements.clear();
        QVERIFY(exportMask(on.volume(), request, {}));
        QCOMPARE(readSr(file)->groups.size(), std::size_t(1));
        const auto dumped = test::runProgram(QStringLiteral("dsrdump"), {file});
        QVERIFY(dumped.output.contains("Enhanced SR"));
    }

    void aTableHoldsThemAll()
    {
        const Study on;
        std::vector<Measured> all;
        for (const Measurement& each : on.measurements())
            all.push_back(measuredIn(each, on.volume(), on.loaded.codes));
        const QString file = on.folder.filePath(QStringLiteral("a.csv"));
        QVERIFY(exportMeasurements(all, on.volume(), file, false));
        QVERIFY(!exportMeasurements(all, on.volume(), file, false)); // it is there
        QVERIFY(exportMeasurements(all, on.volume(), file, true));
        // Python's reader of tables gets the same.
        const QByteArray script = R"(
import csv, sys
rows = list(csv.DictReader(open(sys.argv[1], newline='', encoding='utf-8')))
for row in rows:
    print(row['number'], row['kind'], row['projected'], row['sizesIn'], row['valueUnit'], sep='|')
print(float(rows[0]['length']), float(rows[1]['angleDegrees']), rows[1]['length'] == '')
print(round(float(rows[3]['area']), 6), int(float(rows[6]['voxels'])), float(rows[6]['mean']))
print(rows[7]['text'], rows[8]['text'], len(rows[4]['pointsLps'].split(';')))
)";
        const QString program = on.folder.filePath(QStringLiteral("read.py"));
        QFile out(program);
        QVERIFY(out.open(QIODevice::WriteOnly) && out.write(script) == script.size());
        out.close();
        const auto read = test::runProgram(QStringLiteral("python3"), {program, file});
        QVERIFY2(read.exitCode == 0, read.output.constData());
        const QList<QByteArray> lines = read.output.trimmed().split('\n');
        QCOMPARE(lines.size(), 12);
        QCOMPARE(lines[0], QByteArray("1|distance|yes|mm|HU"));
        QCOMPARE(lines[5], QByteArray("6|ball|no|mm|HU"));
        QCOMPARE(lines[9], QByteArray("5.0 90.0 True"));
        QCOMPARE(lines[10], QByteArray("15.0 1 38.0"));
        QCOMPARE(lines[11], QByteArray("Here, \"there\" Fissure 3"));
    }

    /// A spreadsheet would take it for one.
    void aTextIsNoFormula()
    {
        const Study on;
        Measurement measurement = on.measurements().back();
        measurement.text = QStringLiteral("=1+1");
        const QByteArray table =
            measurementsCsv({measuredIn(measurement, on.volume(), on.loaded.codes)}, on.volume());
        QVERIFY2(table.contains(",\"'=1+1\","), table.constData());
    }
};

BURIN_TEST(ExportMeasurementsTest)

} // namespace exportMeasurementsTest

#include "ExportMeasurementsTest.moc"
