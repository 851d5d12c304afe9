// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/database/SqliteConnection.h"

#include "core/base/files/SystemFile.h"
#include "core/sessionfile/database/RefusedWrites.h"
#include "tests/support/faults/FileShim.h"
#include "tests/support/faults/FileSizeLimit.h"
#include "tests/support/program/TestProgram.h"

#include <QDir>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <cerrno>
#include <cstdio>
#include <map>
#include <utility>

namespace sqliteConnectionTest {

using namespace core;

namespace {

constexpr const char* writtenIn = "BURIN_WRITTEN_IN";

/// What a session does: tables in rollback mode, rows in a log beside the file, which is put into
/// it, and a copy.
bool writeAll(SqliteConnection& connection, const QString& folder)
{
    const QString file = QDir(folder).filePath(QStringLiteral("a.db"));
    return connection.open(file, {}, file) && connection.harden()
        && connection.run(QStringLiteral("PRAGMA locking_mode=EXCLUSIVE"))
        && connection.transaction(
            [&connection] { return connection.run(QStringLiteral("CREATE TABLE t (a)")); })
        && connection.run(QStringLiteral("PRAGMA journal_mode=WAL"))
        && connection.run(QStringLiteral("PRAGMA synchronous=FULL"))
        && connection.transaction([&connection] {
               return connection.run(QStringLiteral("INSERT INTO t VALUES (randomblob(20000))"));
           })
        && connection.run(QStringLiteral("PRAGMA wal_checkpoint(TRUNCATE)"))
        && connection.run(
            QStringLiteral("VACUUM INTO ?"), {QDir(folder).filePath(QStringLiteral("copy.db"))});
}

} // namespace

/// What writes on the disk that fails. It tells on stdout why it could not.
class ConnectionOnFailingDisk : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void writes()
    {
        const QString folder = qEnvironmentVariable(writtenIn);
        if (folder.isEmpty())
            QSKIP("SqliteConnectionTest starts it");
        SqliteConnection connection;
        const bool done = writeAll(connection, folder);
        std::printf("TOLD %s\n",
            done ? "nothing" : connection.failure().reason.english().toLocal8Bit().constData());
        std::fflush(stdout);
    }
};

/// Why SQLite could not write is told as the system has it, whichever call it was.
class SqliteConnectionTest : public QObject {
    Q_OBJECT

    test::WatchedHome m_home;

    [[nodiscard]] QString folder() const { return m_home.path(QStringLiteral("in")); }
    [[nodiscard]] QString told(const test::FileFault& fault) const
    {
        if (!QDir(folder()).removeRecursively() || !QDir().mkpath(folder()))
            qFatal("the folder cannot be emptied");
        static_cast<void>(m_home.events());
        QProcess process;
        QProcessEnvironment environment = m_home.environment(fault);
        environment.insert(QLatin1String(writtenIn), folder());
        process.setProcessEnvironment(environment);
        process.start(
            QCoreApplication::applicationFilePath(), {QStringLiteral("ConnectionOnFailingDisk")});
        process.waitForFinished(300'000);
        for (const QByteArray& line : process.readAllStandardOutput().split('\n')) {
            if (line.startsWith("TOLD "))
                return QString::fromLocal8Bit(line.mid(5));
        }
        return QStringLiteral("no end");
    }

private Q_SLOTS:
    void theSystemsReasonIsTold_data()
    {
        QTest::addColumn<QByteArray>("calls");
        QTest::addColumn<int>("error");
        QTest::newRow("quota") << QByteArray("open,write") << EDQUOT;
        QTest::newRow("full") << QByteArray("open,write") << ENOSPC;
        QTest::newRow("defective") << QByteArray("open,write") << EIO;
    }
    /// The first call of each kind that meets each file.
    void theSystemsReasonIsTold()
    {
        QFETCH(QByteArray, calls);
        QFETCH(int, error);
        QCOMPARE(told({.under = folder(), .calls = calls}), QStringLiteral("nothing"));
        std::map<std::pair<QString, QString>, int> firstCalls; ///< by file and kind
        int count = 0;
        for (const test::FileEvent& event : m_home.events()) {
            if (event.what == "counts")
                firstCalls.try_emplace({QFileInfo(event.path).fileName(), event.more}, ++count);
        }
        // The file, its journal, its log and its copy are opened and written.
        for (const char* file : {"a.db", "a.db-wal", "copy.db"}) {
            for (const char* kind : {"open", "write"})
                QVERIFY2(firstCalls.count({QLatin1String(file), QLatin1String(kind)}) == 1, file);
        }
        for (const auto& [what, call] : firstCalls) {
            const QString reason = told({.under = folder(),
                .calls = calls,
                .first = call,
                .last = 1 << 30,
                .error = error});
            QVERIFY2(reason == systemReason(error),
                qPrintable(what.second + u' ' + what.first + QStringLiteral(": ") + reason));
        }
    }

    /// What a network's file system tells only then; each time by itself, of the journal in which
    /// the tables are made and of the copy, too.
    void whatIsRefusedWhenItIsBroughtToTheDisk()
    {
        QCOMPARE(told({.under = folder(), .calls = "sync"}), QStringLiteral("nothing"));
        QStringList synced;
        for (const test::FileEvent& event : m_home.events()) {
            if (event.what == "counts")
                synced += QFileInfo(event.path).fileName();
        }
        // What comes later is of the closing, which nobody is told of.
        while (!synced.isEmpty() && !synced.last().startsWith(QLatin1String("copy.db")))
            synced.removeLast();
        // So is the last one of the copy, whose journal is not in use any more by then.
        QVERIFY(!synced.isEmpty());
        synced.removeLast();
        for (const char* file : {"a.db-journal", "a.db", "a.db-wal", "copy.db-journal", "copy.db"})
            QVERIFY2(synced.contains(QLatin1String(file)), file);
        for (int call = 1; call <= int(synced.size()); ++call) {
            const QString file = synced[call - 1];
            // A folder that cannot be brought to the disk is no error (some network mounts).
            const QString expected = file == QFileInfo(folder()).fileName()
                ? QStringLiteral("nothing")
                : systemReason(EDQUOT);
            const QString reason = told(
                {.under = folder(), .calls = "sync", .first = call, .last = call, .error = EDQUOT});
            QVERIFY2(reason == expected,
                qPrintable(
                    QStringLiteral("call %1, of %2: %3").arg(QString::number(call), file, reason)));
        }
    }

    /// A reason that was noted belongs to one statement.
    void whatIsNoFaultOfTheSystemIsTold()
    {
        const QTemporaryDir there;
        SqliteConnection connection;
        QVERIFY(writeAll(connection, there.path()));
        {
            const test::FileSizeLimit limit(1);
            QVERIFY(!connection.run(QStringLiteral("INSERT INTO t VALUES (1)")));
            QCOMPARE(connection.failure().reason.english(), systemReason(EFBIG));
            QCOMPARE(lastRefusedWrite(), EFBIG);
        }
        QVERIFY(!connection.run(QStringLiteral("INSERT INTO u VALUES (1)")));
        QCOMPARE(connection.failure().reason.english(), QStringLiteral("no such table: u"));
        QCOMPARE(lastRefusedWrite(), 0);
        QVERIFY(connection.run(QStringLiteral("INSERT INTO t VALUES (1)")));
    }
};

BURIN_TEST(ConnectionOnFailingDisk)
BURIN_TEST(SqliteConnectionTest)

} // namespace sqliteConnectionTest

#include "SqliteConnectionTest.moc"
