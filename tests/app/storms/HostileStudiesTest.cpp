// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/defective/HostileStudy.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

namespace hostileStudiesTest {

namespace {

constexpr double longestSeconds = 10.0;

void store(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("cannot write %s", qPrintable(path));
}

/// Slices of the honest series, as `burin info --json` has it; 0: it is not there.
int honestSlicesIn(const QByteArray& json)
{
    const QJsonObject all = QJsonDocument::fromJson(json).object();
    for (const QJsonValue& study : all[QStringLiteral("studies")].toArray()) {
        for (const QJsonValue& series : study[QStringLiteral("series")].toArray()) {
            if (series[QStringLiteral("seriesUid")].toString() == test::honestSeriesUid())
                return series[QStringLiteral("size")][2].toInt();
        }
    }
    return 0;
}

} // namespace

/// `burin info` on every hostile file: no crash, no hang, no more than twice the memory that an
/// honest study takes, and the study beside it is whole.
class HostileStudiesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void alone_data() { addFiles(); }
    void alone();
    void besideAStudy_data() { addFiles(); }
    void besideAStudy();

private:
    static void addFiles();
    void check(const test::WatchedRun& run) const;

    long m_honestKb = 0;
};

void HostileStudiesTest::initTestCase()
{
    const QTemporaryDir folder;
    test::writeHonestSeries(folder.path());
    const test::WatchedRun run =
        test::watchedBurin({QStringLiteral("info"), folder.path(), QStringLiteral("--json")});
    QCOMPARE(run.status, 0);
    QCOMPARE(honestSlicesIn(run.output), test::honestSlices);
    m_honestKb = run.peakKb;
    QVERIFY(m_honestKb > 0);
}

void HostileStudiesTest::addFiles()
{
    QTest::addColumn<QByteArray>("bytes");
    for (const test::HostileFile& file : test::hostileFiles())
        QTest::newRow(qPrintable(file.name)) << file.bytes;
}

void HostileStudiesTest::check(const test::WatchedRun& run) const
{
    QVERIFY2(!run.hung, qPrintable(run.complaint));
    QVERIFY2(run.status >= 0, qPrintable(run.complaint));
    QVERIFY2(run.cpuSeconds < longestSeconds, qPrintable(QString::number(run.cpuSeconds)));
    QVERIFY2(run.peakKb <= 2 * m_honestKb,
        qPrintable(QStringLiteral("%1 KB, %2 KB are honest").arg(run.peakKb).arg(m_honestKb)));
}

void HostileStudiesTest::alone()
{
    QFETCH(QByteArray, bytes);
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("hostile.dcm"));
    store(file, bytes);
    const test::WatchedRun run = test::watchedBurin({QStringLiteral("info"), file});
    check(run);
    QVERIFY2(run.status != 0 || !run.output.isEmpty(), "neither a volume nor a reason");
    QVERIFY(!run.output.isEmpty() || run.complaint.count(QLatin1Char('\n')) == 1);
}

void HostileStudiesTest::besideAStudy()
{
    QFETCH(QByteArray, bytes);
    const QTemporaryDir folder;
    test::writeHonestSeries(folder.path());
    store(folder.filePath(QStringLiteral("hostile.dcm")), bytes);
    const test::WatchedRun run =
        test::watchedBurin({QStringLiteral("info"), folder.path(), QStringLiteral("--json")});
    check(run);
    // A volume that cannot be opened is named, and the status says that there is one.
    QCOMPARE(honestSlicesIn(run.output), test::honestSlices);
}

BURIN_TEST(HostileStudiesTest)

} // namespace hostileStudiesTest

#include "HostileStudiesTest.moc"
