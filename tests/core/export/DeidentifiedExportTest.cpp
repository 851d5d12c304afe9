// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/deidentify/Deidentifier.h"
#include "core/dicom/objects/RtStructFile.h"
#include "core/dicom/objects/SegReader.h"
#include "core/dicom/objects/SrReader.h"
#include "core/export/CarvedVolume.h"
#include "core/export/common/ExportMask.h"
#include "core/study/StudyLoader.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/MarkedSeries.h"
#include "tests/support/servers/Python.h"
#include "ui/texts/ReportTexts.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace deidentifiedExportTest {

using namespace core;

namespace {

QString messageOf(const Error& error)
{
    return error.arguments.join(QStringLiteral(" | "));
}

Segment segmentOf(int label, const char* name, const char* value, const char* meaning)
{
    Segment segment;
    segment.label = std::uint8_t(label);
    segment.name = QString::fromUtf8(name);
    segment.code = {.scheme = QStringLiteral("SCT"),
        .value = QLatin1String(value),
        .meaning = QLatin1String(meaning)};
    return segment;
}

QString valueIn(const QString& file, const DcmTagKey& tag)
{
    DcmFileFormat format;
    OFString value;
    if (format.loadFile(QFile::encodeName(file).constData()).good())
        format.getDataset()->findAndGetOFStringArray(tag, value);
    return QString::fromUtf8(value.c_str());
}

struct Marked {
    QTemporaryDir folder;
    LoadedVolume study;
    std::vector<std::uint8_t> labels;
    std::vector<std::uint8_t> coverage;
    std::vector<LabelPlaneView> planes;

    Marked()
    {
        const QString images = folder.filePath(QStringLiteral("MARKERPATH"));
        test::writeSeries(test::markedSeries(), images);
        Result<LoadedVolume> loaded = loadVolume(images);
        if (!loaded)
            qFatal("%s", qPrintable(messageOf(loaded.error())));
        study = *std::move(loaded);
        const std::size_t count = study.codes.size();
        labels.resize(count);
        coverage.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            labels[i] = i % 7 == 0 ? 1 : i % 11 == 0 ? 2 : 0;
            coverage[i] = i % 5 == 0 ? 200 : 30;
        }
        planes = {{.plane = 0, .labels = labels}};
        QDir(folder.path()).mkdir(QStringLiteral("out"));
    }
    [[nodiscard]] QString out(const QString& name) const
    {
        return folder.filePath(QStringLiteral("out/") + name);
    }
    [[nodiscard]] std::shared_ptr<const Deidentifier> by(
        const DeidentifyOptions& options = {}, const QByteArray& secret = "secret") const
    {
        return std::make_shared<Deidentifier>(options, study.volume.identity, secret);
    }
    [[nodiscard]] Result<ExportReport> write(ExportFormat format, const QString& name,
        const std::shared_ptr<const Deidentifier>& deidentifier, bool deflated = false) const
    {
        ExportRequest request{.format = format,
            .file = out(name),
            .force = true,
            .segments = {segmentOf(1, "Leber MARKERNAME", "10200004", "Liver"),
                segmentOf(2, "Otto: MARKERID", "64033007", "Kidney")},
            .planes = planes,
            .coverages = {{.label = 1,
                .layer = QStringLiteral("MARKERNAME's layer"),
                .coverage = coverage}},
            .codes = study.codes,
            .deidentifier = deidentifier};
        request.seg.deflated = deflated;
        return exportMask(study.volume, request, {});
    }
    [[nodiscard]] Result<ExportReport> carve(
        const QString& name, const std::shared_ptr<const Deidentifier>& deidentifier) const
    {
        return exportCarvedVolume(study.volume,
            {.target = out(name),
                .coverage = coverage,
                .codes = study.codes,
                .fill = -1000.0,
                .deidentifier = deidentifier},
            {});
    }
};

} // namespace

/// Exports that do not tell who the patient is.
class DeidentifiedExportTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void theSourceIsMarked();
    void noMarkerAnywhere_data();
    void noMarkerAnywhere();
    void whatIsKeptIsSaid();
    void oneMappingForAll();
    void namesAreCleaned();
    void japaneseNamesAreCleaned();
    void partsOfNamesAreCleaned_data();
    void partsOfNamesAreCleaned();
    void picturesWithTextAreRefused();
    void aNameThatWasLeftIsFound();
    void wordsOfTheStandardAreNoNames();
};

/// Somebody may be called as an attribute of DICOM is.
void DeidentifiedExportTest::wordsOfTheStandardAreNoNames()
{
    const Marked on;
    StudyIdentity somebody = on.study.volume.identity;
    somebody.patientName = QStringLiteral("Position^PATIENT");
    const auto by = std::make_shared<Deidentifier>(DeidentifyOptions{}, somebody, "secret");
    for (const ExportFormat format : {ExportFormat::DicomSeg, ExportFormat::DicomSegFractional,
             ExportFormat::DicomSegLabelMap, ExportFormat::RtStruct}) {
        const auto made = on.write(format, QStringLiteral("p.dcm"), by);
        QVERIFY2(made, qPrintable(made ? QString() : messageOf(made.error())));
    }
}

/// What the others look for can be found.
void DeidentifiedExportTest::theSourceIsMarked()
{
    const Marked on;
    const QByteArrayList found = test::markersIn(on.study.volume.sources.front().file);
    for (const char* marker :
        {"MARKERNAME", "MARKERID", "MARKERTEXT", "19330214", "2.25.77007700", "77.0770770"})
        QVERIFY2(found.contains(marker), marker);
    QVERIFY(on.write(ExportFormat::DicomSeg, QStringLiteral("named.dcm"), nullptr, true));
    const QByteArrayList named = test::markersIn(on.out(QStringLiteral("named.dcm")));
    QVERIFY2(named.contains("MARKERNAME") && named.contains("MARKERID")
            && named.contains("2.25.77007700"),
        named.join(' ').constData());
}

void DeidentifiedExportTest::noMarkerAnywhere_data()
{
    QTest::addColumn<bool>("keeping");
    QTest::newRow("nothing kept") << false;
    QTest::newRow("descriptions kept, dates shifted") << true;
}

void DeidentifiedExportTest::noMarkerAnywhere()
{
    QFETCH(bool, keeping);
    const Marked on;
    const auto by = on.by(
        {.dates = keeping ? DeidentifyOptions::Dates::Shift : DeidentifyOptions::Dates::Remove,
            .shiftDays = -77,
            .keepDescriptions = keeping});
    const std::initializer_list<std::pair<ExportFormat, const char*>> all{
        {ExportFormat::DicomSeg, "a.dcm"}, {ExportFormat::DicomSegFractional, "b.dcm"},
        {ExportFormat::DicomSegLabelMap, "c.dcm"}, {ExportFormat::RtStruct, "d.dcm"},
        {ExportFormat::Nifti, "e.nii.gz"}, {ExportFormat::SegNrrd, "f.seg.nrrd"},
        {ExportFormat::Stl, "g.stl"}, {ExportFormat::Obj, "h.obj"}, {ExportFormat::Ply, "i.ply"},
        {ExportFormat::Gltf, "j.glb"}, {ExportFormat::Csv, "k.csv"}, {ExportFormat::Json, "l.json"},
        {ExportFormat::Sr, "m.dcm"}};
    for (const auto& [format, name] : all) {
        const auto report = on.write(format, QLatin1String(name), by);
        QVERIFY2(report, qPrintable(report ? QString() : name + messageOf(report.error())));
        QVERIFY(
            ui::reportTexts(report->written).join(u' ').contains(QStringLiteral("De-identified")));
    }
    QVERIFY(on.write(ExportFormat::DicomSeg, QStringLiteral("z.dcm"), by, true));
    const auto carved = on.carve(QStringLiteral("series"), by);
    QVERIFY2(carved, qPrintable(carved ? QString() : messageOf(carved.error())));
    QVERIFY(ui::reportTexts(carved->cautions).join(u' ').contains(QStringLiteral("face")));

    QStringList files;
    for (const QString& folder : {on.out({}), on.out(QStringLiteral("series"))}) {
        for (const QFileInfo& file : QDir(folder).entryInfoList(QDir::Files | QDir::Hidden))
            files += file.filePath();
    }
    QVERIFY(files.size() >= 15 + 6);
    for (const QString& file : files) {
        QByteArrayList found = test::markersIn(file);
        // A description is text of the hospital: only the patient's own words are taken out of it.
        if (keeping)
            found.removeAll("MARKERTEXT");
        QVERIFY2(found.isEmpty(), (file.toUtf8() + ": " + found.join(' ')).constData());
        const bool isDicom = file.endsWith(QLatin1String(".dcm"));
        const bool judged = isDicom && !file.endsWith(QLatin1String("/c.dcm"))
            && !file.endsWith(QLatin1String("/z.dcm"))
            && !file.contains(QLatin1String("/series/")); // their source lacks what a CT must have
        if (!isDicom)
            continue;
        QCOMPARE(valueIn(file, DCM_PatientIdentityRemoved), QStringLiteral("YES"));
        QCOMPARE(valueIn(file, DCM_PatientID), by->patientId());
        QCOMPARE(valueIn(file, DCM_LongitudinalTemporalInformationModified),
            keeping ? QStringLiteral("MODIFIED") : QStringLiteral("REMOVED"));
        QCOMPARE(valueIn(file, DCM_StudyDate), keeping ? QStringLiteral("19321129") : QString());
        if (judged) {
            const auto valid = test::runProgram(QStringLiteral("dciodvfy"), {file});
            QVERIFY2(valid.exitCode == 0 && !valid.output.contains("Error"),
                (file.toUtf8() + "\n" + valid.output).constData());
        }
    }
}

void DeidentifiedExportTest::whatIsKeptIsSaid()
{
    const Marked on;
    QVERIFY(on.write(ExportFormat::DicomSeg, QStringLiteral("a.dcm"),
        on.by({.dates = DeidentifyOptions::Dates::Keep,
            .keepDevice = true,
            .keepDescriptions = true})));
    DcmFileFormat format;
    QVERIFY(format.loadFile(QFile::encodeName(on.out(QStringLiteral("a.dcm"))).constData()).good());
    QStringList codes;
    DcmItem* code = nullptr;
    for (long i = 0; format.getDataset()
                         ->findAndGetSequenceItem(DCM_DeidentificationMethodCodeSequence, code, i)
                         .good();
         ++i) {
        OFString value;
        code->findAndGetOFString(DCM_CodeValue, value);
        codes += QString::fromLatin1(value.c_str());
    }
    QCOMPARE(codes,
        (QStringList{QStringLiteral("113100"), QStringLiteral("113105"), QStringLiteral("113106"),
            QStringLiteral("113109")}));
    QCOMPARE(valueIn(on.out(QStringLiteral("a.dcm")), DCM_StudyDate), QStringLiteral("19330214"));
    QVERIFY(valueIn(on.out(QStringLiteral("a.dcm")), DCM_DeidentificationMethod)
                .contains(QStringLiteral("PS3.15 basic profile")));
    // The scanner stays where that was asked for.
    QVERIFY(on.carve(QStringLiteral("kept"), on.by({.keepDevice = true})));
    QCOMPARE(valueIn(on.out(QStringLiteral("kept/IM0001.dcm")), DCM_DeviceSerialNumber),
        QStringLiteral("MARKERDEV"));
    QCOMPARE(valueIn(on.out(QStringLiteral("kept/IM0001.dcm")), DCM_Manufacturer),
        QStringLiteral("Werk 7"));
}

void DeidentifiedExportTest::oneMappingForAll()
{
    const Marked on;
    const auto by = on.by();
    QVERIFY(on.write(ExportFormat::DicomSeg, QStringLiteral("a.dcm"), by));
    QVERIFY(on.write(ExportFormat::RtStruct, QStringLiteral("b.dcm"), by));
    QVERIFY(on.write(ExportFormat::Sr, QStringLiteral("c.dcm"), by));
    QVERIFY(on.carve(QStringLiteral("series"), by));
    const auto seg = readSeg(on.out(QStringLiteral("a.dcm")));
    const auto contours = readRtStruct(on.out(QStringLiteral("b.dcm")));
    const auto report = readSr(on.out(QStringLiteral("c.dcm")));
    QVERIFY(seg && contours && report);
    QCOMPARE(contours->studyUid, seg->studyUid);
    QCOMPARE(report->studyUid, seg->studyUid);
    QCOMPARE(contours->frameOfReferenceUid, seg->frameOfReferenceUid);
    QVERIFY(seg->studyUid.startsWith(QStringLiteral("2.25.")) && seg->studyUid.size() > 30);
    // The report's evidence is the SEG beside it and the images of this one.
    QVERIFY(report->evidence.contains(
        valueIn(on.out(QStringLiteral("c-seg.dcm")), DCM_SOPInstanceUID)));
    for (const QString& instance : seg->referencedSopUids)
        QVERIFY(report->evidence.contains(instance));
    const QString image = on.out(QStringLiteral("series/IM0003.dcm"));
    QCOMPARE(valueIn(image, DCM_StudyInstanceUID), seg->studyUid);
    QCOMPARE(valueIn(image, DCM_FrameOfReferenceUID), seg->frameOfReferenceUid);
    DcmFileFormat format;
    DcmItem* source = nullptr;
    OFString uid;
    QVERIFY(format.loadFile(QFile::encodeName(image).constData()).good());
    QVERIFY(format.getDataset()->findAndGetSequenceItem(DCM_SourceImageSequence, source).good());
    source->findAndGetOFString(DCM_ReferencedSOPInstanceUID, uid);
    QVERIFY(seg->referencedSopUids.contains(QString::fromLatin1(uid.c_str())));

    // The same secret: the same; another, or one that is drawn: others.
    QCOMPARE(on.by()->uid(QStringLiteral("2.25.7700770077001")), seg->studyUid);
    QVERIFY(on.by({}, "other")->uid(QStringLiteral("2.25.7700770077001")) != seg->studyUid);
    QVERIFY(on.by({}, {})->patientId() != on.by({}, {})->patientId());
    QCOMPARE(by->uid(QStringLiteral("1.2.840.10008.5.1.4.1.1.2")),
        QStringLiteral("1.2.840.10008.5.1.4.1.1.2"));
}

void DeidentifiedExportTest::namesAreCleaned()
{
    StudyIdentity patient;
    patient.patientName = QStringLiteral("Li^Wang=李^王");
    patient.patientId = QStringLiteral("P-0815");
    patient.birthDate = QStringLiteral("1950-01-02");
    const Deidentifier by({.keepDescriptions = true}, patient, "secret");
    // A name of two letters is taken out where it is a word, not out of others.
    QCOMPARE(
        by.cleanText(QStringLiteral("Liver of Li Wang, P-0815")), QStringLiteral("Liver of ,"));
    QCOMPARE(by.cleanText(QStringLiteral("born 19500102 / 1950-01-02")), QStringLiteral("born /"));
    QCOMPARE(by.segmentName(3, QStringLiteral("wang"), QString()), QStringLiteral("Segment 3"));
    QCOMPARE(
        by.segmentName(3, QStringLiteral("Leber 王 x"), QString()), QStringLiteral("Leber 王 x"));
    const Deidentifier strict({}, patient, "secret");
    QCOMPARE(strict.segmentName(1, QStringLiteral("Mine"), QStringLiteral("Liver")),
        QStringLiteral("Liver"));
    QCOMPARE(strict.date(QStringLiteral("20200101")), QString());
    const Deidentifier shifted(
        {.dates = DeidentifyOptions::Dates::Shift, .shiftDays = -1}, patient, "secret");
    QCOMPARE(shifted.date(QStringLiteral("20200301")), QStringLiteral("20200229"));
    QCOMPARE(shifted.date(QStringLiteral("nonsense")), QString());
}

/// In a character set that DCMTK cannot convert here, and without gaps between words.
void DeidentifiedExportTest::japaneseNamesAreCleaned()
{
    QTemporaryDir folder;
    test::SyntheticSeries series;
    series.adjust = [](DcmDataset& set, int) {
        set.putAndInsertString(DCM_SpecificCharacterSet, "\\ISO 2022 IR 87");
        set.putAndInsertString(DCM_PatientName, "Yamada^Tarou=\033$B;3ED\033(B^\033$BB@O:\033(B");
        set.putAndInsertString(DCM_SeriesDescription, "\033$B;3EDB@O:F,It\033(B CT");
        set.putAndInsertString(DCM_StudyDescription, "\033$BF,It\033(B \033$B;3ED\033(B");
    };
    test::writeSeries(series, folder.filePath(QStringLiteral("study")));
    const auto study = loadVolume(folder.filePath(QStringLiteral("study")));
    QVERIFY(study);
    const std::vector<std::uint8_t> coverage(study->codes.size(), 255);
    const auto by = std::make_shared<Deidentifier>(
        DeidentifyOptions{.keepDescriptions = true}, study->volume.identity);
    const auto made = exportCarvedVolume(study->volume,
        {.target = folder.filePath(QStringLiteral("out")),
            .coverage = coverage,
            .codes = study->codes,
            .fill = -1000.0,
            .deidentifier = by},
        {});
    QVERIFY2(made, qPrintable(made ? QString() : messageOf(made.error())));
    const QString image = folder.filePath(QStringLiteral("out/IM0001.dcm"));
    QCOMPARE(valueIn(image, DCM_SpecificCharacterSet), QStringLiteral("ISO_IR 192"));
    QCOMPARE(valueIn(image, DCM_SeriesDescription), QStringLiteral("頭部 CT CARVED"));
    QCOMPARE(valueIn(image, DCM_StudyDescription), QStringLiteral("頭部"));
    QCOMPARE(valueIn(image, DCM_PatientName), QStringLiteral("Anonymous"));

    // The check would find it, though it is short.
    DcmFileFormat format;
    QVERIFY(format.loadFile(QFile::encodeName(image).constData()).good());
    format.getDataset()->putAndInsertString(
        DCM_SeriesDescription, QStringLiteral("山田様頭部").toUtf8().constData());
    QVERIFY(format.saveFile(QFile::encodeName(image).constData()).good());
    QVERIFY(!checkDeidentified(image, *by));
}

void DeidentifiedExportTest::partsOfNamesAreCleaned_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("described");
    QTest::addColumn<QString>("cleaned");
    const auto row = [](const char* what, const char* name, const char* described,
                         const char* cleaned) {
        QTest::newRow(what) << QString::fromUtf8(name) << QString::fromUtf8(described)
                            << QString::fromUtf8(cleaned);
    };
    row("half of a double name", "MUELLER-SCHMIDT^ANNA", "Abdomen Schmidt", "Abdomen");
    row("all of it", "MUELLER-SCHMIDT^ANNA", "Abdomen Mueller-Schmidt", "Abdomen");
    row("behind an apostrophe", "O'Neill^Ann", "Neill, abdomen", ", abdomen");
    row("a short part stays", "Al-Sayed^Omar", "Kidney al", "Kidney al");
    row("characters of one name each", "Wang^Wei=王^伟", "王伟 头部", "头部");
    row("without a gap behind it", "Wang^Wei=王^伟", "王伟头部", "头部");
}

/// People write less of a name than stands in a header, or more of it in one word.
void DeidentifiedExportTest::partsOfNamesAreCleaned()
{
    QFETCH(QString, name);
    QFETCH(QString, described);
    QFETCH(QString, cleaned);
    QTemporaryDir folder;
    test::SyntheticSeries series;
    series.size = {16, 12, 3};
    series.adjust = [&](DcmDataset& set, int) {
        set.putAndInsertString(DCM_SpecificCharacterSet, "ISO_IR 192");
        set.putAndInsertString(DCM_PatientName, name.toUtf8().constData());
        set.putAndInsertString(DCM_SeriesDescription, described.toUtf8().constData());
    };
    test::writeSeries(series, folder.filePath(QStringLiteral("study")));
    const auto study = loadVolume(folder.filePath(QStringLiteral("study")));
    QVERIFY(study);
    QCOMPARE(study->volume.identity.patientName, name);
    const std::vector<std::uint8_t> coverage(study->codes.size(), 255);
    const auto by = std::make_shared<Deidentifier>(
        DeidentifyOptions{.keepDescriptions = true}, study->volume.identity);
    const auto made = exportCarvedVolume(study->volume,
        {.target = folder.filePath(QStringLiteral("out")),
            .coverage = coverage,
            .codes = study->codes,
            .fill = -1000.0,
            .deidentifier = by},
        {});
    QVERIFY2(made, qPrintable(made ? QString() : messageOf(made.error())));
    QCOMPARE(valueIn(folder.filePath(QStringLiteral("out/IM0001.dcm")), DCM_SeriesDescription),
        cleaned + QStringLiteral(" CARVED"));
    // Numbers are no names: a part of one is any number.
    StudyIdentity numbered;
    numbered.patientId = QStringLiteral("CASE-4711-LIVER");
    QCOMPARE(Deidentifier({}, numbered).cleanText(QStringLiteral("Liver 4711")),
        QStringLiteral("Liver 4711"));
}

void DeidentifiedExportTest::picturesWithTextAreRefused()
{
    QTemporaryDir folder;
    test::SyntheticSeries series = test::markedSeries();
    const auto mark = series.adjust;
    series.adjust = [mark](DcmDataset& set, int k) {
        mark(set, k);
        set.putAndInsertString(DCM_BurnedInAnnotation, "YES");
    };
    test::writeSeries(series, folder.filePath(QStringLiteral("study")));
    const auto study = loadVolume(folder.filePath(QStringLiteral("study")));
    QVERIFY(study);
    const std::vector<std::uint8_t> coverage(study->codes.size(), 255);
    CarvedRequest request{.target = folder.filePath(QStringLiteral("out")),
        .coverage = coverage,
        .codes = study->codes,
        .fill = -1000.0,
        .deidentifier =
            std::make_shared<Deidentifier>(DeidentifyOptions(), study->volume.identity)};
    const auto made = exportCarvedVolume(study->volume, request, {});
    QVERIFY(!made);
    QCOMPARE(made.error().code, ErrorCode::UnsupportedFormat);
    QVERIFY(!QDir(request.target).exists());
}

void DeidentifiedExportTest::aNameThatWasLeftIsFound()
{
    const Marked on;
    const auto by = on.by();
    QVERIFY(on.write(ExportFormat::DicomSeg, QStringLiteral("a.dcm"), by));
    const QString file = on.out(QStringLiteral("a.dcm"));
    QVERIFY(checkDeidentified(file, *by));
    for (const auto& [tag, value] : {std::pair(DCM_SeriesDescription, "Kopf MARKERNAME"),
             std::pair(DCM_StudyInstanceUID, "2.25.7700770077001")}) {
        DcmFileFormat format;
        QVERIFY(format.loadFile(QFile::encodeName(file).constData()).good());
        format.getDataset()->putAndInsertString(tag, value);
        const QString changed = on.out(QStringLiteral("changed.dcm"));
        QVERIFY(format.saveFile(QFile::encodeName(changed).constData()).good());
        const auto checked = checkDeidentified(changed, *by);
        QVERIFY(!checked);
        QCOMPARE(checked.error().code, ErrorCode::ExportMismatch);
    }
}

BURIN_TEST(DeidentifiedExportTest)

} // namespace deidentifiedExportTest

#include "DeidentifiedExportTest.moc"
