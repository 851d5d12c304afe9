// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/objects/SegReader.h"
#include "core/export/ScreenshotExport.h"
#include "core/export/common/ExportMask.h"
#include "core/study/StudyLoader.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SyntheticSeries.h"
#include "tests/support/servers/Python.h"
#include "ui/texts/ReportTexts.h"

#include <QTemporaryDir>
#include <QTest>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace unwritablePatientTest {

using namespace core;

namespace {

QString messageOf(const Error& error)
{
    return error.arguments.join(QStringLiteral(" | "));
}

} // namespace

/// Names and IDs that DICOM cannot hold, which scanners write all the same.
class UnwritablePatientTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void everyObjectIsWritten_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("id");
        QTest::addColumn<QString>("keptName");
        QTest::addColumn<QString>("keptId");
        QTest::addColumn<bool>("leftOut");
        const QByteArray plain("Doe^Jane");
        const QByteArray number("P-1");
        const QByteArray tooLong(70, 'x');
        const QString kept = QStringLiteral("Doe^Jane");
        const QString keptNumber = QStringLiteral("P-1");
        QTest::newRow("six components")
            << QByteArray("A^B^C^D^E^F") << number << QString() << keptNumber << true;
        QTest::newRow("a long name") << tooLong << number << QString() << keptNumber << true;
        QTest::newRow("four groups")
            << QByteArray("A=B=C=D") << number << QString() << keptNumber << true;
        QTest::newRow("a backslash in the name")
            << QByteArray("Doe\\Jane") << number << QStringLiteral("DoeJane") << keptNumber
            << false;
        QTest::newRow("a long ID") << plain << tooLong << kept << QString() << true;
        QTest::newRow("a backslash in the ID")
            << plain << QByteArray("P\\1") << kept << QStringLiteral("P1") << false;
    }
    void everyObjectIsWritten()
    {
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, id);
        QFETCH(QString, keptName);
        QFETCH(QString, keptId);
        QFETCH(bool, leftOut);
        QTemporaryDir folder;
        test::SyntheticSeries series;
        series.adjust = [&](DcmDataset& set, int) {
            set.putAndInsertString(DCM_PatientName, name.constData());
            set.putAndInsertString(DCM_PatientID, id.constData());
        };
        test::writeSeries(series, folder.filePath(QStringLiteral("study")));
        const Result<LoadedVolume> study = loadVolume(folder.filePath(QStringLiteral("study")));
        QVERIFY2(study, qPrintable(study ? QString() : messageOf(study.error())));
        std::vector<std::uint8_t> labels(study->codes.size(), 0);
        for (std::size_t i = 0; i < labels.size(); ++i)
            labels[i] = i % 24 > 5 && i % 24 < 17 ? 1 : 0;
        Segment segment;
        segment.label = 1;
        segment.name = QStringLiteral("Liver");
        segment.code = {.scheme = QStringLiteral("SCT"),
            .value = QStringLiteral("10200004"),
            .meaning = QStringLiteral("Liver")};
        const std::vector<LabelPlaneView> planes{{.plane = 0, .labels = labels}};
        for (const ExportFormat format : {ExportFormat::DicomSeg, ExportFormat::DicomSegLabelMap,
                 ExportFormat::RtStruct, ExportFormat::Sr}) {
            const QString file = folder.filePath(QStringLiteral("%1.dcm").arg(int(format)));
            const auto report = exportMask(study->volume,
                {.format = format,
                    .file = file,
                    .segments = {segment},
                    .planes = planes,
                    .codes = study->codes},
                {});
            QVERIFY2(report, qPrintable(report ? QString() : messageOf(report.error())));
            const QString cautions = ui::reportTexts(report->cautions).join(u' ');
            QVERIFY2(cautions.contains(
                         leftOut ? QStringLiteral("left out") : QStringLiteral("as DICOM has it")),
                qPrintable(cautions));
            if (format != ExportFormat::DicomSeg)
                continue;
            const auto seg = readSeg(file);
            QVERIFY(seg);
            QCOMPARE(seg->patient.name, keptName);
            QCOMPARE(seg->patient.id, keptId);
        }
        const std::vector<std::uint8_t> rgb(12, 7);
        const auto picture = exportScreenshot(study->volume,
            {.file = folder.filePath(QStringLiteral("shot.dcm")),
                .picture = {.width = 2, .height = 2, .rgb = rgb, .showsPatient = false}},
            {});
        QVERIFY2(picture, qPrintable(picture ? QString() : messageOf(picture.error())));
    }
};

BURIN_TEST(UnwritablePatientTest)

} // namespace unwritablePatientTest

#include "UnwritablePatientTest.moc"
