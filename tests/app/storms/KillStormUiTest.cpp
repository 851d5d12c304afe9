// SPDX-License-Identifier: Apache-2.0
#include "core/session/SessionStorage.h"
#include "core/sessionfile/SessionSalvage.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/TestVolumes.h"
#include "tests/support/servers/BurinProgram.h"

#include <QDateTime>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QMap>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <cstdio>
#include <optional>

namespace killStormUiTest {

/// What is killed: the window, with somebody who works in it without pause: steps, pictures of them
/// (the window keeps those by itself), "Save session as" every few steps. It tells on stdout what
/// is done, and ends with its process.
class WindowUnderStorm : public QObject {
    Q_OBJECT

    static void tell(const char* what, const QString& more)
    {
        std::printf("TOLD %s %s\n", what, qUtf8Printable(more));
        std::fflush(stdout);
    }

private Q_SLOTS:
    void works()
    {
        test::ApplicationFixture fixture;
        fixture.open(fixture.path("case/ct"));
        tell("session", fixture.session().file());
        fixture.edit(test::addSegment("A"));
        for (int step = 0; step < 3000; ++step) {
            fixture.edit(test::drillAt(step % 17 - 8 + 0.003 * step));
            const core::HistoryRow& row = fixture.session().history().rows().back();
            tell("row",
                QString::number(row.id) + QLatin1Char(' ') + QString::fromLatin1(row.stateHash));
            // Views are drawn, pictures are kept.
            QTest::qWait(5);
            if (step % 4 != 3)
                continue;
            const QString target = fixture.path("as") + QString::number(step) + ".burin";
            tell("saving", target);
            std::atomic<bool> done = false;
            fixture.session().storage().saveAs(target, false,
                [&done](const core::Result<void>& saved) { done = saved.has_value(); });
            QTRY_VERIFY_WITH_TIMEOUT(done, test::ApplicationFixture::patience);
            tell("saved", target);
        }
    }
};

/// A storm of SIGKILLs over the window, at any instant: every step that was told of is in the
/// session, which opens whole, as do the copies that it went on in. BURIN_SEED draws other
/// instants, BURIN_KILLS another number.
class KillStormUiTest : public QObject {
    Q_OBJECT

    std::uint32_t m_seed = 0;
    int m_rows = 0;
    int m_copies = 0;

    struct Told {
        QStringList sessions; ///< the last one is open
        QString saving; ///< a copy that was begun and not told of as done
        QMap<core::RowId, QString> rows; ///< their hashes
        QMap<QString, core::RowId> rowsThen; ///< when a session was left
    };
    [[nodiscard]] static Told killed(const QString& folder, int afterMs);
    void isWhole(const QString& session, const QMap<core::RowId, QString>& rows, core::RowId to);

private Q_SLOTS:
    void initTestCase();
    void anyInstant_data();
    void anyInstant();
    void cleanupTestCase() { qInfo("%d rows told, %d copies", m_rows, m_copies); }
};

void KillStormUiTest::initTestCase()
{
    m_seed = qEnvironmentVariableIsSet("BURIN_SEED")
        ? qEnvironmentVariable("BURIN_SEED").toUInt()
        : std::uint32_t(QDateTime::currentMSecsSinceEpoch());
    qInfo("BURIN_SEED=%u", m_seed);
}

void KillStormUiTest::anyInstant_data()
{
    QTest::addColumn<int>("afterMs");
    const int usual = test::longRun() ? 60 : 3;
    const int kills = qEnvironmentVariableIsSet("BURIN_KILLS")
        ? qEnvironmentVariable("BURIN_KILLS").toInt()
        : usual;
    test::Random random(m_seed);
    for (int i = 0; i < kills; ++i) {
        const int after = test::randomInt(random, 0, 1500);
        QTest::addRow("%d: after %d ms", i, after) << after;
    }
}

/// So long after its session is open.
KillStormUiTest::Told KillStormUiTest::killed(const QString& folder, int afterMs)
{
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("TMPDIR"), folder);
    environment.insert(QStringLiteral("BURIN_TEST_DISPLAY"), QStringLiteral("inherit"));
    process.setProcessEnvironment(environment);
    process.start(QCoreApplication::applicationFilePath(),
        {QStringLiteral("WindowUnderStorm"), QStringLiteral("-maxwarnings"), QStringLiteral("0")});
    QByteArray output;
    while (!output.contains("TOLD row") && process.waitForReadyRead(120'000))
        output += process.readAllStandardOutput();
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < afterMs && process.state() == QProcess::Running) {
        process.waitForReadyRead(std::max(1, afterMs - int(clock.elapsed())));
        output += process.readAllStandardOutput();
    }
    process.kill();
    process.waitForFinished(60'000);
    output += process.readAllStandardOutput();
    Told told;
    for (const QByteArray& line : output.left(output.lastIndexOf('\n') + 1).split('\n')) {
        const QStringList words = QString::fromUtf8(line).split(QLatin1Char(' '));
        if (words.value(0) != QLatin1String("TOLD"))
            continue;
        const core::RowId last = told.rows.isEmpty() ? 0 : told.rows.lastKey();
        if (words.value(1) == QLatin1String("row")) {
            told.rows[words.value(2).toLongLong()] = words.value(3);
        } else if (words.value(1) == QLatin1String("saving")) {
            told.saving = words.value(2);
        } else {
            if (!told.sessions.isEmpty())
                told.rowsThen[told.sessions.back()] = last;
            told.sessions += words.value(2);
            told.saving.clear();
        }
    }
    return told;
}

void KillStormUiTest::isWhole(
    const QString& session, const QMap<core::RowId, QString>& rows, core::RowId to)
{
    const auto contents = core::checkSession(session);
    QVERIFY2(
        contents, contents ? "" : qPrintable(contents.error().arguments.join(QLatin1Char(' '))));
    QVERIFY(contents->isWhole());
    for (auto row = rows.begin(); row != rows.end() && row.key() <= to; ++row) {
        QVERIFY2(row.key() <= core::RowId(contents->rows.size()),
            qPrintable(QStringLiteral("row %1 of %2").arg(row.key()).arg(session)));
        QCOMPARE(
            QString::fromLatin1(contents->rows[std::size_t(row.key() - 1)].stateHash), row.value());
    }
}

void KillStormUiTest::anyInstant()
{
    QFETCH(int, afterMs);
    const QTemporaryDir folder;
    const Told told = killed(folder.path(), afterMs);
    QVERIFY(!told.sessions.isEmpty());
    QVERIFY(!told.rows.isEmpty());
    m_rows += int(told.rows.size());
    m_copies += int(told.sessions.size()) - 1;
    for (const QString& session : told.sessions) {
        isWhole(session, told.rows, told.rowsThen.value(session, told.rows.lastKey()));
        if (QTest::currentTestFailed())
            return;
    }
    // A copy that was under way is there, whole, or not at all.
    if (!told.saving.isEmpty() && QFile::exists(told.saving))
        isWhole(told.saving, told.rows, told.rows.lastKey());
    const test::Outcome verified =
        test::burin({QStringLiteral("replay"), told.sessions.back(), QStringLiteral("--verify")});
    QVERIFY2(verified.status == 0, qPrintable(verified.complaint));
}

BURIN_WINDOW_TEST(WindowUnderStorm)
BURIN_WINDOW_TEST(KillStormUiTest)

} // namespace killStormUiTest

#include "KillStormUiTest.moc"
