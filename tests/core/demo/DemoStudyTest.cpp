// SPDX-License-Identifier: Apache-2.0
#include "core/demo/DemoStudy.h"
#include "core/demo/HeadPhantom.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

namespace demoStudyTest {

/// The demonstration study is a plausible head, the same each time, and valid DICOM.
class DemoStudyTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init() { test::failOnUnexpectedMessages(); }
    void partHasItsDensityAndVolume_data();
    void partHasItsDensityAndVolume();
    void noiseIsThatOfAScanner();
    void sameVoxelsEveryTime();
    void writesValidDicomWithTruth();
    void refusesAFolderWithFiles();
    void cancelLeavesNothing();

private:
    core::DemoStudy m_study;
};

void DemoStudyTest::initTestCase()
{
    auto study = core::makeDemoStudy({});
    QVERIFY(study.has_value());
    m_study = std::move(*study);
    QCOMPARE(m_study.geometry.size.x, 256);
    QCOMPARE(m_study.geometry.size.y, 256);
    QCOMPARE(m_study.geometry.size.z, 200);
    QCOMPARE(m_study.hounsfield.size(), m_study.geometry.voxelCount());
    QCOMPARE(m_study.parts.size(), m_study.geometry.voxelCount());
}

void DemoStudyTest::partHasItsDensityAndVolume_data()
{
    using core::HeadPart;
    QTest::addColumn<int>("part");
    QTest::addColumn<double>("lowestMean"); // HU
    QTest::addColumn<double>("highestMean");
    QTest::addColumn<double>("leastMl");
    QTest::addColumn<double>("mostMl");
    const auto row = [](const char* name, HeadPart part, double low, double high, double least,
                         double most) {
        QTest::newRow(name) << static_cast<int>(part) << low << high << least << most;
    };
    // Partial volume pulls thin parts towards their neighbours.
    row("air", HeadPart::Air, -1001, -985, 4000, 8000);
    row("skin", HeadPart::Skin, -250, 60, 100, 500);
    row("fat", HeadPart::Fat, -110, -60, 150, 900);
    row("muscle", HeadPart::Muscle, 30, 90, 300, 1300);
    row("skull", HeadPart::Skull, 500, 1200, 350, 900);
    row("mandible", HeadPart::Mandible, 400, 1200, 15, 90);
    row("teeth", HeadPart::Teeth, 1200, 2400, 5, 45);
    row("vertebrae", HeadPart::Vertebrae, 400, 1100, 10, 90);
    row("airway", HeadPart::Airway, -1000, -600, 30, 200);
    row("eyes", HeadPart::Eye, 5, 50, 11, 20);
    row("cortex", HeadPart::GreyMatter, 30, 45, 300, 800);
    row("white matter", HeadPart::WhiteMatter, 25, 33, 250, 800);
    row("ventricles", HeadPart::Ventricles, 5, 20, 10, 45);
    row("fluid", HeadPart::Fluid, 5, 40, 80, 400);
    row("cerebellum", HeadPart::Cerebellum, 28, 42, 70, 180);
    row("vessels", HeadPart::Vessels, 180, 300, 8, 60);
}

void DemoStudyTest::partHasItsDensityAndVolume()
{
    QFETCH(int, part);
    QFETCH(double, lowestMean);
    QFETCH(double, highestMean);
    QFETCH(double, leastMl);
    QFETCH(double, mostMl);
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < m_study.parts.size(); ++i) {
        if (m_study.parts[i] != part)
            continue;
        sum += m_study.hounsfield[i];
        ++count;
    }
    const double ml = count * m_study.geometry.voxelVolumeMm3() / 1000.0;
    const double mean = sum / count;
    QVERIFY2(ml >= leastMl && ml <= mostMl, qPrintable(QString::number(ml)));
    QVERIFY2(mean >= lowestMean && mean <= highestMean, qPrintable(QString::number(mean)));
}

void DemoStudyTest::noiseIsThatOfAScanner()
{
    // The corner is air: nothing but noise, neither periodic nor clipped on one side only.
    double sum = 0.0;
    double squares = 0.0;
    constexpr int side = 24;
    for (int k = 0; k < side; ++k) {
        for (int j = 0; j < side; ++j) {
            for (int i = 0; i < side; ++i) {
                const double value =
                    m_study.hounsfield[static_cast<std::size_t>(i + 256 * (j + 256 * k))] + 1000.0;
                sum += value;
                squares += value * value;
            }
        }
    }
    const double count = side * side * side;
    QVERIFY(std::abs(sum / count) < 0.3);
    const double deviation = std::sqrt(squares / count);
    QVERIFY2(deviation > 3.0 && deviation < 9.0, qPrintable(QString::number(deviation)));
}

void DemoStudyTest::sameVoxelsEveryTime()
{
    const auto again = core::makeDemoStudy({});
    QVERIFY(again.has_value());
    QVERIFY(again->hounsfield == m_study.hounsfield);
    QVERIFY(again->parts == m_study.parts);
}

void DemoStudyTest::writesValidDicomWithTruth()
{
    const QTemporaryDir parent;
    const QString folder = parent.filePath(QStringLiteral("demo häd"));
    QVERIFY(core::writeDemoStudy(folder, m_study).has_value());
    const QDir dir(folder);
    QCOMPARE(dir.entryList({QStringLiteral("CT*.dcm")}).size(), 200);
    QVERIFY(dir.exists(QStringLiteral("labels.nii.gz")));
    QFile names(dir.filePath(QStringLiteral("labels.txt")));
    QVERIFY(names.open(QIODevice::ReadOnly));
    QVERIFY(names.readAll().contains("\n4 Skull\n"));
    QCOMPARE(QDir(parent.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot).size(), 1);

    QProcess check;
    check.start(QStringLiteral("dciodvfy"), {dir.filePath(QStringLiteral("CT0123.dcm"))});
    QVERIFY2(check.waitForFinished(), "dciodvfy (package dicom3tools) did not run");
    const QByteArray said = check.readAllStandardError();
    QVERIFY2(!said.contains("Error"), said.constData());
    QCOMPARE(check.exitCode(), 0);
}

void DemoStudyTest::refusesAFolderWithFiles()
{
    const QTemporaryDir parent;
    QFile file(parent.filePath(QStringLiteral("mine.txt")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.close();
    const auto written = core::writeDemoStudy(parent.path(), m_study);
    QVERIFY(!written.has_value());
    QCOMPARE(written.error().code, core::ErrorCode::FileUnwritable);
    QCOMPARE(QDir(parent.path()).entryList(QDir::Files), QStringList{QStringLiteral("mine.txt")});
}

void DemoStudyTest::cancelLeavesNothing()
{
    core::Progress progress;
    progress.cancel();
    const auto study = core::makeDemoStudy(progress);
    QVERIFY(!study.has_value());
    QCOMPARE(study.error().code, core::ErrorCode::Cancelled);
}

BURIN_TEST(DemoStudyTest)

} // namespace demoStudyTest

#include "DemoStudyTest.moc"
