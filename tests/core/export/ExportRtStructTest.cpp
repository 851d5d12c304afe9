// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/objects/RtStructFile.h"
#include "core/dicom/source/KeptHeaders.h"
#include "core/export/common/CheckExport.h"
#include "tests/support/faults/FileSizeLimit.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/AlterDicom.h"
#include "tests/support/series/LabelledSeries.h"
#include "tests/support/servers/Python.h"
#include "ui/texts/ReportTexts.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <functional>
#include <random>

namespace exportRtStructTest {

namespace {

using Alter = std::function<void(DcmDataset&)>;

core::Segment segmentOf(int label, const QString& name = QStringLiteral("Schädel"))
{
    core::Segment segment;
    segment.label = std::uint8_t(label);
    segment.name = name;
    segment.rgb = 0x3399ffU + unsigned(label);
    return segment;
}

/// Random labels 0 to 3, mostly 1, so that there are holes; of several slices the first is empty.
std::vector<std::uint8_t> randomLabels(const glm::ivec3& size)
{
    std::mt19937 random(9);
    const std::size_t slice = std::size_t(size.x) * std::size_t(size.y);
    std::vector<std::uint8_t> labels(slice * std::size_t(size.z), 0);
    const std::array<std::uint8_t, 8> palette{1, 1, 1, 1, 1, 0, 2, 3};
    for (std::size_t i = size.z > 1 ? slice : 0; i < labels.size(); ++i)
        labels[i] = palette[random() % palette.size()];
    return labels;
}

QString messageOf(const core::Error& error)
{
    return error.arguments.join(QStringLiteral(" | "));
}

test::SmallSeries axialSeries()
{
    return test::placementOf(QStringLiteral("axial")).series;
}

struct Fixture : test::LabelledSeries {
    explicit Fixture(
        const test::SmallSeries& series = axialSeries(), Write write = &test::SmallSeries::write)
        : LabelledSeries(series, randomLabels(series.size), write)
    {
    }
    [[nodiscard]] core::Result<core::ExportReport> exported(
        const std::vector<core::Segment>& segments, const core::Progress& progress = {}) const
    {
        return core::exportMask(volume,
            {.format = core::ExportFormat::RtStruct,
                .file = file,
                .force = true,
                .segments = segments,
                .planes = planes},
            progress);
    }
    [[nodiscard]] QJsonObject facts() const
    {
        const auto read = test::runScript(QStringLiteral("rtstruct_facts.py"), {file, images});
        if (read.exitCode != 0)
            qWarning("%s", qPrintable(read.errors));
        return QJsonDocument::fromJson(read.output).object();
    }
    QString file = folder.filePath(QStringLiteral("contours.dcm"));
};

DcmItem& itemIn(DcmItem& parent, const DcmTagKey& sequence, long index = 0)
{
    DcmItem* item = nullptr;
    parent.findAndGetSequenceItem(sequence, item, index);
    return *item;
}

DcmItem& contourIn(DcmDataset& set, long index = 0)
{
    return itemIn(itemIn(set, DCM_ROIContourSequence), DCM_ContourSequence, index);
}

/// Changes the points of every contour, or of the first alone.
void movePoints(
    DcmDataset& set, const std::function<void(std::array<double, 3>&)>& move, bool all = true)
{
    for (long i = 0; i < (all ? 4 : 1); ++i) {
        DcmItem& contour = contourIn(set, i);
        QStringList texts;
        Float64 value = 0.0;
        for (unsigned long at = 0; contour.findAndGetFloat64(DCM_ContourData, value, at).good();
             at += 3) {
            std::array<double, 3> point{value, 0, 0};
            contour.findAndGetFloat64(DCM_ContourData, point[1], at + 1);
            contour.findAndGetFloat64(DCM_ContourData, point[2], at + 2);
            move(point);
            for (const double number : point)
                texts += QString::number(number, 'g', 10);
        }
        contour.putAndInsertString(
            DCM_ContourData, texts.join(QLatin1Char('\\')).toLatin1().constData());
    }
}

} // namespace

} // namespace exportRtStructTest

Q_DECLARE_METATYPE(exportRtStructTest::Alter)

namespace exportRtStructTest {

/// Masks as DICOM RTSTRUCT: written, checked by Burin, read by pydicom and dciodvfy.
class ExportRtStructTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void othersSeeTheSame_data() { test::addPlacementRows(); }
    void othersSeeTheSame();
    void framesOfOneFile();
    void headersKeptInASessionWillDo();
    void longContours();
    void withoutFrameOfReference();
    void withoutUidsIsRefused();
    void namesAndCodes();
    void fullDiskLeavesNothing();
    void cancelledLeavesNothing();
    void faultInTheFileIsCaught_data();
    void faultInTheFileIsCaught();

private:
    void validate(const QString& file);
};

void ExportRtStructTest::validate(const QString& file)
{
    const auto result = test::runProgram(QStringLiteral("dciodvfy"), {file});
    QVERIFY2(result.exitCode == 0 && !result.output.contains("Error"), result.output.constData());
}

void ExportRtStructTest::othersSeeTheSame()
{
    QFETCH(QString, placement);
    const test::SmallSeries series = test::placementOf(placement).series;
    const Fixture on(series);
    const auto report = on.exported({segmentOf(1), segmentOf(3, QStringLiteral("Leber"))});
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    QCOMPARE(report->checked.size(), 2);
    QCOMPARE(ui::reportTexts(report->cautions), QStringList());
    QCOMPARE(on.fileCount(), 1);
    validate(on.file);

    const QJsonObject facts = on.facts();
    const QJsonArray rois = facts["rois"].toArray();
    QCOMPARE(rois.size(), 2);
    QCOMPARE(rois[0]["sha256"].toString(), on.sha256Of(1));
    QCOMPARE(rois[1]["sha256"].toString(), on.sha256Of(3));
    QCOMPARE(rois[0]["name"].toString(), QStringLiteral("Schädel"));
    QCOMPARE(rois[1]["name"].toString(), QStringLiteral("Leber"));
    QCOMPARE(rois[0]["color"].toArray(), (QJsonArray{0x33, 0x9a, 0x00}));
    QVERIFY(facts["offPlaneMm"].toDouble() < 1e-3);
    QCOMPARE(facts["referenced"].toInt(), series.size.z);
    QCOMPARE(facts["frameOfReference"].toString(), on.volume.identity.frameOfReferenceUid);
}

void ExportRtStructTest::framesOfOneFile()
{
    const Fixture on(axialSeries(), &test::SmallSeries::writeMultiFrame);
    const auto report = on.exported({segmentOf(1)});
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    validate(on.file);
    const auto set = core::readRtStruct(on.file);
    QVERIFY(set.has_value());
    QCOMPARE(set->referencedSopUids.size(), 1);
    for (const core::RtContour& contour : set->rois[0].contours) {
        const int k = (contour.referencedFrame + 2) % 6;
        QCOMPARE(contour.points.front().z, 812.125 + 2.5 * k);
    }
}

void ExportRtStructTest::headersKeptInASessionWillDo()
{
    Fixture on;
    const auto kept = core::keepHeaders(on.volume.sources, {});
    QVERIFY(kept);
    const auto before = on.exported({segmentOf(1)});
    QVERIFY(before);
    on.volume.keptHeaders = std::make_shared<const core::KeptHeaders>(*kept);
    QVERIFY(QDir(on.images).removeRecursively());
    const auto report = on.exported({segmentOf(1)});
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    QCOMPARE(ui::reportTexts(report->checked), ui::reportTexts(before->checked));
    QCOMPARE(report->cautions.size(), 1);
}

/// A contour's numbers may fill more than explicit VR could say.
void ExportRtStructTest::longContours()
{
    test::SmallSeries series;
    series.size = {160, 130, 1};
    series.placeEvenly({-40.25, -31.5, 812.125}, {0, 0, 2.5});
    Fixture on(series);
    // A comb of one piece.
    for (int y = 0; y < 130; ++y) {
        for (int x = 0; x < 160; ++x)
            on.labels[std::size_t(y * 160 + x)] =
                x == 0 || (y % 2 == 0 && (x + y) % 5 != 0) ? 1 : 0;
    }
    for (int y = 0; y < 130; ++y) {
        for (int x = 1; x < 160; ++x) {
            if ((x + y) % 5 == 0 && y % 2 == 0)
                on.labels[std::size_t(y * 160 + x)] = 1;
            else if (x % 2 == 0 && y % 2 == 1 && x + 1 < 160)
                on.labels[std::size_t(y * 160 + x)] = 1;
        }
    }
    const auto report = on.exported({segmentOf(1)});
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    const QJsonObject roi = on.facts()["rois"].toArray()[0].toObject();
    QCOMPARE(roi["sha256"].toString(), on.sha256Of(1));
    QVERIFY(roi["mostPoints"].toInt() > 10'000);
    validate(on.file);
}

void ExportRtStructTest::withoutFrameOfReference()
{
    test::SmallSeries series = axialSeries();
    series.frameOfReference = false;
    const Fixture on(series);
    const auto report = on.exported({segmentOf(1)});
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    QVERIFY(ui::reportTexts(report->cautions)
                .join(u' ')
                .contains(QStringLiteral("frame of reference")));
    QVERIFY(!on.facts()["frameOfReference"].toString().isEmpty());
    validate(on.file);
}

void ExportRtStructTest::withoutUidsIsRefused()
{
    Fixture on;
    on.volume.sources[2].sopInstanceUid.clear();
    const auto report = on.exported({segmentOf(1)});
    QVERIFY(!report);
    QCOMPARE(report.error().code, core::ErrorCode::UnsupportedFormat);
    QVERIFY(messageOf(report.error()).contains(QStringLiteral("RTSTRUCT")));
    QCOMPARE(on.fileCount(), 0);
}

void ExportRtStructTest::namesAndCodes()
{
    const Fixture on;
    core::Segment coded = segmentOf(1, QStringLiteral("頭蓋\\a\tb "));
    coded.code = {.scheme = QStringLiteral("SCT"),
        .value = QStringLiteral("89546000"),
        .meaning = QStringLiteral("Skull")};
    // No code that DICOM can hold.
    core::Segment odd = segmentOf(2, QString());
    odd.code = {.scheme = QStringLiteral("99X"), .value = QString(20, u'1'), .meaning = {}};
    const auto report = on.exported({coded, odd, segmentOf(3, QString(100, u'x')), segmentOf(9)});
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    QCOMPARE(report->cautions.size(), 1); // the empty one
    validate(on.file);
    const QJsonArray rois = on.facts()["rois"].toArray();
    QCOMPARE(rois.size(), 3);
    QCOMPARE(rois[0]["name"].toString(), QStringLiteral("頭蓋ab"));
    QCOMPARE(rois[2]["name"].toString(), QString(64, u'x'));
    QCOMPARE(rois[1]["name"].toString(), QStringLiteral("Segment"));
    DcmFileFormat format;
    QVERIFY(format.loadFile(QFile::encodeName(on.file).constData()).good());
    OFString meaning;
    itemIn(itemIn(*format.getDataset(), DCM_RTROIObservationsSequence),
        DCM_RTROIIdentificationCodeSequence)
        .findAndGetOFString(DCM_CodeMeaning, meaning);
    QCOMPARE(QString::fromStdString(meaning), QStringLiteral("Skull"));
}

void ExportRtStructTest::fullDiskLeavesNothing()
{
    const Fixture on;
    const test::FileSizeLimit limit(1000);
    const auto report = on.exported({segmentOf(1)});
    QVERIFY(!report);
    QCOMPARE(report.error().code, core::ErrorCode::FileUnwritable);
    QCOMPARE(report.error().arguments.value(0), on.file);
    QCOMPARE(on.fileCount(), 0);
}

void ExportRtStructTest::cancelledLeavesNothing()
{
    const Fixture on;
    core::Progress progress;
    progress.cancel();
    const auto report = on.exported({segmentOf(1)}, progress);
    QVERIFY(!report);
    QCOMPARE(report.error().code, core::ErrorCode::Cancelled);
    QCOMPARE(on.fileCount(), 0);
}

void ExportRtStructTest::faultInTheFileIsCaught_data()
{
    QTest::addColumn<Alter>("change");
    const auto points = [](const char* name, auto move, bool all = true) {
        QTest::newRow(name) << Alter([=](DcmDataset& set) { movePoints(set, move, all); });
    };
    using Point = std::array<double, 3>;
    points("flip of columns", [](Point& p) { p[0] = 2.0 * (-40.25 + 0.7 * 5) - p[0]; });
    points("flip of rows", [](Point& p) { p[1] = 2.0 * (-31.5 + 0.9 * 3) - p[1]; });
    points("half a slice", [](Point& p) { p[2] += 1.25; });
    points("a hundredth of a millimetre off the plane", [](Point& p) { p[2] += 0.01; });
    points("a column", [](Point& p) { p[0] += 0.7; });
    points(
        "one contour", [](Point& p) { p[1] += 0.9; }, false);
    const auto text = [](const char* name, const DcmTagKey& tag, const char* value) {
        QTest::newRow(name) << Alter([=](DcmDataset& set) { set.putAndInsertString(tag, value); });
    };
    text("another patient's name", DCM_PatientName, "Maier^Anna");
    text("another patient's ID", DCM_PatientID, "P-0816");
    text("another birth date", DCM_PatientBirthDate, "19500201");
    text("another study", DCM_StudyInstanceUID, "2.25.4711");
    QTest::newRow("another frame of reference") << Alter([](DcmDataset& set) {
        itemIn(set, DCM_ReferencedFrameOfReferenceSequence)
            .putAndInsertString(DCM_FrameOfReferenceUID, "2.25.4711");
    });
    const auto roi = [](const char* name, const DcmTagKey& sequence, const DcmTagKey& tag,
                         const char* value) {
        QTest::newRow(name) << Alter(
            [=](DcmDataset& set) { itemIn(set, sequence).putAndInsertString(tag, value); });
    };
    roi("another frame of a region", DCM_StructureSetROISequence, DCM_ReferencedFrameOfReferenceUID,
        "2.25.4711");
    roi("another name", DCM_StructureSetROISequence, DCM_ROIName, "Scull");
    roi("another colour", DCM_ROIContourSequence, DCM_ROIDisplayColor, "51\\154\\1");
    roi("no colour", DCM_ROIContourSequence, DCM_ROIDisplayColor, "51\\154");
    QTest::newRow("regions exchanged") << Alter([](DcmDataset& set) {
        for (const long i : {0, 1})
            itemIn(set, DCM_ROIContourSequence, i)
                .putAndInsertString(DCM_ReferencedROINumber, i == 0 ? "2" : "1");
    });
    QTest::newRow("another image") << Alter([](DcmDataset& set) {
        itemIn(contourIn(set), DCM_ContourImageSequence)
            .putAndInsertString(DCM_ReferencedSOPInstanceUID, "2.25.4711");
    });
    QTest::newRow("an open contour") << Alter([](DcmDataset& set) {
        contourIn(set).putAndInsertString(DCM_ContourGeometricType, "OPEN_PLANAR");
    });
    QTest::newRow("a contour less") << Alter([](DcmDataset& set) {
        DcmSequenceOfItems* items = nullptr;
        itemIn(set, DCM_ROIContourSequence).findAndGetSequence(DCM_ContourSequence, items);
        delete items->remove(items->card() - 1);
    });
    QTest::newRow("a contour twice") << Alter([](DcmDataset& set) {
        DcmSequenceOfItems* items = nullptr;
        itemIn(set, DCM_ROIContourSequence).findAndGetSequence(DCM_ContourSequence, items);
        items->append(new DcmItem(*items->getItem(0)));
    });
    QTest::newRow("a source less") << Alter([](DcmDataset& set) {
        DcmItem& study = itemIn(
            itemIn(set, DCM_ReferencedFrameOfReferenceSequence), DCM_RTReferencedStudySequence);
        DcmSequenceOfItems* items = nullptr;
        itemIn(study, DCM_RTReferencedSeriesSequence)
            .findAndGetSequence(DCM_ContourImageSequence, items);
        delete items->remove(0UL);
    });
}

void ExportRtStructTest::faultInTheFileIsCaught()
{
    QFETCH(Alter, change);
    const Fixture on;
    const std::vector<core::Segment> segments{segmentOf(1), segmentOf(2)};
    QVERIFY(on.exported(segments));
    const core::ExportExpectation expected{on.volume, segments, on.planes};
    // The way through DCMTK and back alone is no fault.
    test::alterDicom(on.file, [](DcmDataset&) {});
    QVERIFY(core::checkRtStructExport(on.file, expected, {}));
    test::alterDicom(on.file, change);
    const auto checked = core::checkRtStructExport(on.file, expected, {});
    QVERIFY(!checked);
    QCOMPARE(checked.error().code, core::ErrorCode::ExportMismatch);
    QCOMPARE(checked.error().arguments.value(0), on.file);
    QVERIFY(!checked.error().arguments.value(1).isEmpty());
}

BURIN_TEST(ExportRtStructTest)

} // namespace exportRtStructTest

#include "ExportRtStructTest.moc"
