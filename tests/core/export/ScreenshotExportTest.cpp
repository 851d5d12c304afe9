// SPDX-License-Identifier: Apache-2.0
#include "core/export/ScreenshotExport.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/SmallSeries.h"
#include "tests/support/servers/Python.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

namespace screenshotExportTest {

/// Pictures of the window as DICOM Secondary Capture.
class ScreenshotExportTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void othersSeeThePicture();
    void noPatientNoPicture();
    void existingFileIsRefused();
    void onlyPicturesAreReplaced();
};

namespace {

struct Shown {
    QTemporaryDir folder;
    QString file = folder.filePath(QStringLiteral("shot.dcm"));
    core::Volume volume;
    std::vector<std::uint8_t> rgb; // of an odd number of bytes

    Shown()
    {
        test::SmallSeries series;
        series.placeEvenly({0, 0, 0}, {0, 0, 1});
        volume = series.write(folder.filePath(QStringLiteral("images")));
        for (int i = 0; i < 13 * 7 * 3; ++i)
            rgb.push_back(std::uint8_t(i * 37));
    }
    [[nodiscard]] core::Result<core::ExportReport> taken(bool showsPatient = true) const
    {
        return core::exportScreenshot(volume,
            {.file = file,
                .picture = {.width = 13, .height = 7, .rgb = rgb, .showsPatient = showsPatient}},
            {});
    }
};

} // namespace

void ScreenshotExportTest::othersSeeThePicture()
{
    const Shown on;
    const auto report = on.taken();
    QVERIFY2(report, qPrintable(report ? QString() : report.error().arguments.join(u'|')));
    QCOMPARE(report->sha256.size(), 64);
    const auto valid = test::runProgram(QStringLiteral("dciodvfy"), {on.file});
    QVERIFY2(valid.exitCode == 0 && !valid.output.contains("Error"), valid.output.constData());
    const auto read = test::runScript(QStringLiteral("picture_facts.py"), {on.file});
    QVERIFY2(read.exitCode == 0, qPrintable(read.errors));
    const QJsonObject facts = QJsonDocument::fromJson(read.output).object();
    QCOMPARE(facts["patientName"].toString(), QStringLiteral("Müller^Jörg"));
    QCOMPARE(facts["study"].toString(), on.volume.identity.studyUid);
    QVERIFY(facts["series"].toString() != on.volume.identity.seriesUid);
    QCOMPARE(facts["burnedIn"].toString(), QStringLiteral("YES"));
    QCOMPARE(facts["shape"].toArray(), (QJsonArray{7, 13, 3}));
    const QByteArray pixels = QByteArray::fromBase64(facts["pixels"].toString().toLatin1());
    QCOMPARE(
        pixels, QByteArray(reinterpret_cast<const char*>(on.rgb.data()), qsizetype(on.rgb.size())));
}

void ScreenshotExportTest::noPatientNoPicture()
{
    Shown on;
    on.volume.sourceFormat = QStringLiteral("NIfTI");
    const auto report = on.taken();
    QVERIFY(!report);
    QCOMPARE(report.error().code, core::ErrorCode::UnsupportedFormat);
    QVERIFY(!QFile::exists(on.file));
}

void ScreenshotExportTest::existingFileIsRefused()
{
    const Shown on;
    QVERIFY(on.taken(false));
    const auto again = on.taken();
    QVERIFY(!again);
    QCOMPARE(again.error().code, core::ErrorCode::FileExists);
}

void ScreenshotExportTest::onlyPicturesAreReplaced()
{
    const Shown on;
    QVERIFY(on.taken());
    const auto file = [&on](const char* name, const QByteArray& content) {
        const QString path = on.folder.filePath(QString::fromLatin1(name));
        QFile written(path);
        if (!written.open(QIODevice::WriteOnly) || written.write(content) != content.size())
            qFatal("cannot write %s", name);
        return path;
    };
    const QByteArray png("\x89PNG\r\n\x1a\n and more");
    for (const QString& good : {on.folder.filePath(QStringLiteral("free.png")),
             on.folder.filePath(QStringLiteral("free.dcm")), on.file, file("a.png", png),
             file("empty.png", {}), file("empty.DCM", {})})
        QVERIFY2(core::checkPictureTarget(good), qPrintable(good));
    const QDir images(on.folder.filePath(QStringLiteral("images")));
    const QString slice = images.filePath(images.entryList(QDir::Files).value(0));
    QVERIFY(QFile::exists(slice));
    for (const QString& bad :
        {file("text.png", "text"), file("a.burin", "SQLite format 3"), file("b.dcm", png), slice,
            on.folder.path(), on.folder.filePath(QStringLiteral("no/such/folder.png"))}) {
        const auto fits = core::checkPictureTarget(bad);
        QVERIFY2(!fits, qPrintable(bad));
        QCOMPARE(fits.error().code, core::ErrorCode::FileUnwritable);
        QCOMPARE(fits.error().arguments.value(0), bad);
    }
}

BURIN_TEST(ScreenshotExportTest)

} // namespace screenshotExportTest

#include "ScreenshotExportTest.moc"
