// SPDX-License-Identifier: Apache-2.0
#include "core/sessionfile/SessionSalvage.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QJsonDocument>
#include <QProcess>
#include <QTest>

#include <csignal>

namespace commandTerminationGlTest {

using test::key;
using test::toJson;

/// `burin run` that is told to end closes its session: one file, with every row that was told of.
class CommandTerminationGlTest : public QObject, test::CommandFixture {
    Q_OBJECT

    static constexpr int endMs = 15'000; // a loaded machine; alone it is a fraction of a second

    QString manySteps() const
    {
        std::vector<core::Edit> many{test::addSegment("A")};
        for (int i = 0; i < 2000; ++i)
            many.push_back(test::drillAt(i % 17 - 8 + 0.003 * i));
        return recipe("many.json", {{key("edits"), toJson(many)}});
    }
    QStringList names() const
    {
        return QDir(path("")).entryList({key("*burin*")}, QDir::Files | QDir::Hidden);
    }
    /// Told to end behind so many lines. @return the lines
    QByteArrayList told(int signal, int lines, const QStringList& more) const
    {
        QProcess process;
        process.start(QStringLiteral(BURIN_PROGRAM),
            QStringList{key("run"), manySteps(), key("--session"), path("a.burin")} + more);
        QByteArray output;
        while (output.count('\n') < lines && process.waitForReadyRead(60'000))
            output += process.readAllStandardOutput();
        ::kill(pid_t(process.processId()), signal);
        QElapsedTimer clock;
        clock.start();
        if (!process.waitForFinished(endMs))
            qFatal("it goes on");
        qInfo("it took %lld ms", static_cast<long long>(clock.elapsed()));
        if (process.exitStatus() != QProcess::NormalExit || process.exitCode() != 128 + signal)
            qFatal("status %d: %s", process.exitCode(), process.readAllStandardError().constData());
        output += process.readAllStandardOutput();
        return output.left(output.lastIndexOf('\n') + 1).trimmed().split('\n');
    }
    void isWhole(const char* name, const QByteArrayList& lines, std::size_t rowsBefore)
    {
        for (const char* part : {"-wal", "-journal", "-shm"})
            QVERIFY2(!QFile::exists(path(name) + QLatin1String(part)), part);
        const auto contents = core::checkSession(path(name));
        QVERIFY(contents && contents->isWhole() && contents->leftOpen.isEmpty());
        // One more at most: the step that was under way.
        QVERIFY(contents->rows.size() >= rowsBefore + std::size_t(lines.size()));
        QVERIFY(contents->rows.size() <= rowsBefore + std::size_t(lines.size()) + 1);
        for (const QByteArray& line : lines) {
            const QJsonObject row = QJsonDocument::fromJson(line).object();
            const qint64 id = row[key("row")].toInteger();
            QVERIFY(id > 0);
            QCOMPARE(QString::fromLatin1(contents->rows[std::size_t(id - 1)].stateHash),
                row[key("hash")].toString());
        }
    }

private Q_SLOTS:
    void initTestCase() { QVERIFY(prepareStudy()); }
    void init()
    {
        test::failOnUnexpectedMessages();
        makeFolder();
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
        const QByteArrayList lines = told(number, 7, {key("--study"), study()});
        isWhole("a.burin", lines, 0);
        QCOMPARE(names(), QStringList{key("a.burin")});
    }

    void whatGoesOnStaysWhole()
    {
        const QJsonArray few = toJson({test::addSegment("B"), test::drillAt(0)});
        QCOMPARE(run(recipe("r.json", {{key("edits"), few}}), "a.burin").status, 0);
        const QByteArrayList lines = told(SIGTERM, 5, {key("--append")});
        isWhole("a.burin", lines, 2);
        QCOMPARE(names(), QStringList{key("a.burin")});
    }

    void whatWasToBeReplacedStays()
    {
        const QJsonArray few = toJson({test::addSegment("B"), test::drillAt(0)});
        QCOMPARE(run(recipe("r.json", {{key("edits"), few}}), "a.burin").status, 0);
        const QString hash = lastHash("a.burin");
        const QByteArrayList lines = told(SIGTERM, 5, {key("--study"), study(), key("--force")});
        QCOMPARE(lastHash("a.burin"), hash);
        isWhole("a (unfinished).burin", lines, 0);
        QCOMPARE(names(), (QStringList{key("a (unfinished).burin"), key("a.burin")}));
    }

    /// Before its first step nothing is promised, and nothing is left.
    void atOnceNothingIsLeft()
    {
        QProcess process;
        process.start(QStringLiteral(BURIN_PROGRAM),
            {key("run"), manySteps(), key("--study"), study(), key("--session"), path("a.burin")});
        QElapsedTimer clock;
        clock.start();
        while (!QFile::exists(path("a.burin")) && clock.elapsed() < 60'000
            && !process.waitForFinished(1)) { }
        ::kill(pid_t(process.processId()), SIGTERM);
        QVERIFY(process.waitForFinished(endMs));
        QCOMPARE(process.exitCode(), 128 + SIGTERM);
        const QByteArray output = process.readAllStandardOutput();
        if (output.isEmpty()) {
            QCOMPARE(names(), QStringList());
        } else {
            QCOMPARE(names(), QStringList{key("a.burin")});
            isWhole("a.burin", output.trimmed().split('\n'), 0);
        }
    }
};

BURIN_TEST(CommandTerminationGlTest)

} // namespace commandTerminationGlTest

#include "CommandTerminationGlTest.moc"
