// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/NrrdFiles.h"
#include "tests/support/series/SyntheticSeries.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

namespace infoCommandTest {

namespace {

struct Output {
    int exitCode = -1;
    QByteArray out;
    QByteArray errors;
};

Output burin(const QStringList& arguments)
{
    QProcess process;
    process.start(QStringLiteral(BURIN_PROGRAM), arguments);
    process.waitForFinished(60000);
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

} // namespace

/// `burin info`: the JSON others build on, the text people read, one line where it fails.
class InfoCommandTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void jsonHoldsTheFacts();
    void filesOfOneVolume();
    void textNamesPatientAndProblems();
    void failuresAreOneLine();
};

void InfoCommandTest::jsonHoldsTheFacts()
{
    const QTemporaryDir folder;
    test::SyntheticSeries series;
    series.plane = {{0.0, 1.0, 0.0}, {0.0, 0.0, -1.0}};
    series.step = {-2.5, 0.0, 0.0};
    test::writeSeries(series, folder.path());
    const Output info = burin({QStringLiteral("info"), folder.path(), QStringLiteral("--json")});
    QCOMPARE(info.exitCode, 0);
    const QJsonArray studies =
        QJsonDocument::fromJson(info.out).object()[QStringLiteral("studies")].toArray();
    QCOMPARE(studies.size(), 1);
    QCOMPARE(studies[0][QStringLiteral("studyUid")].toString(), series.studyUid);
    const QJsonArray list = studies[0][QStringLiteral("series")].toArray();
    QCOMPARE(list.size(), 1);
    const QJsonObject facts = list[0].toObject();
    QStringList keys = facts.keys();
    QCOMPARE(keys.join(QLatin1Char(' ')),
        QStringLiteral(
            "description directionLps findings max min modality originLps problems seriesUid "
            "size spacingMm unit voxelsSha256"));
    const auto array = [&](const char* key) { return facts[QLatin1String(key)].toArray(); };
    QCOMPARE(facts[QStringLiteral("seriesUid")].toString(), series.seriesUid);
    QCOMPARE(facts[QStringLiteral("modality")].toString(), QStringLiteral("CT"));
    QCOMPARE(facts[QStringLiteral("description")].toString(), QStringLiteral("Made to order"));
    QCOMPARE(facts[QStringLiteral("unit")].toString(), QStringLiteral("HU"));
    QCOMPARE(array("size"), (QJsonArray{24, 18, 10}));
    QCOMPARE(array("spacingMm"), (QJsonArray{0.75, 1.25, 2.5}));
    QCOMPARE(array("originLps"), (QJsonArray{-9.0, -11.25, 40.0}));
    // Columns are the axes: i runs to posterior, j to inferior, k to the right.
    QCOMPARE(array("directionLps"), (QJsonArray{0, 0, -1, 1, 0, 0, 0, -1, 0}));
    QCOMPARE(facts[QStringLiteral("min")].toDouble(), -1024.0);
    QCOMPARE(facts[QStringLiteral("voxelsSha256")].toString().size(), 64);
    QVERIFY(array("problems").isEmpty());
}

void InfoCommandTest::filesOfOneVolume()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("head.nrrd"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(test::nrrd::soundFile());
    file.close();
    const Output info = burin({QStringLiteral("info"), path, QStringLiteral("--json")});
    QCOMPARE(info.exitCode, 0);
    const QJsonObject document = QJsonDocument::fromJson(info.out).object();
    const QJsonValue volume = document[QStringLiteral("studies")][0][QStringLiteral("series")][0];
    QCOMPARE(volume[QStringLiteral("seriesUid")].toString(), QStringLiteral("head.nrrd"));
    QCOMPARE(volume[QStringLiteral("size")].toArray(), (QJsonArray{5, 4, 3}));
    QCOMPARE(volume[QStringLiteral("spacingMm")].toArray(), (QJsonArray{1, 1, 2.5}));
    QCOMPARE(volume[QStringLiteral("originLps")].toArray(), (QJsonArray{-12, 34, 56.5}));
    QVERIFY(volume[QStringLiteral("problems")].toArray().isEmpty());

    QVERIFY(file.resize(file.size() - 1));
    const Output cut = burin({QStringLiteral("info"), path});
    QCOMPARE(cut.exitCode, 1);
    QCOMPARE(cut.errors,
        "burin: " + path.toUtf8() + ": the file is cut short: its voxels are incomplete\n");
}

void InfoCommandTest::textNamesPatientAndProblems()
{
    const QTemporaryDir folder;
    test::SyntheticSeries series;
    const QStringList files = test::writeSeries(series, folder.path());
    QVERIFY(QFile::remove(files[4]));
    const Output info = burin({QStringLiteral("info"), folder.path()});
    QCOMPARE(info.exitCode, 0);
    for (const char* expected : {"Synthetic^Subject", "SYN1", "1970-01-02", "2024-01-31",
             "24 × 18 × 9", "1 slice is missing: 1 between slices 4 and 5", "HU"})
        QVERIFY2(info.out.contains(expected), info.out.constData());
}

void InfoCommandTest::failuresAreOneLine()
{
    const Output nowhere = burin({QStringLiteral("info"), QStringLiteral("/no/such/place")});
    QCOMPARE(nowhere.exitCode, 1);
    QCOMPARE(nowhere.errors, QByteArray("burin: /no/such/place: no such file or folder\n"));
    QVERIFY(nowhere.out.isEmpty());
    const QTemporaryDir empty;
    const Output nothing = burin({QStringLiteral("info"), empty.path(), QStringLiteral("--json")});
    QCOMPARE(nothing.exitCode, 1);
    QCOMPARE(nothing.errors.count('\n'), 1);
    QVERIFY(nothing.errors.contains(empty.path().toUtf8()));
    // One volume of two that does not open: the other is told, and why the status is not 0.
    const QTemporaryDir two;
    const QByteArray packed = test::nrrd::gzipped(test::nrrd::storedAs<std::int16_t>(false));
    const QByteArray header =
        test::nrrd::start + test::nrrd::shape + test::nrrd::place + "encoding: gzip\n\n";
    for (const auto& [name, bytes] : {std::pair("sound.nrrd", test::nrrd::soundFile()),
             std::pair("torn.nrrd", header + packed.chopped(12))}) {
        QFile file(two.filePath(QLatin1String(name)));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
    }
    const Output one = burin({QStringLiteral("info"), two.path(), QStringLiteral("--json")});
    QCOMPARE(one.exitCode, 1);
    QVERIFY2(
        one.errors.count('\n') == 1 && one.errors.contains("torn.nrrd"), one.errors.constData());
    const QJsonValue told = QJsonDocument::fromJson(one.out).object()[QStringLiteral("studies")];
    QCOMPARE(told[0][QStringLiteral("series")].toArray().size(), 2);
    QCOMPARE(burin({QStringLiteral("info")}).exitCode, 2);
    QCOMPARE(burin({QStringLiteral("info"), QStringLiteral("--what")}).exitCode, 2);
}

BURIN_TEST(InfoCommandTest)

} // namespace infoCommandTest

#include "InfoCommandTest.moc"
