// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditJson.h"
#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/edits/kinds/pieces/ChangePiece.h"
#include "core/edits/kinds/pieces/CutPiece.h"
#include "core/session/EditSession.h"
#include "core/session/SessionKeyframes.h"
#include "core/sessionfile/SessionFile.h"
#include "core/study/StudyLoader.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/FileBytes.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QDateTime>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <QTest>

#include <future>

namespace historyCommandGlTest {

using namespace core;
using test::burin;
using test::goTo;
using test::key;
using test::Outcome;
using test::toJson;

namespace {

QJsonObject move(const char* name)
{
    return {{key("edit"), key(name)}};
}

} // namespace

/// `burin history`, and what `run` does with past states.
class HistoryCommandGlTest : public QObject, protected test::CommandFixture {
    Q_OBJECT

private:
    QString lastHash(const Outcome& outcome) const
    {
        return outcome.lines.isEmpty() ? QString() : outcome.lines.last()[key("hash")].toString();
    }

private Q_SLOTS:
    void initTestCase() { QVERIFY(prepareStudy()); }
    void init()
    {
        test::failOnUnexpectedMessages();
        makeFolder();
    }

    void recipesWalkAndBranch()
    {
        std::vector<Edit> edits = test::manyEdits();
        edits.resize(10);
        QJsonArray steps = toJson(edits); // rows 1 … 10
        steps.append(move("undo")); // at 9
        steps.append(move("undo")); // at 8
        steps.append(move("redo")); // at 9
        steps.append(goTo(5));
        steps.append(editToJson(test::drillAt(2))); // row 11, behind 5
        steps.append(goTo(0));
        steps.append(goTo(11));
        const Outcome outcome = run(recipe("r.json", {{key("edits"), steps}}), "a.burin");
        QVERIFY2(outcome.status == 0, qPrintable(outcome.complaint));
        QCOMPARE(outcome.lines.size(), steps.size());
        const auto hashAfter = [&outcome](int line) { return outcome.lines[line][key("hash")]; };
        QCOMPARE(hashAfter(10), hashAfter(8));
        QCOMPARE(hashAfter(11), hashAfter(7));
        QCOMPARE(hashAfter(12), hashAfter(8));
        QCOMPARE(hashAfter(13), hashAfter(4));
        QCOMPARE(hashAfter(16), hashAfter(14));
        QVERIFY(hashAfter(14) != hashAfter(5));

        const QJsonObject listing = history("a.burin");
        QCOMPARE(listing[key("position")].toInt(), 11);
        const QJsonArray commands = listing[key("commands")].toArray();
        QCOMPARE(commands.size(), 11);
        for (int i = 0; i < commands.size(); ++i) {
            const QJsonObject command = commands[i].toObject();
            const int parent = command[key("parent")].toInt();
            QCOMPARE(command[key("seq")].toInt(), i + 1);
            QCOMPARE(command[key("hashAfter")], hashAfter(i < 10 ? i : 14));
            QCOMPARE(command[key("hashBefore")],
                parent == 0 ? QJsonValue(outcome.lines[15][key("hash")])
                            : commands[parent - 1].toObject()[key("hashAfter")]);
            QVERIFY(command[key("edit")].isObject());
        }
        const QJsonArray branches = listing[key("branches")].toArray();
        QCOMPARE(branches.size(), 2);
        QCOMPARE(branches[0].toObject()[key("seqs")].toArray(), (QJsonArray{1, 2, 3, 4, 5, 11}));
        QCOMPARE(branches[0].toObject()[key("current")].toBool(), true);
        QCOMPARE(branches[1].toObject()[key("seqs")].toArray(), (QJsonArray{6, 7, 8, 9, 10}));
        QCOMPARE(branches[1].toObject()[key("forksAt")].toInt(), 5);

        const Outcome table = burin({key("history"), path("a.burin")});
        QCOMPARE(table.status, 0);
        QVERIFY(table.output.contains("branch behind row 5"));
        const Outcome replayed = burin({key("replay"), path("a.burin"), key("--verify")});
        QVERIFY2(replayed.status == 0, qPrintable(replayed.complaint));
    }

    void asRecipeEndsAtTheSameHash()
    {
        const Outcome first =
            run(recipe("r.json", {{key("edits"), toJson(test::manyEdits())}}), "a.burin");
        QCOMPARE(first.status, 0);
        const Outcome again = run(recipeOf("a.burin", "again.json"), "b.burin");
        QVERIFY2(again.status == 0, qPrintable(again.complaint));
        QCOMPARE(lastHash(again), lastHash(first));
    }

    void undoOnlyFindsItsRowsUnderNewNumbers()
    {
        QJsonArray steps = toJson({test::addSegment("A"), test::drillAt(-6)}); // rows 1, 2
        steps.append(move("undo"));
        for (const QJsonValue& step : toJson({test::drillAt(5), test::seedInBrain(1),
                 test::growBrain(2), test::revertRows({3})})) // rows 3 … 6, behind 1
            steps.append(step);
        const Outcome first = run(recipe("r.json", {{key("edits"), steps}}), "a.burin");
        QVERIFY2(first.status == 0, qPrintable(first.complaint));
        QCOMPARE(history("a.burin")[key("position")].toInt(), 6);
        const QJsonArray seeds = toJson({test::revertRows({4})});
        const Outcome refused =
            run(recipe("s.json", {{key("edits"), seeds}}), "a.burin", {key("--append")});
        QCOMPARE(refused.status, 1);
        QVERIFY2(refused.complaint.contains("(row 5) wrote"), qPrintable(refused.complaint));
        QCOMPARE(history("a.burin")[key("position")].toInt(), 6);

        const Outcome verified = burin({key("replay"), path("a.burin"), key("--verify")});
        QVERIFY2(verified.status == 0, qPrintable(verified.complaint));
        const Outcome past = burin({key("replay"), path("a.burin"), key("--to"), key("6"),
            key("--export"), path("past.nii.gz")});
        QVERIFY2(past.status == 0, qPrintable(past.complaint));

        const Outcome written = burin({key("history"), path("a.burin"), key("--as-recipe")});
        QVERIFY(written.output.contains("revert"));
        QFile file(path("again.json"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(written.output);
        file.close();
        const Outcome again = run(file.fileName(), "b.burin");
        QVERIFY2(again.status == 0, qPrintable(again.complaint));
        QCOMPARE(lastHash(again), lastHash(first));
    }

    void rowsSayWhoWhenAndWithWhat()
    {
        const QDateTime before = QDateTime::currentDateTimeUtc();
        const QString file =
            recipe("r.json", {{key("edits"), toJson({test::addSegment("A"), test::drillAt(0)})}});
        QCOMPARE(run(file, "a.burin", {key("--author"), key("  Dr. A ")}).status, 0);
        const QString more = recipe("s.json", {{key("edits"), toJson({test::addSegment("B")})}});
        QCOMPARE(run(more, "a.burin", {key("--append")}).status, 0);
        const QJsonArray commands = history("a.burin")[key("commands")].toArray();
        QCOMPARE(commands.size(), 3);
        QDateTime last = before;
        for (int i = 0; i < 3; ++i) {
            const QJsonObject command = commands[i].toObject();
            const QString text = command[key("at")].toString();
            const QDateTime at = QDateTime::fromString(text, Qt::ISODateWithMs);
            QVERIFY2(text.size() == 24 && text.endsWith(u'Z'), qPrintable(text));
            QVERIFY(at >= last && at <= QDateTime::currentDateTimeUtc());
            last = at;
            QCOMPARE(command[key("author")].toString(), i < 2 ? key("Dr. A") : QString());
            QCOMPARE(QByteArray(command[key("program")].toString().toLatin1() + '\n'),
                burin({key("--version")}).output);
        }
        QCOMPARE(run(more, "b.burin", {key("--author")}).status, 2);
        // When and by whom is no part of what the state is.
        QCOMPARE(run(file, "c.burin").status, 0);
        QCOMPARE(history("c.burin")[key("commands")].toArray()[1].toObject()[key("hashAfter")],
            commands[1].toObject()[key("hashAfter")]);
    }

    void reportsNeedNoDisplay()
    {
        const bool hadDisplay = qEnvironmentVariableIsSet("DISPLAY");
        const QByteArray display = qgetenv("DISPLAY");
        const QByteArray platform = qgetenv("QT_QPA_PLATFORM");
        qunsetenv("DISPLAY");
        qunsetenv("QT_QPA_PLATFORM");
        const auto back = qScopeGuard([&] {
            if (hadDisplay)
                qputenv("DISPLAY", display);
            if (!platform.isEmpty())
                qputenv("QT_QPA_PLATFORM", platform);
        });
        QJsonArray steps = toJson(test::manyEdits());
        steps.append(goTo(4));
        steps.append(editToJson(test::drillAt(1)));
        QCOMPARE(run(recipe("r.json", {{key("edits"), steps}}), "a.burin",
                     {key("--author"), key("Dr. <A>")})
                     .status,
            0);
        const auto report = [this](const char* file, const QStringList& more = {}) {
            return burin(
                QStringList{key("history"), path("a.burin"), key("--report"), path(file)} + more);
        };
        for (const char* name : {"a.html", "a.pdf"}) {
            const Outcome made = report(name);
            QVERIFY2(made.status == 0, qPrintable(made.complaint));
            const Outcome again = report(name);
            QCOMPARE(again.status, 1);
            QVERIFY2(again.complaint.contains(path(name)), qPrintable(again.complaint));
            QCOMPARE(report(name, {key("--force")}).status, 0);
        }
        QFile html(path("a.html"));
        QVERIFY(html.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(html.readAll());
        for (const char* words : {"Dr. &lt;A&gt;", "Undo only ", "old future, behind step 4",
                 "This history is whole", "<img "})
            QVERIFY2(text.contains(key(words)), words);
        QVERIFY(!text.contains(key("taken back"))); // what undid step 8 lies on the old future too
        const Outcome nowhere = report("no/such/folder.pdf");
        QCOMPARE(nowhere.status, 1);
        QVERIFY2(nowhere.complaint.contains(path("no/such")), qPrintable(nowhere.complaint));
        QCOMPARE(report("a.txt").status, 2);
        QCOMPARE(report("b.pdf", {key("--json")}).status, 2);
        const Outcome noSession = burin({key("history"), study(), key("--report"), path("c.pdf")});
        QCOMPARE(noSession.status, 1);
        QVERIFY(noSession.complaint.contains(study()));
        QVERIFY(!QFile::exists(path("c.pdf")) && !QFile::exists(path("b.pdf")));
    }

    /// As the window's report does, where the study is at hand.
    void reportsTellVolumesWhereAsked()
    {
        const QString made = recipe("r.json", {{key("edits"), toJson(test::manyEdits())}});
        QCOMPARE(run(made, "a.burin").status, 0);
        const auto report = [this](const char* file, const QStringList& more = {}) {
            const Outcome outcome = burin(
                QStringList{key("history"), path("a.burin"), key("--report"), path(file)} + more);
            return std::pair(outcome.status, QString::fromUtf8(test::bytesOf(path(file))));
        };
        const auto plain = report("plain.html");
        QVERIFY(plain.first == 0 && !plain.second.contains(key("As they stand after step ")));
        const auto measured = report("measured.html", {key("--volumes")});
        QCOMPARE(measured.first, 0);
        for (const char* words : {"As they stand after step ", "Brain", " mL, "})
            QVERIFY2(measured.second.contains(key(words)), words);
        const auto nowhere = report("no.html", {key("--volumes"), key("--study"), path("nowhere")});
        QVERIFY(nowhere.first == 1 && nowhere.second.isEmpty());
        QCOMPARE(report("no.html", {key("--study"), study()}).first, 2);
        QCOMPARE(burin({key("history"), path("a.burin"), key("--volumes")}).status, 2);
    }

    /// By the window's rule: after the first step, after every ten, at the end.
    void sessionsHavePictures()
    {
        std::vector<Edit> edits = test::manyEdits();
        QVERIFY(edits.size() >= 11);
        edits.resize(11);
        QJsonArray steps = toJson(edits);
        steps.append(goTo(6));
        QCOMPARE(run(recipe("r.json", {{key("edits"), steps}}), "a.burin").status, 0);
        reference::ReferenceEngine oracle;
        const auto session = EditSession::view(
            oracle, *loadVolume(study()), path("a.burin"), QStringLiteral("a test looks at it"));
        QVERIFY(session);
        QCOMPARE((*session)->keyframes().rows(), (std::vector<RowId>{1, 6, 11}));
        std::vector<QImage> pictures;
        for (const RowId row : {1, 6, 11}) {
            std::promise<QByteArray> png;
            (*session)->keyframes().fetch(
                row, [&png](const QByteArray& fetched) { png.set_value(fetched); });
            pictures.push_back(QImage::fromData(png.get_future().get(), "PNG"));
            QCOMPARE(pictures.back().size(), QSize(256, 192));
            // The ball stands in the middle, and nothing in the corner.
            QVERIFY(pictures.back().pixel(128, 96) != pictures.back().pixel(2, 2));
        }
        QVERIFY(pictures[0] != pictures[2]);
        const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS");
        if (!folder.isEmpty())
            QVERIFY(pictures[2].save(folder + QStringLiteral("/run-keyframe.png")));

        // One that goes on has pictures already, and gets one at its end.
        const QString more = recipe("s.json", {{key("edits"), toJson({test::drillAt(4)})}});
        QCOMPARE(
            burin({key("run"), more, key("--session"), path("a.burin"), key("--append")}).status,
            0);
        const auto file = SessionFile::open(path("a.burin"), SessionFile::Access::ReadOnly);
        QCOMPARE((*file)->contents().keyframes.size(), std::size_t(4));
        QCOMPARE((*file)->contents().keyframes.back().row, RowId(12));
    }

    /// Pieces are part of what is seen: one that was moved beside the head is in the picture.
    void picturesShowPieces()
    {
        const Edit drill = test::drillAt(0);
        const auto pictureAt = [this](const char* name, const std::vector<Edit>& edits) {
            if (run(recipe("p.json", {{key("edits"), toJson(edits)}}), name).status != 0)
                qFatal("not carried out");
            reference::ReferenceEngine oracle;
            const auto session = EditSession::view(
                oracle, *loadVolume(study()), path(name), QStringLiteral("a test looks at it"));
            std::promise<QByteArray> png;
            (*session)->keyframes().fetch((*session)->history().position(),
                [&png](const QByteArray& fetched) { png.set_value(fetched); });
            return QImage::fromData(png.get_future().get(), "PNG");
        };
        const Edit half =
            test::carveAt({test::factsOfStroke(drill).view.targetLps + glm::dvec3(0, 0, 14)}, 14.0);
        const Edit lift = CutPiece{.layer = 1, .name = QStringLiteral("Cap")};
        const QImage cut = pictureAt("cut.burin", {half, lift, test::addSegment("A")});
        const QImage away = pictureAt(
            "away.burin", {half, lift, ChangePiece{.piece = 1, .offsetMm = glm::dvec3(0, 0, 6)}});
        const auto lit = [](const QImage& image) {
            int count = 0;
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    count += qGray(image.pixel(x, y)) > 60 ? 1 : 0;
            return count;
        };
        // At home it fills the cut, above it stands out.
        QVERIFY2(lit(cut) > 1000 && lit(away) > lit(cut) + 100,
            qPrintable(QStringLiteral("%1 and %2").arg(lit(cut)).arg(lit(away))));
    }

    void imagesTravelWithTheSession()
    {
        const QString copied = path("case.nii.gz");
        QVERIFY(QFile::copy(study(), copied));
        const QString edits = recipe("r.json", {{key("edits"), toJson(test::manyEdits())}});
        const QStringList words{key("run"), edits, key("--study"), copied, key("--session"),
            path("a.burin"), key("--with-images")};
        const Outcome made = burin(words);
        QVERIFY2(made.status == 0, qPrintable(made.complaint));
        QCOMPARE(lastHash(made), lastHash(run(edits, "plain.burin")));
        QCOMPARE(burin(words).status, 1); // it is there already
        QCOMPARE(burin(words + QStringList{key("--force")}).status, 0);
        QCOMPARE(burin({key("run"), edits, key("--session"), path("a.burin"), key("--append"),
                           key("--with-images")})
                     .status,
            2);

        QVERIFY(QFile::remove(copied));
        const Outcome replayed = burin({key("replay"), path("a.burin"), key("--verify"),
            key("--export"), path("mask.nii.gz")});
        QVERIFY2(replayed.status == 0, qPrintable(replayed.complaint));
        QVERIFY2(replayed.complaint.contains(
                     QStringLiteral("no longer at %1; the images that the session holds are used")
                         .arg(copied)),
            qPrintable(replayed.complaint));
        QVERIFY(QFile::exists(path("mask.nii.gz")));
        const Outcome seg = burin({key("replay"), path("a.burin"), key("--export"), path("m.dcm")});
        QCOMPARE(seg.status, 1);
        QVERIFY2(seg.complaint.contains(QStringLiteral("not read from DICOM images")),
            qPrintable(seg.complaint));
        const Outcome appended =
            burin({key("run"), recipe("s.json", {{key("edits"), toJson({test::drillAt(4)})}}),
                key("--session"), path("a.burin"), key("--append")});
        QVERIFY2(appended.status == 0, qPrintable(appended.complaint));
        const Outcome plain = burin({key("replay"), path("plain.burin"), key("--verify")});
        QCOMPARE(plain.status, 0);
        QVERIFY(!plain.complaint.contains(QStringLiteral("images that")));
    }

    void appendGoesOn()
    {
        const std::vector<Edit> all = test::manyEdits();
        const std::vector<Edit> start(all.begin(), all.begin() + 4);
        const std::vector<Edit> rest(all.begin() + 4, all.end());
        const Outcome whole = run(recipe("w.json", {{key("edits"), toJson(all)}}), "whole.burin");
        QCOMPARE(run(recipe("s.json", {{key("edits"), toJson(start)}}), "a.burin").status, 0);
        // The session knows its study.
        const Outcome appended =
            burin({key("run"), recipe("t.json", {{key("edits"), toJson(rest)}}), key("--session"),
                path("a.burin"), key("--append")});
        QVERIFY2(appended.status == 0, qPrintable(appended.complaint));
        QCOMPARE(appended.lines.first()[key("row")].toInt(), 5);
        QCOMPARE(lastHash(appended), lastHash(whole));

        const Outcome missing = burin(
            {key("run"), path("t.json"), key("--session"), path("none.burin"), key("--append")});
        QCOMPARE(missing.status, 1);
        QVERIFY(missing.complaint.contains(key("none.burin")));
        QCOMPARE(run(path("t.json"), "a.burin", {key("--append"), key("--force")}).status, 2);
    }

    void whatFailsLaterLeavesWhatWasPrinted()
    {
        QCOMPARE(run(recipe("s.json", {{key("edits"), toJson({test::addSegment("A")})}}), "a.burin")
                     .status,
            0);
        QJsonArray steps = toJson({test::addSegment("B")});
        steps.append(goTo(99));
        const Outcome outcome =
            run(recipe("t.json", {{key("edits"), steps}}), "a.burin", {key("--append")});
        QCOMPARE(outcome.status, 1);
        QVERIFY2(outcome.complaint.contains(key("99")), qPrintable(outcome.complaint));
        QCOMPARE(outcome.lines.size(), 1);
        QCOMPARE(history("a.burin")[key("commands")].toArray().size(), 2);

        // A recipe that is known to be wrong from the start changes nothing.
        const QJsonArray wrong = toJson({test::addSegment("C"), test::seedInBrain(9)});
        QCOMPARE(
            run(recipe("t.json", {{key("edits"), wrong}}), "a.burin", {key("--append")}).status, 1);
        QCOMPARE(history("a.burin")[key("commands")].toArray().size(), 2);
    }

    void runTellsOfStrokesOnARevisedSurface()
    {
        const ReviseStroke removed{.row = 1, .removed = true};
        const Outcome above = run(recipe("r.json",
                                      {{key("edits"),
                                          toJson({test::drillAt(0), test::drillAt(0),
                                              test::drillAt(-13), test::drillAt(0), removed})}}),
            "a.burin");
        QVERIFY2(above.status == 0, qPrintable(above.complaint));
        QCOMPARE(above.lines.size(), 5);
        QCOMPARE(above.lines[4][key("begunOnItsSurface")].toArray(), (QJsonArray{2, 4}));
        QVERIFY(!above.lines[3].contains(key("begunOnItsSurface")));
        QVERIFY2(above.complaint.contains(key(
                     "2 later strokes began on the surface that this changed; they keep their")),
            qPrintable(above.complaint));
        const Outcome beside =
            run(recipe("s.json",
                    {{key("edits"), toJson({test::drillAt(-10), test::drillAt(5), removed})}}),
                "b.burin");
        QVERIFY2(beside.status == 0, qPrintable(beside.complaint));
        QCOMPARE(beside.lines[2][key("begunOnItsSurface")], QJsonValue(QJsonArray()));
        QVERIFY2(beside.complaint.isEmpty(), qPrintable(beside.complaint));
    }

    void badMovesAreNamed_data()
    {
        QTest::addColumn<QJsonObject>("step");
        QTest::addColumn<QString>("named");
        QTest::newRow("goTo without seq") << move("goTo") << key("goTo.seq");
        QTest::newRow("half a row")
            << QJsonObject{{key("edit"), key("goTo")}, {key("seq"), 1.5}} << key("goTo.seq");
        QTest::newRow("undo with more")
            << QJsonObject{{key("edit"), key("undo")}, {key("times"), 2}} << key("undo.times");
        QTest::newRow("nothing to undo")
            << move("undo") << key("r.json: undo: the history is at its beginning (edit 1)");
        QTest::newRow("nothing to redo")
            << move("redo") << key("r.json: redo: the history is at its end (edit 1)");
        QTest::newRow("no such row") << goTo(7) << key("goTo: the history has no row 7");
    }
    void badMovesAreNamed()
    {
        QFETCH(QJsonObject, step);
        QFETCH(QString, named);
        const Outcome outcome =
            run(recipe("r.json", {{key("edits"), QJsonArray{step}}}), "a.burin");
        QCOMPARE(outcome.status, 1);
        QVERIFY2(outcome.complaint.contains(named), qPrintable(outcome.complaint));
        QVERIFY(!QFile::exists(path("a.burin")));
    }

    void aDeidentifiedCopyDoesNotTakeItsPlace()
    {
        const QJsonArray edits = toJson({test::addSegment("A")});
        QCOMPARE(run(recipe("r.json", {{key("edits"), edits}}), "a.burin").status, 0);
        const QByteArray before = test::bytesOf(path("a.burin"));
        const Outcome outcome = burin({key("history"), path("a.burin"), key("--deidentified"),
            path("a.burin"), key("--force")});
        QCOMPARE(outcome.status, 1);
        QCOMPARE(test::bytesOf(path("a.burin")), before);
    }

    void historyRefusesWhatIsNoSession()
    {
        QFile empty(path("empty.burin"));
        QVERIFY(empty.open(QIODevice::WriteOnly));
        empty.close();
        for (const QString& file : {path("none.burin"), path("empty.burin"), study()}) {
            const Outcome outcome = burin({key("history"), file, key("--json")});
            QCOMPARE(outcome.status, 1);
            QVERIFY2(outcome.complaint.contains(file), qPrintable(outcome.complaint));
            QCOMPARE(outcome.complaint.count(QLatin1Char('\n')), 1);
        }
        QCOMPARE(burin({key("history")}).status, 2);
        QCOMPARE(burin({key("history"), path("x"), key("--json"), key("--as-recipe")}).status, 2);
    }
};

BURIN_TEST(HistoryCommandGlTest)

} // namespace historyCommandGlTest

#include "HistoryCommandGlTest.moc"
