// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/SessionSalvage.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/servers/BurinProgram.h"

#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QTest>

#include <csignal>

namespace orderlyEndUiTest {

using test::key;
using test::toJson;

/// However the program is told to end, its session is one whole file afterwards.
class OrderlyEndUiTest : public QObject, test::CommandFixture {
    Q_OBJECT

    static constexpr int startMs = 60'000;
    static constexpr int endMs = 10'000; // a loaded machine; alone it is a fraction of a second

    /// The window, with a.burin open in it.
    std::unique_ptr<QProcess> opened(const QString& display = {}) const
    {
        auto process = std::make_unique<QProcess>();
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char* name : {"XDG_STATE_HOME", "XDG_CACHE_HOME", "XDG_CONFIG_HOME"})
            environment.insert(QLatin1String(name), path(name));
        environment.insert(key("QT_QPA_PLATFORM"), key("xcb"));
        if (!display.isEmpty())
            environment.insert(key("DISPLAY"), display);
        process->setProcessEnvironment(environment);
        process->setProcessChannelMode(QProcess::MergedChannels);
        process->start(QStringLiteral(BURIN_PROGRAM), {key("open"), path("a.burin")});
        QElapsedTimer waited;
        waited.start();
        // While it is open it is written through a file beside it.
        while (!QFile::exists(path("a.burin-wal")) && waited.elapsed() < startMs
            && !process->waitForFinished(50)) { }
        return process;
    }
    /// The session as it was, in one file.
    void isWhole(const QString& hash)
    {
        for (const char* part : {"a.burin-wal", "a.burin-journal", "a.burin-shm"})
            QVERIFY2(!QFile::exists(path(part)), part);
        const auto contents = core::checkSession(path("a.burin"));
        QVERIFY(contents && contents->isWhole() && contents->leftOpen.isEmpty());
        QCOMPARE(lastHash("a.burin"), hash);
    }

private Q_SLOTS:
    void initTestCase() { QVERIFY(prepareStudy()); }
    void init()
    {
        makeFolder();
        const QJsonArray edits = toJson({test::addSegment("A"), test::drillAt(0)});
        QCOMPARE(run(recipe("r.json", {{key("edits"), edits}}), "a.burin").status, 0);
    }

    void signalsCloseTheSession_data()
    {
        QTest::addColumn<int>("number");
        QTest::newRow("SIGTERM") << SIGTERM;
        QTest::newRow("SIGINT") << SIGINT;
        QTest::newRow("SIGHUP") << SIGHUP;
    }
    void signalsCloseTheSession()
    {
        QFETCH(int, number);
        const QString hash = lastHash("a.burin");
        const auto process = opened();
        QVERIFY2(process->state() == QProcess::Running, process->readAll().constData());
        QVERIFY(QFile::exists(path("a.burin-wal")));
        ::kill(pid_t(process->processId()), number);
        QVERIFY(process->waitForFinished(endMs));
        QCOMPARE(process->exitStatus(), QProcess::NormalExit);
        QCOMPARE(process->exitCode(), 128 + number);
        isWhole(hash);
    }

    /// It comes when something is drawn after the display has gone and before Qt notices; who dies
    /// of it leaves the session open.
    void aBrokenPipeEndsNothing()
    {
        const QString hash = lastHash("a.burin");
        const auto process = opened();
        QVERIFY(QFile::exists(path("a.burin-wal")));
        ::kill(pid_t(process->processId()), SIGPIPE);
        QVERIFY(!process->waitForFinished(500));
        ::kill(pid_t(process->processId()), SIGTERM);
        QVERIFY(process->waitForFinished(endMs));
        QCOMPARE(process->exitCode(), 128 + SIGTERM);
        isWhole(hash);
    }

    void theDisplaysDeathClosesTheSession()
    {
        const QString hash = lastHash("a.burin");
        for (const int laterMs : {0, 300, 1500}) {
            QProcess server;
            server.start(key("Xvfb"),
                {key("-displayfd"), key("1"), key("-screen"), key("0"), key("1600x1000x24"),
                    key("-nolisten"), key("tcp"), key("-noreset")});
            QVERIFY(server.waitForReadyRead(startMs));
            const auto process =
                opened(QLatin1Char(':') + QString::fromLatin1(server.readLine().trimmed()));
            QVERIFY2(process->state() == QProcess::Running, process->readAll().constData());
            QVERIFY(QFile::exists(path("a.burin-wal")));
            QTest::qWait(laterMs); // while it opens, while it draws, at rest
            server.kill();
            server.waitForFinished();
            QVERIFY(process->waitForFinished(endMs));
            QCOMPARE(process->exitStatus(), QProcess::NormalExit);
            QVERIFY(process->exitCode() != 0);
            isWhole(hash);
        }
    }
};

BURIN_WINDOW_TEST(OrderlyEndUiTest)

} // namespace orderlyEndUiTest

#include "OrderlyEndUiTest.moc"
