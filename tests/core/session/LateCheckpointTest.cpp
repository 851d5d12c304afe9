// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditSession.h"
#include "core/sessionfile/SessionSalvage.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FileShim.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTest>

#include <cerrno>
#include <cstdio>

namespace lateCheckpointTest {

using namespace core;

namespace {

constexpr const char* renamedIn = "BURIN_RENAMED_IN";

QString formerName(const QString& folder)
{
    return QDir(folder).filePath(QStringLiteral("a.burin"));
}

QString newName(const QString& folder)
{
    return QDir(folder).filePath(QStringLiteral("b.burin"));
}

} // namespace

/// What works on the disk that fails: a session whose file another program renames just before it
/// is closed. It tells on stdout what was on disk by then.
class RenamedOnFailingDisk : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void isClosed()
    {
        const QString folder = qEnvironmentVariable(renamedIn);
        if (folder.isEmpty())
            QSKIP("LateCheckpointTest starts it");
        reference::ReferenceEngine engine;
        auto session =
            *EditSession::create(engine, test::smallStudy(), {.file = formerName(folder)});
        session->setErrorListener([](const Error&) {});
        QVERIFY(session->apply(test::drillAt(3)));
        QVERIFY(session->settle());
        const QByteArray hash = session->history().rows().back().stateHash;
        QVERIFY(std::rename(QFile::encodeName(formerName(folder)).constData(),
                    QFile::encodeName(newName(folder)).constData())
            == 0);
        session.reset();
        std::printf("TOLD %s\n", hash.constData());
        std::fflush(stdout);
    }
};

/// A session that another program has renamed is closed, and the disk refuses some calls: what was
/// to be put into the file is put there at a further try. Nothing is missing then, and nothing
/// is said to be.
class LateCheckpointTest : public QObject {
    Q_OBJECT

    test::WatchedHome m_home;

    [[nodiscard]] QString folder() const { return m_home.path(QStringLiteral("in")); }
    /// @return the hash of the step that was on disk; empty: it did not come to its end
    [[nodiscard]] QByteArray closed(int firstRefused, int lastRefused) const
    {
        if (!QDir(folder()).removeRecursively() || !QDir().mkpath(folder()))
            qFatal("the folder cannot be emptied");
        static_cast<void>(m_home.events());
        QProcess process;
        QProcessEnvironment environment = m_home.environment({.under = folder(),
            .calls = "write,sync",
            .first = firstRefused,
            .last = lastRefused,
            .error = EIO});
        environment.insert(QLatin1String(renamedIn), folder());
        process.setProcessEnvironment(environment);
        process.start(
            QCoreApplication::applicationFilePath(), {QStringLiteral("RenamedOnFailingDisk")});
        process.waitForFinished(300'000);
        if (process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0)
            return {};
        for (const QByteArray& line : process.readAllStandardOutput().split('\n')) {
            if (line.startsWith("TOLD "))
                return line.mid(5);
        }
        return {};
    }

    /// What is wrong with the session when these calls are refused; empty: nothing.
    [[nodiscard]] QString wrongAfter(int firstRefused, int lastRefused) const
    {
        const QByteArray hash = closed(firstRefused, lastRefused);
        if (hash.isEmpty())
            return QStringLiteral("it did not come to its end");
        const auto contents = checkSession(newName(folder()));
        if (!contents)
            return contents.error().arguments.join(u' ');
        if (!contents->isWhole() || contents->rows.size() != 1
            || contents->rows.back().stateHash != hash)
            return QStringLiteral("its step is not there");
        return contents->leftOpen.english();
    }

private Q_SLOTS:
    void nothingIsSaidToBeMissing()
    {
        QVERIFY(!closed(0, 0).isEmpty());
        int calls = 0;
        int before = 0; ///< it was renamed
        for (const test::FileEvent& event : m_home.events()) {
            calls += event.what == "counts" ? 1 : 0;
            if (event.what == "rename" && event.path == formerName(folder()))
                before = calls;
        }
        QVERIFY(before > 0 && calls > before);
        // Of several in a row each is another try to put everything into the file.
        constexpr int mostInARow = 4;
        for (int call = before + 1; call <= calls; ++call) {
            for (int inARow = 1; inARow <= (call < before + 3 ? mostInARow : 1); ++inARow) {
                const QString wrong = wrongAfter(call, call + inARow - 1);
                QVERIFY2(wrong.isEmpty(),
                    qPrintable(QStringLiteral("%1 calls from %2 of %3: %4")
                                   .arg(inARow)
                                   .arg(call)
                                   .arg(calls)
                                   .arg(wrong)));
            }
        }
    }
};

BURIN_TEST(RenamedOnFailingDisk)
BURIN_TEST(LateCheckpointTest)

} // namespace lateCheckpointTest

#include "LateCheckpointTest.moc"
