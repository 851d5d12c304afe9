// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/SegReader.h"
#include "core/export/ExportMask.h"
#include "tests/support/FileSizeLimit.h"
#include "tests/support/Python.h"
#include "tests/support/SmallSeries.h"

#include <glm/gtc/matrix_transform.hpp>

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <random>

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

QString sha256Of(const std::vector<std::uint8_t>& labels, int label)
{
    QByteArray mask(qsizetype(labels.size()), 0);
    for (std::size_t i = 0; i < labels.size(); ++i)
        mask[qsizetype(i)] = char(labels[i] == label);
    return QString::fromLatin1(QCryptographicHash::hash(mask, QCryptographicHash::Sha256).toHex());
}

QString messageOf(const core::Error& error)
{
    return QString::number(int(error.code)) + QLatin1Char(' ')
        + error.arguments.join(QStringLiteral(" | "));
}

} // namespace

class ExportSegTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void othersSeeTheSame_data();
    void othersSeeTheSame();
    void framesOfOneFile();
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

void ExportSegTest::othersSeeTheSame_data()
{
    QTest::addColumn<glm::ivec3>("size");
    QTest::addColumn<glm::dmat3>("directions");
    QTest::addColumn<glm::dvec3>("shear");
    QTest::addColumn<bool>("even");

    const glm::dmat3 supine(1.0);
    for (int columns = 8; columns < 16; ++columns)
        QTest::addRow("rows x columns mod 8 = %d", 9 * columns % 8)
            << glm::ivec3(columns, 9, 5) << supine << glm::dvec3(0) << true;
    QTest::newRow("one slice") << glm::ivec3(5, 3, 1) << supine << glm::dvec3(0) << true;
    const glm::dmat3 prone(-1, 0, 0, 0, -1, 0, 0, 0, 1);
    QTest::newRow("prone") << glm::ivec3(11, 7, 6) << prone << glm::dvec3(0) << true;
    const glm::dmat3 sagittal(0, 1, 0, 0, 0, -1, -1, 0, 0);
    QTest::newRow("sagittal") << glm::ivec3(11, 7, 6) << sagittal << glm::dvec3(0) << true;
    const glm::dmat3 oblique(
        glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1, 2, -0.5))));
    QTest::newRow("oblique") << glm::ivec3(11, 7, 6) << oblique << glm::dvec3(0) << true;
    QTest::newRow("tilted") << glm::ivec3(11, 7, 6) << supine << glm::dvec3(0, 0.8, 0) << true;
    QTest::newRow("uneven") << glm::ivec3(11, 7, 6) << supine << glm::dvec3(0) << false;
}

void ExportSegTest::othersSeeTheSame()
{
    QFETCH(glm::ivec3, size);
    QFETCH(glm::dmat3, directions);
    QFETCH(glm::dvec3, shear);
    QFETCH(bool, even);
    QTemporaryDir folder;
    test::SmallSeries series;
    series.size = size;
    series.rowDirection = directions[0];
    series.columnDirection = directions[1];
    series.placeEvenly({-40.25, -31.5, 812.125}, directions[2] * 2.5 + shear);
    if (!even)
        series.positions.back() += 3.0 * directions[2];
    const QString images = folder.filePath(QStringLiteral("images"));
    const core::Volume volume = series.write(images);
    const auto labels = randomLabels(size, 11);
    const std::vector<core::LabelPlaneView> planes{{.plane = 0, .labels = labels}};

    const QString file = folder.filePath(QStringLiteral("seg.dcm"));
    const std::vector<core::Segment> segments{segmentOf(1, skull), segmentOf(5, liver)};
    const auto report = core::exportMask(volume,
        {.format = core::ExportFormat::DicomSeg,
            .file = file,
            .segments = segments,
            .planes = planes},
        {});
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    QVERIFY(!report->written.isEmpty() && !report->checked.isEmpty());
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 1);

    const auto read = test::runScript(QStringLiteral("seg_facts.py"), {file, images});
    QVERIFY2(read.exitCode == 0, qPrintable(read.errors));
    const QJsonObject facts = QJsonDocument::fromJson(read.output).object();
    QCOMPARE(facts["sha256"].toArray(), (QJsonArray{sha256Of(labels, 1), sha256Of(labels, 5)}));
    QCOMPARE(facts["emptyFrames"].toInt(), 0);
    QCOMPARE(facts["frames"].toInt(), size.z > 1 ? (size.z - 1) + (size.z - 2) : 2);
    QCOMPARE(facts["overlap"].toString(), QStringLiteral("NO"));
    QCOMPARE(facts["patientName"].toString(), QStringLiteral("Müller^Jörg"));
    QCOMPARE(facts["frameOfReference"].toString(), volume.identity.frameOfReferenceUid);
    QCOMPARE(facts["referenced"].toInt(), size.z);
    QCOMPARE(facts["labels"].toArray()[0].toString(), QStringLiteral("Schädel 1"));
    QCOMPARE(facts["algorithms"].toArray()[0].toArray(),
        (QJsonArray{QStringLiteral("SEMIAUTOMATIC"), QStringLiteral("Burin")}));
    QCOMPARE(facts["codes"].toArray()[1].toArray(),
        (QJsonArray{QStringLiteral("SCT"), QStringLiteral("10200004"), QStringLiteral("Liver")}));
    // The published value of (0.2, 0.6, 1.0): DICOM.md, from DCMTK's own tool and by hand.
    QCOMPARE(facts["lab"].toArray()[0].toArray(), (QJsonArray{40801, 34472, 17791}));
    validate(file);
}

void ExportSegTest::framesOfOneFile()
{
    QTemporaryDir folder;
    test::SmallSeries series;
    series.placeEvenly({3, 4, 5}, {0, 0, 1.5});
    const core::Volume volume = series.writeMultiFrame(folder.filePath(QStringLiteral("images")));
    const auto labels = randomLabels(series.size, 1);
    const std::vector<core::LabelPlaneView> planes{{.plane = 0, .labels = labels}};
    const QString file = folder.filePath(QStringLiteral("seg.dcm"));
    const auto report = core::exportMask(
        volume, {.file = file, .segments = {segmentOf(1, skull)}, .planes = planes}, {});
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    validate(file);
    const auto seg = core::readSeg(file);
    QVERIFY(seg.has_value());
    QCOMPARE(seg->referencedSopUids.size(), 1);
    QCOMPARE(seg->frames.size(), std::size_t(series.size.z - 1));
    for (const core::SegFrame& frame : seg->frames) {
        const int k = (frame.referencedFrame + 2) % series.size.z;
        QCOMPARE(frame.plane.position.z, 5.0 + 1.5 * k);
    }
}

void ExportSegTest::planesOverlap()
{
    QTemporaryDir folder;
    test::SmallSeries series;
    series.placeEvenly({0, 0, 0}, {0, 0, 1});
    const QString images = folder.filePath(QStringLiteral("images"));
    const core::Volume volume = series.write(images);
    const auto first = randomLabels(series.size, 1);
    const auto second = randomLabels(series.size, 2);
    const std::vector<core::LabelPlaneView> planes{
        {.plane = 0, .labels = first}, {.plane = 1, .labels = second}};
    const QString file = folder.filePath(QStringLiteral("seg.dcm"));
    const core::ExportRequest request{.format = core::ExportFormat::DicomSeg,
        .file = file,
        .segments = {segmentOf(1, skull, 0), segmentOf(1, liver, 1)},
        .planes = planes};
    const auto report = core::exportMask(volume, request, {});
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    const auto read = test::runScript(QStringLiteral("seg_facts.py"), {file, images});
    QVERIFY2(read.exitCode == 0, qPrintable(read.errors));
    const QJsonObject facts = QJsonDocument::fromJson(read.output).object();
    QCOMPARE(facts["sha256"].toArray(), (QJsonArray{sha256Of(first, 1), sha256Of(second, 1)}));
    QCOMPARE(facts["overlap"].toString(), QStringLiteral("YES"));
    validate(file);
}

void ExportSegTest::emptySegmentIsLeftOutAndNamed()
{
    QTemporaryDir folder;
    test::SmallSeries series;
    series.placeEvenly({0, 0, 0}, {0, 0, 1});
    const core::Volume volume = series.write(folder.filePath(QStringLiteral("images")));
    const auto labels = randomLabels(series.size, 1);
    const std::vector<core::LabelPlaneView> planes{{.plane = 0, .labels = labels}};
    const QString file = folder.filePath(QStringLiteral("seg.dcm"));
    const auto report = core::exportMask(volume,
        {.file = file, .segments = {segmentOf(7, {}), segmentOf(2, liver)}, .planes = planes}, {});
    QVERIFY(report.has_value());
    QVERIFY(report->cautions.join(QLatin1Char(' ')).contains(QStringLiteral("Schädel 7")));
    const auto seg = core::readSeg(file);
    QVERIFY(seg.has_value());
    QCOMPARE(seg->segments.size(), std::size_t(1));
    QCOMPARE(seg->segments[0].number, 1);
    QCOMPARE(seg->segments[0].category.value, QStringLiteral("123037004"));
}

void ExportSegTest::nothingToExport()
{
    QTemporaryDir folder;
    test::SmallSeries series;
    series.placeEvenly({0, 0, 0}, {0, 0, 1});
    const core::Volume volume = series.write(folder.filePath(QStringLiteral("images")));
    const auto labels = randomLabels(series.size, 1);
    const std::vector<core::LabelPlaneView> planes{{.plane = 0, .labels = labels}};
    for (const std::vector<core::Segment>& segments :
        {std::vector<core::Segment>{}, std::vector<core::Segment>{segmentOf(9, skull)}}) {
        const auto report = core::exportMask(volume,
            {.file = folder.filePath(QStringLiteral("seg.dcm")),
                .segments = segments,
                .planes = planes},
            {});
        QVERIFY(!report);
        QCOMPARE(report.error().code, core::ErrorCode::NothingToExport);
    }
    QVERIFY(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).isEmpty());
}

void ExportSegTest::segmentWithoutCodeIsRefused()
{
    QTemporaryDir folder;
    test::SmallSeries series;
    series.placeEvenly({0, 0, 0}, {0, 0, 1});
    const core::Volume volume = series.write(folder.filePath(QStringLiteral("images")));
    const auto labels = randomLabels(series.size, 1);
    const std::vector<core::LabelPlaneView> planes{{.plane = 0, .labels = labels}};
    core::ExportRequest request{.file = folder.filePath(QStringLiteral("seg.dcm")),
        .segments = {segmentOf(1, skull), segmentOf(2, {})},
        .planes = planes};
    auto report = core::exportMask(volume, request, {});
    QVERIFY(!report);
    QCOMPARE(report.error().code, core::ErrorCode::SegmentNotCoded);
    QCOMPARE(report.error().arguments.value(0), QStringLiteral("Schädel 2"));
    request.segments[1].code = {.scheme = QStringLiteral("SCT"),
        .value = QStringLiteral("12345678901234567"),
        .meaning = QStringLiteral("Too long")};
    report = core::exportMask(volume, request, {});
    QVERIFY(!report);
    QCOMPARE(report.error().code, core::ErrorCode::InvalidField);
    QVERIFY(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).isEmpty());
}

void ExportSegTest::sourceWithoutUidsIsRefused()
{
    QTemporaryDir folder;
    test::SmallSeries series;
    series.placeEvenly({0, 0, 0}, {0, 0, 1});
    core::Volume volume = series.write(folder.filePath(QStringLiteral("images")));
    QVERIFY(core::dicomSegObstacle(volume).isEmpty());
    volume.sources[3].sopInstanceUid.clear();
    QVERIFY(core::dicomSegObstacle(volume).contains(QStringLiteral("NIfTI")));
    const auto labels = randomLabels(series.size, 1);
    const std::vector<core::LabelPlaneView> planes{{.plane = 0, .labels = labels}};
    const auto report = core::exportMask(volume,
        {.file = folder.filePath(QStringLiteral("seg.dcm")),
            .segments = {segmentOf(1, skull)},
            .planes = planes},
        {});
    QVERIFY(!report);
    QCOMPARE(report.error().code, core::ErrorCode::UnsupportedFormat);
    QVERIFY(report.error().arguments.value(1).contains(QStringLiteral("NIfTI")));
    volume.sourceFormat = QStringLiteral("NIfTI");
    volume.sources.clear();
    QVERIFY(!core::dicomSegObstacle(volume).isEmpty());
}

void ExportSegTest::sourceWithoutFrameOfReference()
{
    QTemporaryDir folder;
    test::SmallSeries series;
    series.frameOfReference = false;
    series.placeEvenly({0, 0, 0}, {0, 0, 1});
    const core::Volume volume = series.write(folder.filePath(QStringLiteral("images")));
    const auto labels = randomLabels(series.size, 1);
    const std::vector<core::LabelPlaneView> planes{{.plane = 0, .labels = labels}};
    const QString file = folder.filePath(QStringLiteral("seg.dcm"));
    const auto report = core::exportMask(
        volume, {.file = file, .segments = {segmentOf(1, skull)}, .planes = planes}, {});
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    validate(file);
}

void ExportSegTest::invalidSourceValuesAreNormalised()
{
    QTemporaryDir folder;
    test::SmallSeries series;
    series.sex = "male";
    series.studyDate = "2020.03.04";
    series.birthDate = "unknown";
    series.placeEvenly({0, 0, 0}, {0, 0, 1});
    const QString images = folder.filePath(QStringLiteral("images"));
    const core::Volume volume = series.write(images);
    const auto labels = randomLabels(series.size, 1);
    const std::vector<core::LabelPlaneView> planes{{.plane = 0, .labels = labels}};
    const QString file = folder.filePath(QStringLiteral("seg.dcm"));
    const auto report = core::exportMask(
        volume, {.file = file, .segments = {segmentOf(1, skull)}, .planes = planes}, {});
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    QVERIFY(report->cautions.join(QLatin1Char(' ')).contains(QStringLiteral("Birth Date")));
    const auto read = test::runScript(QStringLiteral("seg_facts.py"), {file, images});
    QVERIFY2(read.exitCode == 0, qPrintable(read.errors));
    QCOMPARE(QJsonDocument::fromJson(read.output)["patientSex"].toString(), QStringLiteral("M"));
    validate(file);
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
    QTemporaryDir folder;
    test::SmallSeries series;
    series.characterSet = characterSet.toStdString();
    series.patientName = stored.toStdString();
    series.placeEvenly({0, 0, 0}, {0, 0, 1});
    const core::Volume volume = series.write(folder.filePath(QStringLiteral("images")));
    const auto labels = randomLabels(series.size, 1);
    const std::vector<core::LabelPlaneView> planes{{.plane = 0, .labels = labels}};
    const QString file = folder.filePath(QStringLiteral("seg.dcm"));
    const auto report = core::exportMask(
        volume, {.file = file, .segments = {segmentOf(1, skull)}, .planes = planes}, {});
    QVERIFY2(report.has_value(), qPrintable(report ? QString() : messageOf(report.error())));
    const auto seg = core::readSeg(file);
    QVERIFY(seg.has_value());
    QCOMPARE(seg->patient.name, name);
    validate(file);
}

void ExportSegTest::existingFileIsRefused()
{
    QTemporaryDir folder;
    test::SmallSeries series;
    series.placeEvenly({0, 0, 0}, {0, 0, 1});
    const core::Volume volume = series.write(folder.filePath(QStringLiteral("images")));
    const auto labels = randomLabels(series.size, 1);
    const std::vector<core::LabelPlaneView> planes{{.plane = 0, .labels = labels}};
    QFile old(folder.filePath(QStringLiteral("seg.dcm")));
    QVERIFY(old.open(QIODevice::WriteOnly));
    old.write("kept");
    old.close();
    core::ExportRequest request{
        .file = old.fileName(), .segments = {segmentOf(1, skull)}, .planes = planes};
    const auto refused = core::exportMask(volume, request, {});
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, core::ErrorCode::FileExists);
    QCOMPARE(QFileInfo(old).size(), 4);
    request.force = true;
    QVERIFY(core::exportMask(volume, request, {}));
    QVERIFY(core::readSeg(old.fileName()));
}

void ExportSegTest::aFileOfTheStudyIsNeverReplaced()
{
    QTemporaryDir folder;
    test::SmallSeries series;
    series.placeEvenly({0, 0, 0}, {0, 0, 1});
    const core::Volume volume = series.write(folder.filePath(QStringLiteral("images")));
    const auto labels = randomLabels(series.size, 1);
    const std::vector<core::LabelPlaneView> planes{{.plane = 0, .labels = labels}};
    const QString source = volume.sources[2].file;
    const qint64 size = QFileInfo(source).size();
    const auto refused = core::exportMask(volume,
        {.file = source, .force = true, .segments = {segmentOf(1, skull)}, .planes = planes}, {});
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, core::ErrorCode::FileUnwritable);
    QCOMPARE(QFileInfo(source).size(), size);
}

void ExportSegTest::fullDiskLeavesNothing()
{
    QTemporaryDir folder;
    test::SmallSeries series;
    series.size = {64, 64, 8};
    series.placeEvenly({0, 0, 0}, {0, 0, 1});
    const core::Volume volume = series.write(folder.filePath(QStringLiteral("images")));
    const auto labels = randomLabels(series.size, 1);
    const std::vector<core::LabelPlaneView> planes{{.plane = 0, .labels = labels}};
    for (const auto format : {core::ExportFormat::DicomSeg, core::ExportFormat::Nifti}) {
        const bool seg = format == core::ExportFormat::DicomSeg;
        const QString file =
            folder.filePath(seg ? QStringLiteral("seg.dcm") : QStringLiteral("seg.nii.gz"));
        // A limit on the size of files is the full disk that a test can have.
        const test::FileSizeLimit limit(2048);
        const auto refused = core::exportMask(volume,
            {.format = format, .file = file, .segments = {segmentOf(1, skull)}, .planes = planes},
            {});
        QVERIFY(!refused);
        QVERIFY2(refused.error().code == core::ErrorCode::FileUnwritable,
            qPrintable(messageOf(refused.error())));
        QCOMPARE(refused.error().arguments.value(0), file);
    }
    QVERIFY(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).isEmpty());
}

void ExportSegTest::cancelledLeavesNothing()
{
    QTemporaryDir folder;
    test::SmallSeries series;
    series.placeEvenly({0, 0, 0}, {0, 0, 1});
    const core::Volume volume = series.write(folder.filePath(QStringLiteral("images")));
    const auto labels = randomLabels(series.size, 1);
    const std::vector<core::LabelPlaneView> planes{{.plane = 0, .labels = labels}};
    for (const auto format : {core::ExportFormat::DicomSeg, core::ExportFormat::Nifti}) {
        // Cancelled as soon as the writer, and then as soon as the check begins to read.
        for (int reports = 0; reports < 2; ++reports) {
            int seen = 0;
            core::Progress* running = nullptr;
            core::Progress progress([&](const QString&, int done, int) {
                seen += done == 0 ? 1 : 0;
                if (seen > reports)
                    running->cancel();
            });
            running = &progress;
            const auto report = core::exportMask(volume,
                {.format = format,
                    .file = folder.filePath(QStringLiteral("seg.nii")),
                    .segments = {segmentOf(1, skull)},
                    .planes = planes},
                progress);
            if (format == core::ExportFormat::Nifti && reports == 1)
                continue; // the sources are read once only
            QVERIFY(!report);
            QCOMPARE(report.error().code, core::ErrorCode::Cancelled);
            QVERIFY(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).isEmpty());
        }
    }
}

void ExportSegTest::uidsAreNewEachTime()
{
    QTemporaryDir folder;
    test::SmallSeries series;
    series.placeEvenly({0, 0, 0}, {0, 0, 1});
    const core::Volume volume = series.write(folder.filePath(QStringLiteral("images")));
    const auto labels = randomLabels(series.size, 1);
    const std::vector<core::LabelPlaneView> planes{{.plane = 0, .labels = labels}};
    QStringList uids;
    for (int i = 0; i < 2; ++i) {
        const QString file = folder.filePath(QStringLiteral("seg%1.dcm").arg(i));
        QVERIFY(core::exportMask(
            volume, {.file = file, .segments = {segmentOf(1, skull)}, .planes = planes}, {}));
        const auto seg = core::readSeg(file);
        QVERIFY(seg.has_value());
        uids << seg->sopInstanceUid << seg->seriesUid;
    }
    QCOMPARE(QSet<QString>(uids.begin(), uids.end()).size(), 4);
    for (const QString& uid : uids)
        QVERIFY(uid.startsWith(QStringLiteral("2.25.")) && uid.size() <= 64);
}

QTEST_GUILESS_MAIN(ExportSegTest)
#include "ExportSegTest.moc"
