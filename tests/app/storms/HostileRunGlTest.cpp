// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program/TestProgram.h"
#include "tests/support/series/defective/HostileStudy.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace hostileRunGlTest {

/// `burin run` on a study beside hostile files: it works on the study.
class HostileRunGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void allAtOnce();
    void oneByOne_data();
    void oneByOne();

private:
    static void store(const QString& path, const QByteArray& bytes)
    {
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            qFatal("cannot write %s", qPrintable(path));
    }
    test::WatchedRun run(const QString& study) const
    {
        return test::watchedBurin({QStringLiteral("run"), m_work.filePath(QStringLiteral("r.json")),
            QStringLiteral("--study"), study, QStringLiteral("--series"), test::honestSeriesUid(),
            QStringLiteral("--session"), m_work.filePath(QStringLiteral("s.burin")),
            QStringLiteral("--force")});
    }

    QTemporaryDir m_work;
    /// Not more than ten seconds, or twice the memory, over what the study takes alone.
    void check(const test::WatchedRun& outcome) const
    {
        QVERIFY(!outcome.hung);
        QVERIFY2(outcome.status == 0, qPrintable(outcome.complaint));
        QVERIFY2(outcome.peakKb <= 2 * m_honest.peakKb,
            qPrintable(QStringLiteral("%1 KB").arg(outcome.peakKb)));
        QVERIFY2(outcome.cpuSeconds <= m_honest.cpuSeconds + 10.0,
            qPrintable(QStringLiteral("%1 s").arg(outcome.cpuSeconds)));
    }

    test::WatchedRun m_honest;
};

void HostileRunGlTest::initTestCase()
{
    store(m_work.filePath(QStringLiteral("r.json")),
        R"({"edits": [{"edit": "addSegment", "name": "One", "color": "#ff0000"}]})");
    const QTemporaryDir folder;
    test::writeHonestSeries(folder.path());
    m_honest = run(folder.path());
    QVERIFY2(m_honest.status == 0, qPrintable(m_honest.complaint));
}

void HostileRunGlTest::allAtOnce()
{
    const QTemporaryDir folder;
    test::writeHonestSeries(folder.path());
    int number = 0;
    for (const test::HostileFile& file : test::hostileFiles())
        store(folder.filePath(QStringLiteral("hostile%1").arg(++number)), file.bytes);
    check(run(folder.path()));
}

void HostileRunGlTest::oneByOne_data()
{
    QTest::addColumn<QByteArray>("bytes");
    for (const test::HostileFile& file : test::hostileFiles())
        QTest::newRow(qPrintable(file.name)) << file.bytes;
}

void HostileRunGlTest::oneByOne()
{
    if (!qEnvironmentVariableIsSet("BURIN_LONG"))
        QSKIP("one engine for each file: with BURIN_LONG");
    QFETCH(QByteArray, bytes);
    const QTemporaryDir folder;
    test::writeHonestSeries(folder.path());
    store(folder.filePath(QStringLiteral("hostile.dcm")), bytes);
    check(run(folder.path()));
}

BURIN_TEST(HostileRunGlTest)

} // namespace hostileRunGlTest

#include "HostileRunGlTest.moc"
