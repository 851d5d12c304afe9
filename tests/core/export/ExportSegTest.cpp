// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/objects/SegReader.h"
#include "core/dicom/source/KeptHeaders.h"
#include "core/export/common/ExportMask.h"
#include "tests/support/faults/FileSizeLimit.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/LabelledSeries.h"
#include "tests/support/servers/Python.h"
#include "ui/texts/ReportTexts.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <memory>
#include <random>
#include <sstream>

namespace exportSegTest {

namespace {

const core::CodedConcept skull{.scheme = QStringLiteral("SCT"),
    .value = QStringLiteral("89546000"),
    .meaning = QStringLiteral("Skull")};
const core::CodedConcept liver{.scheme = QStringLiteral("SCT"),
    .value = QStringLiteral("10200004"),
    .meaning = QStringLiteral("Liver")};

core::Segment segmentOf(int label, const core::CodedConcept& code, int plane = 0)
{
    core::Segment segment;
    segment.label = std::uint8_t(label);
    segment.plane = std::uint8_t(plane);
    segment.name = QStringLiteral("Schädel %1").arg(label);
    segment.rgb = 0x3399ff;
    segment.code = code;
    return segment;
}

/// Random labels 0, 1, 2 and 5; of several slices the first is empty, the second full of label 1.
std::vector<std::uint8_t> randomLabels(const glm::ivec3& size, unsigned seed)
{
    std::mt19937 random(seed);
    const std::size_t slice = std::size_t(size.x) * std::size_t(size.y);
    std::vector<std::uint8_t> labels(slice * std::size_t(size.z), 0);
    const std::array<std::uint8_t, 4> palette{0, 1, 2, 5};
    for (std::size_t i = size.z > 1 ? slice : 0; i < labels.size(); ++i)
        labels[i] = size.z > 1 && i < 2 * slice ? std::uint8_t(1) : palette[random() % 4];
    return labels;
}

QString messageOf(const core::Error& error)
{
    return QString::number(int(error.code)) + QLatin1Char(' ')
        + error.arguments.join(QStringLiteral(" | "));
}

test::SmallSeries evenSeries()
{
    test::SmallSeries series;
    series.placeEvenly({0, 0, 0}, {0, 0, 1});
    return series;
}

struct Fixture : test::LabelledSeries {
    explicit Fixture(
        const test::SmallSeries& series = evenSeries(), Write write = &test::SmallSeries::write)
        : LabelledSeries(series, randomLabels(series.size, 1), write)
    {
    }
    [[nodiscard]] core::ExportRequest request(
        const std::vector<core::Segment>& segments = {segmentOf(1, skull)}) const
    {
        return {.file = file, .segments = segments, .planes = planes};
    }
    [[nodiscard]] core::Result<core::ExportReport> exported(
        const core::ExportRequest& what, const core::Progress& progress = {}) const
    {
        return core::exportMask(volume, what, progress);
    }

    QString file = folder.filePath(QStringLiteral("seg.dcm"));
};

/// What pydicom sees in a SEG and the images that it refers to.
QJsonObject factsOf(const Fixture& on)
{
    const auto read = test::runScript(QStringLiteral("seg_facts.py"), {on.file, on.images});
    if (read.exitCode != 0)
        qWarning("%s", qPrintable(read.errors));
    return QJsonDocument::fromJson(read.output).object();
}

} // namespace

class ExportSegTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void othersSeeTheSame_data() { test::addPlacementRows(); }
    void othersSeeTheSame();
    void bitsOfEveryWidth_data();
    void bitsOfEveryWidth();
    void framesOfOneFile();
    void headersKeptInASessionWillDo_data();
    void headersKeptInASessionWillDo();
    void planesOverlap();
    void emptySegmentIsLeftOutAndNamed();
    void nothingToExport();
    void segmentWithoutCodeIsRefused();
    void sourceWithoutUidsIsRefused();
    void sourceWithoutFrameOfReference();
    void invalidSourceValuesAreNormalised();
    void namesInOtherScripts_data();
    void namesInOtherScripts();
    void existingFileIsRefused();
    void aFileOfTheStudyIsNeverReplaced();
    void fullDiskLeavesNothing();
    void cancelledLeavesNothing();
    void uidsAreNewEachTime();

private:
    void validate(const QString& file);
};

void ExportSegTest::validate(const QString& file)
{
    const auto result = test::runProgram(QStringLiteral("dciodvfy"), {file});
    const QByteArray text = result.output;
    QVERIFY2(result.exitCode == 0 && !text.contains("Error"), text.constData());
}

void ExportSegTest::othersSeeTheSame()
{
    QFETCH(QString, placement);
    const test::SmallSeries series = test::placementOf(placement).series;
    const glm::ivec3 size = series.size;
    const Fixture on(series);
    const auto report = on.exported(on.request({segmentOf(1, skull), segmentOf(5, liver)}));
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    QVERIFY(!report->written.isEmpty() && !report->checked.isEmpty());
    QCOMPARE(on.fileCount(), 1);

    const QJsonObject facts = factsOf(on);
    QCOMPARE(facts["sha256"].toArray(), (QJsonArray{on.sha256Of(1), on.sha256Of(5)}));
    QCOMPARE(facts["emptyFrames"].toInt(), 0);
    QCOMPARE(facts["frames"].toInt(), size.z > 1 ? (size.z - 1) + (size.z - 2) : 2);
    QCOMPARE(facts["overlap"].toString(), QStringLiteral("NO"));
    QCOMPARE(facts["patientName"].toString(), QStringLiteral("Müller^Jörg"));
    QCOMPARE(facts["frameOfReference"].toString(), on.volume.identity.frameOfReferenceUid);
    QCOMPARE(facts["referenced"].toInt(), size.z);
    QCOMPARE(facts["labels"].toArray()[0].toString(), QStringLiteral("Schädel 1"));
    QCOMPARE(facts["algorithms"].toArray()[0].toArray(),
        (QJsonArray{QStringLiteral("SEMIAUTOMATIC"), QStringLiteral("Burin")}));
    QCOMPARE(facts["codes"].toArray()[1].toArray(),
        (QJsonArray{QStringLiteral("SCT"), QStringLiteral("10200004"), QStringLiteral("Liver")}));
    // The published value of (0.2, 0.6, 1.0): DICOM.md, from DCMTK's own tool and by hand.
    QCOMPARE(facts["lab"].toArray()[0].toArray(), (QJsonArray{40801, 34472, 17791}));
    validate(on.file);
}

/// Frames of a size that is no multiple of a byte follow each other without a gap.
void ExportSegTest::bitsOfEveryWidth_data()
{
    QTest::addColumn<glm::ivec3>("size");
    for (int columns = 8; columns < 16; ++columns)
        QTest::addRow("rows x columns mod 8 = %d", 9 * columns % 8) << glm::ivec3(columns, 9, 5);
    QTest::addRow("a small one") << glm::ivec3(5, 3, 1);
}

void ExportSegTest::bitsOfEveryWidth()
{
    QFETCH(glm::ivec3, size);
    test::SmallSeries series;
    series.size = size;
    series.placeEvenly({-40.25, -31.5, 812.125}, {0, 0, 2.5});
    const Fixture on(series);
    const auto report = on.exported(on.request({segmentOf(1, skull), segmentOf(5, liver)}));
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    QCOMPARE(factsOf(on)["sha256"].toArray(), (QJsonArray{on.sha256Of(1), on.sha256Of(5)}));
    validate(on.file);
}

void ExportSegTest::framesOfOneFile()
{
    test::SmallSeries series;
    series.placeEvenly({3, 4, 5}, {0, 0, 1.5});
    const Fixture on(series, &test::SmallSeries::writeMultiFrame);
    const auto report = on.exported(on.request());
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    validate(on.file);
    const auto seg = core::readSeg(on.file);
    QVERIFY(seg.has_value());
    QCOMPARE(seg->referencedSopUids.size(), 1);
    QCOMPARE(seg->frames.size(), std::size_t(series.size.z - 1));
    for (const core::SegFrame& frame : seg->frames) {
        const int k = (frame.referencedFrame + 2) % series.size.z;
        QCOMPARE(frame.plane.position.z, 5.0 + 1.5 * k);
    }
}

void ExportSegTest::headersKeptInASessionWillDo_data()
{
    QTest::addColumn<bool>("multiFrame");
    QTest::addColumn<bool>("oddValues");
    QTest::newRow("a file per slice") << false << false;
    QTest::newRow("one file") << true << false;
    QTest::newRow("values that are not valid") << false << true;
}

/// Without the files, the export is the same as with them.
void ExportSegTest::headersKeptInASessionWillDo()
{
    QFETCH(bool, multiFrame);
    QFETCH(bool, oddValues);
    test::SmallSeries series = evenSeries();
    if (oddValues)
        series.sex = "male";
    Fixture on(
        series, multiFrame ? &test::SmallSeries::writeMultiFrame : &test::SmallSeries::write);
    // What is new each time does not count.
    const auto textOf = [](const QString& file) {
        DcmFileFormat format;
        if (format.loadFile(QFile::encodeName(file).constData()).bad())
            return QStringList{QStringLiteral("unreadable")};
        std::ostringstream text;
        format.getDataset()->print(text, DCMTypes::PF_shortenLongTagValues);
        return QString::fromStdString(text.str())
            .split(u'\n')
            .filter(QRegularExpression(QStringLiteral("^(?!.*\\) (UI|DA|TM) ).*$")));
    };
    const auto fromFiles = on.exported(on.request());
    QVERIFY2(fromFiles, qPrintable(fromFiles ? QString() : messageOf(fromFiles.error())));
    const QStringList expected = textOf(on.file);
    QVERIFY(expected.size() > 20);
    const auto references = core::readSeg(on.file)->referencedSopUids;

    const auto kept = core::keepHeaders(on.volume.sources, {});
    QVERIFY(kept);
    QCOMPARE(kept->size(), std::size_t(multiFrame ? 1 : series.size.z));
    for (const auto& [file, header] : *kept)
        QVERIFY2(header.size() < 4096, qPrintable(QString::number(header.size())));
    on.volume.keptHeaders = std::make_shared<const core::KeptHeaders>(*kept);
    QVERIFY(QDir(on.images).removeRecursively());
    on.file = on.folder.filePath(QStringLiteral("again.dcm"));
    const auto report = on.exported(on.request());
    QVERIFY2(report, qPrintable(report ? QString() : messageOf(report.error())));
    QCOMPARE(ui::reportTexts(report->written), ui::reportTexts(fromFiles->written));
    QCOMPARE(ui::reportTexts(report->checked), ui::reportTexts(fromFiles->checked));
    QCOMPARE(textOf(on.file), expected);
    QCOMPARE(core::readSeg(on.file)->referencedSopUids, references);
}

void ExportSegTest::planesOverlap()
{
    Fixture on;
    const auto second = randomLabels(on.volume.geometry.size, 2);
    on.planes.push_back({.plane = 1, .labels = second});
    const auto report = on.exported(on.request({segmentOf(1, skull, 0), segmentOf(1, liver, 1)}));
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    const QJsonObject facts = factsOf(on);
    QCOMPARE(
        facts["sha256"].toArray(), (QJsonArray{on.sha256Of(1), test::sha256OfLabel(second, 1)}));
    QCOMPARE(facts["overlap"].toString(), QStringLiteral("YES"));
    validate(on.file);
}

void ExportSegTest::emptySegmentIsLeftOutAndNamed()
{
    const Fixture on;
    const auto report = on.exported(on.request({segmentOf(7, {}), segmentOf(2, liver)}));
    QVERIFY(report.has_value());
    QVERIFY(ui::reportTexts(report->cautions)
                .join(QLatin1Char(' '))
                .contains(QStringLiteral("Schädel 7")));
    const auto seg = core::readSeg(on.file);
    QVERIFY(seg.has_value());
    QCOMPARE(seg->segments.size(), std::size_t(1));
    QCOMPARE(seg->segments[0].number, 1);
    QCOMPARE(seg->segments[0].category.value, QStringLiteral("123037004"));
}

void ExportSegTest::nothingToExport()
{
    const Fixture on;
    for (const std::vector<core::Segment>& segments :
        {std::vector<core::Segment>{}, std::vector<core::Segment>{segmentOf(9, skull)}}) {
        const auto report = on.exported(on.request(segments));
        QVERIFY(!report);
        QCOMPARE(report.error().code, core::ErrorCode::NothingToExport);
    }
    QCOMPARE(on.fileCount(), 0);
}

void ExportSegTest::segmentWithoutCodeIsRefused()
{
    const Fixture on;
    core::ExportRequest request = on.request({segmentOf(1, skull), segmentOf(2, {})});
    auto report = on.exported(request);
    QVERIFY(!report);
    QCOMPARE(report.error().code, core::ErrorCode::SegmentNotCoded);
    QCOMPARE(report.error().arguments.value(0), QStringLiteral("Schädel 2"));
    request.segments[1].code = {.scheme = QStringLiteral("SCT"),
        .value = QStringLiteral("12345678901234567"),
        .meaning = QStringLiteral("Too long")};
    report = on.exported(request);
    QVERIFY(!report);
    QCOMPARE(report.error().code, core::ErrorCode::InvalidField);
    QCOMPARE(on.fileCount(), 0);
}

void ExportSegTest::sourceWithoutUidsIsRefused()
{
    Fixture on;
    core::Volume& volume = on.volume;
    QVERIFY(core::dicomSegObstacle(volume).isEmpty());
    volume.sources[3].sopInstanceUid.clear();
    QVERIFY(core::dicomSegObstacle(volume).contains(QStringLiteral("NIfTI")));
    const auto report = on.exported(on.request());
    QVERIFY(!report);
    QCOMPARE(report.error().code, core::ErrorCode::UnsupportedFormat);
    QVERIFY(report.error().arguments.value(1).contains(QStringLiteral("NIfTI")));
    volume.sourceFormat = QStringLiteral("NIfTI");
    volume.sources.clear();
    QVERIFY(!core::dicomSegObstacle(volume).isEmpty());
}

void ExportSegTest::sourceWithoutFrameOfReference()
{
    test::SmallSeries series = evenSeries();
    series.frameOfReference = false;
    const Fixture on(series);
    const auto report = on.exported(on.request());
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    validate(on.file);
}

void ExportSegTest::invalidSourceValuesAreNormalised()
{
    test::SmallSeries series = evenSeries();
    series.sex = "male";
    series.studyDate = "2020.03.04";
    series.birthDate = "unknown";
    const Fixture on(series);
    const auto report = on.exported(on.request());
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    QVERIFY(ui::reportTexts(report->cautions)
                .join(QLatin1Char(' '))
                .contains(QStringLiteral("Birth Date")));
    QCOMPARE(factsOf(on)["patientSex"].toString(), QStringLiteral("M"));
    validate(on.file);
}

void ExportSegTest::namesInOtherScripts_data()
{
    QTest::addColumn<QByteArray>("characterSet");
    QTest::addColumn<QByteArray>("stored");
    QTest::addColumn<QString>("name");
    QTest::newRow("Cyrillic") << QByteArray("ISO_IR 144") << QByteArray("\xbb\xee\xda\xd1")
                              << QStringLiteral("Люкб");
    QTest::newRow("UTF-8") << QByteArray("ISO_IR 192")
                           << QStringLiteral("Wang^XiaoDong=王^小東").toUtf8()
                           << QStringLiteral("Wang^XiaoDong=王^小東");
    // PS3.5 annex H, example 1.
    QTest::newRow("Japanese")
        << QByteArray("\\ISO 2022 IR 87")
        << QByteArray("Yamada^Tarou=\033$B;3ED\033(B^\033$BB@O:\033(B=\033$B$d$^$@\033(B^"
                      "\033$B$?$m$&\033(B")
        << QStringLiteral("Yamada^Tarou=山田^太郎=やまだ^たろう");
    // Not what the header says it is: shown as it can be, written as it was shown.
    QTest::newRow("wrong character set")
        << QByteArray("ISO_IR 6") << QByteArray("M\xfcller") << QStringLiteral("Müller");
}

void ExportSegTest::namesInOtherScripts()
{
    QFETCH(QByteArray, characterSet);
    QFETCH(QByteArray, stored);
    QFETCH(QString, name);
    test::SmallSeries series = evenSeries();
    series.characterSet = characterSet.toStdString();
    series.patientName = stored.toStdString();
    const Fixture on(series);
    const auto report = on.exported(on.request());
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    const auto seg = core::readSeg(on.file);
    QVERIFY(seg.has_value());
    QCOMPARE(seg->patient.name, name);
    validate(on.file);
}

void ExportSegTest::existingFileIsRefused()
{
    const Fixture on;
    QFile old(on.file);
    QVERIFY(old.open(QIODevice::WriteOnly));
    old.write("kept");
    old.close();
    core::ExportRequest request = on.request();
    const auto refused = on.exported(request);
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, core::ErrorCode::FileExists);
    QCOMPARE(QFileInfo(old).size(), 4);
    request.force = true;
    QVERIFY(on.exported(request));
    QVERIFY(core::readSeg(on.file));
}

void ExportSegTest::aFileOfTheStudyIsNeverReplaced()
{
    const Fixture on;
    core::ExportRequest request = on.request();
    request.file = on.volume.sources[2].file;
    request.force = true;
    const qint64 size = QFileInfo(request.file).size();
    const auto refused = on.exported(request);
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, core::ErrorCode::FileUnwritable);
    QCOMPARE(QFileInfo(request.file).size(), size);
}

void ExportSegTest::fullDiskLeavesNothing()
{
    test::SmallSeries series;
    series.size = {64, 64, 8};
    series.placeEvenly({0, 0, 0}, {0, 0, 1});
    const Fixture on(series);
    for (const auto format : {core::ExportFormat::DicomSeg, core::ExportFormat::Nifti}) {
        core::ExportRequest request = on.request();
        request.format = format;
        if (format == core::ExportFormat::Nifti)
            request.file = on.folder.filePath(QStringLiteral("seg.nii.gz"));
        // A limit on the size of files is the full disk that a test can have.
        const test::FileSizeLimit limit(2048);
        const auto refused = on.exported(request);
        QVERIFY(!refused);
        QVERIFY2(refused.error().code == core::ErrorCode::FileUnwritable,
            qPrintable(messageOf(refused.error())));
        QCOMPARE(refused.error().arguments.value(0), request.file);
    }
    QCOMPARE(on.fileCount(), 0);
}

void ExportSegTest::cancelledLeavesNothing()
{
    const Fixture on;
    for (const auto format : {core::ExportFormat::DicomSeg, core::ExportFormat::Nifti}) {
        // Cancelled as soon as the writer, and then as soon as the check begins to read.
        for (int reports = 0; reports < 2; ++reports) {
            int seen = 0;
            core::Progress* running = nullptr;
            core::Progress progress([&](core::ProgressStep, int done, int) {
                seen += done == 0 ? 1 : 0;
                if (seen > reports)
                    running->cancel();
            });
            running = &progress;
            core::ExportRequest request = on.request();
            request.format = format;
            request.file = on.folder.filePath(QStringLiteral("seg.nii"));
            const auto report = on.exported(request, progress);
            if (format == core::ExportFormat::Nifti && reports == 1)
                continue; // the sources are read once only
            QVERIFY(!report);
            QCOMPARE(report.error().code, core::ErrorCode::Cancelled);
            QCOMPARE(on.fileCount(), 0);
        }
    }
}

void ExportSegTest::uidsAreNewEachTime()
{
    const Fixture on;
    QStringList uids;
    for (int i = 0; i < 2; ++i) {
        core::ExportRequest request = on.request();
        request.file = on.folder.filePath(QStringLiteral("seg%1.dcm").arg(i));
        QVERIFY(on.exported(request));
        const auto seg = core::readSeg(request.file);
        QVERIFY(seg.has_value());
        uids << seg->sopInstanceUid << seg->seriesUid;
    }
    QCOMPARE(QSet<QString>(uids.begin(), uids.end()).size(), 4);
    for (const QString& uid : uids)
        QVERIFY(uid.startsWith(QStringLiteral("2.25.")) && uid.size() <= 64);
}

BURIN_TEST(ExportSegTest)

} // namespace exportSegTest

#include "ExportSegTest.moc"
