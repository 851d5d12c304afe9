// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/SessionSalvage.h"
#include "core/sessionfile/database/SessionUse.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/Sanitizer.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/servers/ProcessTable.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTest>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <functional>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace runGoesOnGlTest {

using test::burin;
using test::key;
using test::Outcome;
using test::toJson;

/// A pipe that is full: whoever writes into it waits until it is drained.
class FullPipe {
public:
    explicit FullPipe(const QString& path)
    {
        const QByteArray name = QFile::encodeName(path);
        if (::mkfifo(name.constData(), S_IRUSR | S_IWUSR) == 0)
            m_descriptor = ::open(name.constData(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
        if (m_descriptor < 0)
            qFatal("cannot make a pipe");
        const std::array<char, 4096> zeros{};
        while (::write(m_descriptor, zeros.data(), zeros.size()) > 0) { }
    }
    FullPipe(const FullPipe&) = delete;
    FullPipe& operator=(const FullPipe&) = delete;
    ~FullPipe() { ::close(m_descriptor); }
    /// What others have written so far.
    QByteArray drain()
    {
        std::array<char, 4096> some{};
        QByteArray all;
        for (ssize_t count = 1; count > 0;) {
            count = ::read(m_descriptor, some.data(), some.size());
            all.append(some.data(), std::max<qsizetype>(0, count));
        }
        return all.replace(QByteArray(1, '\0'), QByteArray());
    }

private:
    int m_descriptor = -1;
};

/// Where `burin run` goes on: after which row of a session, and in which file.
class RunGoesOnGlTest : public QObject, protected test::CommandFixture {
    Q_OBJECT

    static constexpr int patienceMs = 60'000 * test::slowness;

    [[nodiscard]] Outcome append(const QJsonArray& steps) const
    {
        return burin({key("run"), recipe("more.json", {{key("edits"), steps}}), key("--session"),
            path("a.burin"), key("--append")});
    }
    [[nodiscard]] QString row(int seq) const
    {
        const QJsonArray rows = history("a.burin")[key("commands")].toArray();
        return QStringLiteral("row %1 '%2'")
            .arg(QString::number(seq), rows[seq - 1].toObject()[key("name")].toString());
    }

    /// Runs a step; when all is done @p event happens, and the disk takes nothing any more.
    void endOnFullDisk(const std::function<void()>& event, QString& complaint)
    {
        FullPipe output(path("output"));
        QProcess process;
        process.setStandardOutputFile(path("output"));
        // The process takes it over: what it cannot write is to fail, and not to end it.
        const auto before = std::signal(SIGXFSZ, SIG_IGN);
        process.start(QStringLiteral(BURIN_PROGRAM),
            {key("run"), recipe("r.json", {{key("edits"), toJson({test::addSegment("A")})}}),
                key("--study"), study(), key("--session"), path("a.burin")});
        QVERIFY(process.waitForStarted(patienceMs));
        std::signal(SIGXFSZ, before);
        // The step is on disk, and its line waits for us.
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path("a.burin-wal")), patienceMs);
        const auto isStepThere = [this] {
            const auto contents = core::checkSession(path("a.burin"));
            return contents && contents->rows.size() == 1
                && !contents->rows.front().stateHash.isEmpty();
        };
        QTRY_VERIFY_WITH_TIMEOUT(isStepThere(), patienceMs);
        // Were it sooner, the step would be refused for the same reason.
        QTest::qWait(200);
        event();
        rlimit limit{};
        const auto pid = pid_t(process.processId());
        QCOMPARE(::prlimit(pid, RLIMIT_FSIZE, nullptr, &limit), 0);
        limit.rlim_cur = 1;
        QCOMPARE(::prlimit(pid, RLIMIT_FSIZE, &limit, nullptr), 0);
        static_cast<void>(output.drain());
        QVERIFY(process.waitForFinished(patienceMs));
        complaint = QString::fromUtf8(process.readAllStandardError());
        QVERIFY2(process.exitStatus() == QProcess::NormalExit && process.exitCode() == 1,
            qPrintable(complaint));
    }

private Q_SLOTS:
    void initTestCase() { QVERIFY(prepareStudy()); }
    void init()
    {
        test::failOnUnexpectedMessages();
        makeFolder();
    }

    void theRowIsTold()
    {
        QJsonArray steps = toJson({test::addSegment("A"), test::addSegment("B")});
        QCOMPARE(run(recipe("r.json", {{key("edits"), steps}}), "a.burin").status, 0);
        // After the last one nothing is to be told.
        const Outcome last = append(toJson({test::addSegment("C")}));
        QVERIFY2(last.status == 0, qPrintable(last.complaint));
        QVERIFY2(!last.complaint.contains(key("goes on")), qPrintable(last.complaint));

        QCOMPARE(append(QJsonArray{test::goTo(2)}).status, 0);
        QString told = path("a.burin")
            + QStringLiteral(": goes on after %1, not after the last one, %2\n")
                  .arg(row(2), row(3));
        const Outcome behind = append(toJson({test::addSegment("D")}));
        QVERIFY2(behind.status == 0, qPrintable(behind.complaint));
        QVERIFY2(behind.complaint.contains(told), qPrintable(behind.complaint));
        QCOMPARE(behind.lines.last()[key("row")].toInt(), 4);
        const QJsonArray rows = history("a.burin")[key("commands")].toArray();
        QCOMPARE(rows[3].toObject()[key("parent")].toInt(), 2);

        // The end of a branch is the last row, too; and the beginning has no name.
        const Outcome end = append(QJsonArray{test::goTo(0)});
        QVERIFY2(end.status == 0, qPrintable(end.complaint));
        QVERIFY2(!end.complaint.contains(key("goes on")), qPrintable(end.complaint));
        told = path("a.burin")
            + QStringLiteral(": goes on at the beginning, not after the last one, %1\n")
                  .arg(row(4));
        // It is told before anything is done.
        const Outcome refused = append(QJsonArray{test::goTo(99)});
        QCOMPARE(refused.status, 1);
        QVERIFY2(refused.complaint.startsWith(told), qPrintable(refused.complaint));
    }

    /// --force cannot be the way out: it is refused beside --append.
    void anExportThatIsThereIsNotReplaced()
    {
        const QString first = recipe("r.json", {{key("edits"), toJson({test::addSegment("A")})}});
        QCOMPARE(run(first, "a.burin").status, 0);
        QFile there(path("a.csv"));
        QVERIFY(there.open(QIODevice::WriteOnly) && there.write("kept") == 4);
        there.close();
        const QJsonArray exports{
            QJsonObject{{key("format"), key("csv")}, {key("file"), path("a.csv")}}};
        const QString more = recipe("more.json",
            {{key("edits"), toJson({test::addSegment("B")})}, {key("export"), exports}});
        const Outcome refused =
            burin({key("run"), more, key("--session"), path("a.burin"), key("--append")});
        QCOMPARE(refused.status, 1);
        QVERIFY2(refused.complaint.contains(path("a.csv"))
                && refused.complaint.contains(key("another name"))
                && !refused.complaint.contains(key("--force")),
            qPrintable(refused.complaint));
        QVERIFY(refused.lines.isEmpty());
        QCOMPARE(history("a.burin")[key("commands")].toArray().size(), 1);
    }

    void theFileIsTold()
    {
        std::vector<core::Edit> edits{test::addSegment("A")};
        for (int i = 0; i < 400; ++i)
            edits.push_back(test::renameSegment(1, QStringLiteral("A%1").arg(i)));
        const QStringList words{key("run"), recipe("many.json", {{key("edits"), toJson(edits)}}),
            key("--study"), study(), key("--session"), path("a.burin")};
        QProcess process;
        QByteArray output;
        bool isHeld = false;
        for (int tries = 0; tries < 5 && !isHeld; ++tries) {
            QVERIFY(core::removeSession(path("a.burin")));
            output.clear();
            process.start(QStringLiteral(BURIN_PROGRAM), words);
            while (!output.contains('\n') && process.waitForReadyRead(patienceMs))
                output += process.readAllStandardOutput();
            isHeld = test::holdProcess(process.processId());
            if (!isHeld)
                QVERIFY(process.waitForFinished(patienceMs));
        }
        QVERIFY(isHeld);
        QVERIFY(QFile::rename(path("a.burin"), path("b.burin")));
        QCOMPARE(::kill(pid_t(process.processId()), SIGCONT), 0);
        QVERIFY(process.waitForFinished(patienceMs));
        const QString complaint = QString::fromUtf8(process.readAllStandardError());
        QVERIFY2(process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0,
            qPrintable(complaint));
        output += process.readAllStandardOutput();
        QCOMPARE(std::size_t(output.count('\n')), edits.size());
        QVERIFY2(complaint.contains(path("b.burin")
                     + QStringLiteral(": another program renamed or moved 'a.burin'")),
            qPrintable(complaint));
        QCOMPARE(
            QDir(path("")).entryList({key("*.burin*")}, QDir::Files), QStringList{key("b.burin")});
        const auto contents = core::checkSession(path("b.burin"));
        QVERIFY(contents && contents->isWhole() && contents->leftOpen.isEmpty());
        QCOMPARE(contents->rows.size(), edits.size());
    }

    /// Renamed when all is done, on a disk that takes nothing any more.
    void thatItCouldNotFollowIsTold()
    {
        QString complaint;
        endOnFullDisk(
            [this] { QVERIFY(QFile::rename(path("a.burin"), path("b.burin"))); }, complaint);
        if (QTest::currentTestFailed())
            return;
        QVERIFY2(complaint.contains(path("b.burin"))
                && complaint.contains(key("another program renamed or moved 'a.burin'")),
            qPrintable(complaint));
        QCOMPARE(QDir(path("")).entryList({key("*.burin*")}, QDir::Files),
            QStringList({key("b.burin"), key("b.burin-wal")}));
        const auto contents = core::checkSession(path("b.burin"));
        QVERIFY(contents && contents->isWhole());
        QCOMPARE(contents->rows.size(), std::size_t(1));
    }

    /// Another file has its name, and what was written last must not stay beside that one.
    void whereItsLastStepsLieIsTold()
    {
        QString complaint;
        const auto replaced = [this] {
            QFile other(path("other"));
            QVERIFY(other.open(QIODevice::WriteOnly) && other.write("of somebody else") > 0);
            other.close();
            QVERIFY(std::rename(QFile::encodeName(path("other")).constData(),
                        QFile::encodeName(path("a.burin")).constData())
                == 0);
        };
        endOnFullDisk(replaced, complaint);
        if (QTest::currentTestFailed())
            return;
        QVERIFY2(complaint.contains(key("a.burin-wal.left' holds the last steps")),
            qPrintable(complaint));
        QCOMPARE(QDir(path("")).entryList({key("*.burin*")}, QDir::Files),
            QStringList({key("a.burin"), key("a.burin-wal.left")}));
    }

    /// So is what lies beside a session that goes on.
    void whatIsLeftOfAnotherSessionIsTold()
    {
        const QJsonArray steps = toJson({test::addSegment("A")});
        QCOMPARE(run(recipe("r.json", {{key("edits"), steps}}), "a.burin").status, 0);
        QFile left(path("a.burin-wal.left"));
        QVERIFY(left.open(QIODevice::WriteOnly) && left.write("steps") == 5);
        left.close();
        const Outcome appended = append(toJson({test::addSegment("B")}));
        const Outcome listed = burin({key("history"), path("a.burin")});
        for (const Outcome& outcome : {appended, listed}) {
            QVERIFY2(outcome.status == 0, qPrintable(outcome.complaint));
            QVERIFY2(outcome.complaint.contains(key("a.burin-wal.left' holds the last steps")),
                qPrintable(outcome.complaint));
        }
        QVERIFY(left.exists());
    }

    /// Renamed and replaced before anything was done; then nothing can be done.
    void whatHasItsNameNowStays()
    {
        FullPipe complaint(path("complaint"));
        QProcess process;
        process.setStandardErrorFile(path("complaint"));
        process.start(QStringLiteral(BURIN_PROGRAM),
            {key("run"), recipe("r.json", {{key("edits"), QJsonArray{test::goTo(99)}}}),
                key("--study"), study(), key("--session"), path("a.burin"), key("--facts")});
        QByteArray output;
        while (!output.contains('\n') && process.waitForReadyRead(patienceMs))
            output += process.readAllStandardOutput();
        QVERIFY2(output.contains("renderer"), output.constData());
        // Why the step is refused waits for us, and the session for it.
        QVERIFY(QFile::rename(path("a.burin"), path("b.burin")));
        QFile other(path("a.burin"));
        QVERIFY(other.open(QIODevice::WriteOnly));
        other.write("of somebody else");
        other.close();
        static_cast<void>(complaint.drain());
        QVERIFY(process.waitForFinished(patienceMs));
        const QByteArray said = complaint.drain();
        QVERIFY2(process.exitStatus() == QProcess::NormalExit && process.exitCode() == 1,
            said.constData());
        QCOMPARE(test::bytesOf(path("a.burin")), QByteArray("of somebody else"));
        QVERIFY(QFile::exists(path("b.burin")));
    }
};

BURIN_TEST(RunGoesOnGlTest)

} // namespace runGoesOnGlTest

#include "RunGoesOnGlTest.moc"
