// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/base/DicomFile.h"
#include "core/dicom/header/ImageHeaderReader.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SharedData.h"
#include "tests/support/series/SyntheticSeries.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <QDirIterator>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

namespace honestHeadersTest {

/// The check before DCMTK refuses no honest file and costs little.
class HonestHeadersTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void honestFilesPass();
    void costOfAHeader();

private:
    QTemporaryDir m_folder;
};

/// What DCMTK reads by itself must not be refused. That it opens more than DCMTK is welcome.
void HonestHeadersTest::honestFilesPass()
{
    if (test::sharedDataFolder().isEmpty())
        QSKIP("the shared data are not there (BURIN_SHARED_DATA)");
    int dicoms = 0;
    const QStringList cases =
        QDir(test::sharedDataFolder()).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
    for (const QString& name : cases) {
        const test::SharedCase data = test::sharedCase(name);
        for (const QString& root : {data.source, data.unpacked}) {
            if (root.isEmpty())
                continue;
            QDirIterator files(root, QDir::Files, QDirIterator::Subdirectories);
            while (files.hasNext()) {
                const QString file = files.next();
                DcmFileFormat format;
                const bool read =
                    format
                        .loadFileUntilTag(QFile::encodeName(file).constData(), EXS_Unknown,
                            EGL_noChange, 1024, ERM_autoDetect, DCM_PixelData)
                        .good()
                    && format.getDataset()->tagExists(DCM_SOPClassUID);
                if (!read)
                    continue;
                ++dicoms;
                const core::Result<core::ImageHeader> header = core::readImageHeader(file);
                if (!header)
                    qWarning("%s: %s", qPrintable(file),
                        qPrintable(header.error().arguments.join(QLatin1Char(' '))));
                QVERIFY2(header, qPrintable(file));
                OFString uid;
                format.getDataset()->findAndGetOFString(DCM_SOPInstanceUID, uid);
                QCOMPARE(header->sopInstanceUid, QString::fromLatin1(uid.c_str()));
            }
        }
    }
    qInfo("%d DICOM files", dicoms);
    QVERIFY(dicoms > 100);
}

void HonestHeadersTest::costOfAHeader()
{
    test::SyntheticSeries series;
    series.size = {256, 256, 1};
    const QString file =
        test::writeSeries(series, m_folder.filePath(QStringLiteral("cost"))).front();
    QFile whole(file);
    QVERIFY(whole.open(QIODevice::ReadOnly));
    const QByteArray bytes = whole.readAll();
    const int rounds = test::longRun() ? 20'000 : 500;
    QElapsedTimer timer;
    timer.start();
    for (int round = 0; round < rounds; ++round) {
        DcmFileFormat format;
        QVERIFY(format
                    .loadFileUntilTag(QFile::encodeName(file).constData(), EXS_Unknown,
                        EGL_noChange, 1024, ERM_autoDetect, DCM_PixelData)
                    .good());
    }
    const qint64 byDcmtk = timer.nsecsElapsed();
    timer.start();
    for (int round = 0; round < rounds; ++round)
        QVERIFY(core::DicomFile::open(file));
    const qint64 open = timer.nsecsElapsed();
    const qsizetype at = bytes.indexOf(QByteArray("\x08\x00\x08\x00"
                                                  "CS",
        6));
    const core::DicomBytes dataSet(reinterpret_cast<const std::uint8_t*>(bytes.constData()) + at,
        std::size_t(bytes.size() - at));
    timer.start();
    for (int round = 0; round < rounds; ++round)
        QVERIFY(core::preflight(dataSet, {}, file));
    const qint64 walk = timer.nsecsElapsed();
    // Printed only: no time decides.
    qInfo("per header: DCMTK %.1f us, opened and checked %.1f us, of that the walk %.2f us",
        double(byDcmtk) / rounds / 1e3, double(open) / rounds / 1e3, double(walk) / rounds / 1e3);
}

BURIN_TEST(HonestHeadersTest)

} // namespace honestHeadersTest

#include "HonestHeadersTest.moc"
