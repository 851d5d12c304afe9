// SPDX-License-Identifier: Apache-2.0
#include "core/base/Sha256.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/series/SyntheticSeries.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTest>

#include <sys/stat.h>

namespace filesKeptGlTest {

using test::key;
using test::Outcome;
using test::toJson;

namespace {

QByteArray read(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(cannot be read)");
}

} // namespace

/// Whatever a command is told to write over, with --force or without: what it reads, and what is
/// not its own, stays as it was, byte for byte.
class FilesKeptGlTest : public QObject, test::CommandFixture {
    Q_OBJECT

    QJsonObject edits() const
    {
        return {{key("edits"), toJson({test::addSegment("A"), test::drillAt(0)})}};
    }
    Outcome runOn(
        const QString& study, const QString& recipeFile, const QString& session, bool force) const
    {
        QStringList words{key("run"), recipeFile, key("--study"), study, key("--session"), session};
        if (force)
            words += key("--force");
        return test::burin(words);
    }
    QString copyOfStudy(const char* name) const
    {
        return QFile::copy(study(), path(name)) ? path(name) : QString();
    }

private Q_SLOTS:
    void initTestCase() { QVERIFY(prepareStudy()); }
    void init()
    {
        test::failOnUnexpectedMessages();
        makeFolder();
    }

    void sessionsReplaceNothingButSessions()
    {
        const QString mine = copyOfStudy("study.nii.gz");
        const QByteArray bytes = read(mine);
        const QString words = recipe("r.json", edits());
        const QByteArray recipeBytes = read(words);
        QFile notes(path("notes.txt"));
        QVERIFY(notes.open(QIODevice::WriteOnly) && notes.write("precious") == 8);
        notes.close();
        QVERIFY(QFile::link(mine, path("link.burin")));
        QVERIFY(::link(QFile::encodeName(mine).constData(),
                    QFile::encodeName(path("hard.burin")).constData())
            == 0);
        QVERIFY(::mkfifo(QFile::encodeName(path("pipe.burin")).constData(), 0600) == 0);
        const QStringList before = QDir(path("")).entryList(QDir::AllEntries | QDir::System);
        for (const bool force : {false, true}) {
            for (const char* target : {"study.nii.gz", "link.burin", "hard.burin", "notes.txt",
                     "r.json", "pipe.burin", "no/such/folder.burin", "."}) {
                const Outcome outcome = runOn(mine, words, path(target), force);
                QVERIFY2(outcome.status == 1, target);
                QVERIFY2(outcome.complaint.contains(QLatin1String(target)),
                    qPrintable(outcome.complaint));
                QVERIFY(outcome.lines.isEmpty());
            }
        }
        QCOMPARE(read(mine), bytes);
        QCOMPARE(read(words), recipeBytes);
        QCOMPARE(read(path("notes.txt")), QByteArray("precious"));
        QCOMPARE(QDir(path("")).entryList(QDir::AllEntries | QDir::System), before);
    }

    void partsOfOtherSessionsStay()
    {
        QFile stray(path("new.burin-wal"));
        QVERIFY(stray.open(QIODevice::WriteOnly) && stray.write("somebody's") == 10);
        stray.close();
        const QString words = recipe("r.json", edits());
        for (const QStringList& more : {QStringList(), QStringList{key("--with-images")}}) {
            const Outcome outcome = run(words, "new.burin", more);
            QCOMPARE(outcome.status, 1);
            QVERIFY2(
                outcome.complaint.contains(key("new.burin-wal")), qPrintable(outcome.complaint));
            QCOMPARE(read(path("new.burin-wal")), QByteArray("somebody's"));
            QVERIFY(!QFile::exists(path("new.burin")));
        }
        // Nor does a copy for others come to lie beside it.
        QCOMPARE(run(words, "a.burin").status, 0);
        const Outcome copied = test::burin({key("history"), path("a.burin"), key("--deidentified"),
            path("new.burin"), key("--force")});
        QCOMPARE(copied.status, 1);
        QVERIFY2(copied.complaint.contains(key("new.burin-wal")), qPrintable(copied.complaint));
        QCOMPARE(read(path("new.burin-wal")), QByteArray("somebody's"));
        QVERIFY(!QFile::exists(path("new.burin")));
    }

    /// What fails after the first step leaves the old session, and what was told of the new one.
    void aFailedRunKeepsTheOldSession()
    {
        QCOMPARE(run(recipe("r.json", edits()), "a.burin").status, 0);
        const QByteArray old = read(path("a.burin"));
        const QJsonArray bad = toJson({test::addSegment("B")});
        QJsonArray failing = bad;
        failing.append(QJsonObject{{key("edit"), key("revert")}, {key("rows"), QJsonArray{99}}});
        const Outcome outcome =
            run(recipe("bad.json", {{key("edits"), failing}}), "a.burin", {key("--force")});
        QCOMPARE(outcome.status, 1);
        QCOMPARE(read(path("a.burin")), old);
        // The first step was printed, so it is kept.
        QCOMPARE(outcome.lines.size(), 1);
        QVERIFY(outcome.complaint.contains(key("a (unfinished).burin")));
        QCOMPARE(history("a (unfinished).burin")[key("commands")].toArray().size(), 1);
        QVERIFY(QFile::remove(path("a (unfinished).burin")));

        const QJsonArray only{
            QJsonObject{{key("edit"), key("revert")}, {key("rows"), QJsonArray{99}}}};
        QCOMPARE(
            run(recipe("bad.json", {{key("edits"), only}}), "a.burin", {key("--force")}).status, 1);
        QCOMPARE(read(path("a.burin")), old);
        QCOMPARE(QDir(path("")).entryList({key("*.burin*")}, QDir::Files | QDir::Hidden),
            QStringList{key("a.burin")});
    }

    void aReplacedSessionIsWhole()
    {
        QCOMPARE(run(recipe("r.json", edits()), "a.burin").status, 0);
        const QString before = lastHash("a.burin");
        const QString more = recipe("more.json",
            {{key("edits"), toJson({test::addSegment("A"), test::drillAt(0), test::drillAt(3)})}});
        for (const QStringList& words :
            {QStringList{key("--force")}, QStringList{key("--force"), key("--with-images")}}) {
            const Outcome outcome = run(more, "a.burin", words);
            QVERIFY2(outcome.status == 0, qPrintable(outcome.complaint));
            QVERIFY(lastHash("a.burin") != before);
            QCOMPARE(test::burin({key("replay"), path("a.burin"), key("--verify")}).status, 0);
            QCOMPARE(QDir(path("")).entryList({key("*burin*")}, QDir::Files | QDir::Hidden),
                QStringList{key("a.burin")});
        }
    }

    /// Killed on the way, the old one is there.
    void aKillKeepsTheOldSession()
    {
        QCOMPARE(run(recipe("r.json", edits()), "a.burin").status, 0);
        const QByteArray old = read(path("a.burin"));
        std::vector<core::Edit> many{test::addSegment("A")};
        for (int i = 0; i < 60; ++i)
            many.push_back(test::drillAt(i % 17 - 8));
        QProcess process;
        process.start(QStringLiteral(BURIN_PROGRAM),
            {key("run"), recipe("many.json", {{key("edits"), toJson(many)}}), key("--study"),
                study(), key("--session"), path("a.burin"), key("--force")});
        int lines = 0;
        while (lines < 5 && process.waitForReadyRead(60000)) {
            while (process.canReadLine())
                lines += process.readLine().isEmpty() ? 0 : 1;
        }
        process.kill();
        process.waitForFinished();
        QVERIFY(lines >= 5);
        QCOMPARE(read(path("a.burin")), old);
    }

    void exportsWriteOverNothingThatIsRead()
    {
        const QString mine = copyOfStudy("study.nii.gz");
        const QByteArray bytes = read(mine);
        QVERIFY(QDir(path("")).mkdir(key("real")));
        QVERIFY(QFile::link(path("real"), path("linked")));
        const auto withExports = [&](const char* name, const QStringList& files) {
            QJsonArray exports;
            for (const QString& file : files)
                exports.append(QJsonObject{{key("format"), key("nifti")}, {key("file"), file}});
            QJsonObject all{{key("edits"), toJson(test::manyEdits())}};
            all[key("export")] = exports;
            return recipe(name, all);
        };
        const QString nul = path("a") + QChar::Null + key("b.nii.gz");
        const std::vector<std::pair<QStringList, const char*>> wrong{
            {{mine}, "a file of the study"},
            {{path("s.nii.gz")}, "s.nii.gz"}, // the session's own name
            {{path("real/x.nii.gz"), path("linked/x.nii.gz")}, "twice"},
            {{path("real/x.nii.gz"), path("real/../real/x.nii.gz")}, "twice"},
            {{nul}, "NUL"},
        };
        for (const auto& [files, word] : wrong) {
            const Outcome outcome =
                runOn(mine, withExports("r.json", files), path("s.nii.gz"), true);
            QVERIFY2(outcome.status == 1, word);
            QVERIFY2(
                outcome.complaint.contains(QLatin1String(word)), qPrintable(outcome.complaint));
            QCOMPARE(read(mine), bytes);
            QVERIFY2(outcome.lines.isEmpty(), word);
            QVERIFY(QDir(path("real")).isEmpty());
        }
    }

    /// A report's SEG is a file of its own, which no other export may take.
    void exportsLeaveRecipeAndReportsAlone()
    {
        test::SyntheticSeries series;
        series.size = {12, 10, 4};
        test::writeSeries(series, path("ct"));
        const QJsonObject report{{key("format"), key("sr")}, {key("file"), path("x.dcm")}};
        const QJsonObject seg{{key("format"), key("dicom-seg")}, {key("file"), path("x-seg.dcm")}};
        const std::vector<std::pair<QJsonArray, const char*>> wrong{
            {{report, seg}, "twice"},
            {{seg, report}, "twice"},
            {{QJsonObject{{key("format"), key("json")}, {key("file"), path("r.json")}}},
                "it is the recipe"},
        };
        for (const auto& [exports, word] : wrong) {
            const QString words =
                recipe("r.json", {{key("edits"), edits()[key("edits")]}, {key("export"), exports}});
            const QByteArray bytes = read(words);
            const QStringList before = QDir(path("")).entryList(QDir::AllEntries | QDir::System);
            const Outcome outcome = runOn(path("ct"), words, path("a.burin"), true);
            QVERIFY2(outcome.status == 1, word);
            QVERIFY2(
                outcome.complaint.contains(QLatin1String(word)), qPrintable(outcome.complaint));
            QVERIFY2(outcome.lines.isEmpty(), word);
            QCOMPARE(read(words), bytes);
            QCOMPARE(QDir(path("")).entryList(QDir::AllEntries | QDir::System), before);
        }
    }

    void pipesAreNotWaitedFor()
    {
        QVERIFY(::mkfifo(QFile::encodeName(path("pipe")).constData(), 0600) == 0);
        const QString words = recipe("r.json", edits());
        QCOMPARE(runOn(path("pipe"), words, path("a.burin"), false).status, 1);
        QCOMPARE(runOn(study(), path("pipe"), path("a.burin"), false).status, 1);
        for (const char* verb : {"history", "info"})
            QVERIFY2(test::burin({key(verb), path("pipe")}).status == 1, verb);
        QCOMPARE(run(words, "pipe", {key("--append")}).status, 1);
        QJsonObject mask{{key("edits"),
            QJsonArray{
                QJsonObject{{key("edit"), key("importMask")}, {key("file"), path("pipe")}}}}};
        QCOMPARE(runOn(study(), recipe("m.json", mask), path("a.burin"), false).status, 1);
    }
};

BURIN_TEST(FilesKeptGlTest)

} // namespace filesKeptGlTest

#include "FilesKeptGlTest.moc"
