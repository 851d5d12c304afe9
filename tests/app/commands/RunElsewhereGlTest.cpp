// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/pieces/ChangePiece.h"
#include "core/edits/kinds/pieces/CutPiece.h"
#include "core/edits/kinds/pieces/PastePiece.h"
#include "core/edits/kinds/pieces/RemovePiece.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/edits/kinds/segments/LayerToSegment.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/CommandFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QFile>
#include <QJsonDocument>
#include <QTest>

namespace runElsewhereGlTest {

using namespace core;
using test::burin;
using test::key;
using test::Outcome;
using test::toJson;

/// `burin run --apply-elsewhere`.
class RunElsewhereGlTest : public QObject, protected test::CommandFixture {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY(prepareStudy()); }
    void init()
    {
        test::failOnUnexpectedMessages();
        makeFolder();
    }

    void aRecipeOfAnotherStudyAsksFirst()
    {
        QCOMPARE(
            run(recipe("r.json", {{key("edits"), toJson(test::manyEdits())}}), "a.burin").status,
            0);
        const QString file = recipeOf("a.burin", "again.json");
        LoadedVolume other = test::smallStudy();
        other.codes[0] += 1;
        const QString study = otherStudy("other.nii.gz", other);
        const QStringList arguments{
            key("run"), file, key("--study"), study, key("--session"), path("b.burin")};

        const Outcome asked = burin(arguments);
        QCOMPARE(asked.status, 1);
        QVERIFY2(asked.complaint.contains(key("2 addSegment")), qPrintable(asked.complaint));
        QVERIFY2(asked.complaint.contains(key("2 drill")), qPrintable(asked.complaint));
        QVERIFY(!QFile::exists(path("b.burin")));

        const Outcome done = burin(arguments + QStringList{key("--apply-elsewhere")});
        QVERIFY2(done.status == 0, qPrintable(done.complaint));
        for (const QJsonObject& line : done.lines)
            QVERIFY(line[key("edit")] != key("drill") && line[key("edit")] != key("seed"));
        QCOMPARE(history("b.burin")[key("commands")].toArray().size(), 3);
    }

    void elsewhereNothingActsOnAnotherSegment()
    {
        const std::vector<Edit> edits{test::drillAt(0),
            LayerToSegment{.layer = 1, .target = {.segment = {}, .name = key("Cap"), .rgb = 1}},
            test::addSegment("Bone"), test::addSegment("Skin"),
            ChangeSegment{.segment = 2, .name = key("Bone, done"), .locked = true},
            CutPiece{.layer = 1, .name = key("P"), .pivotLps = glm::dvec3(1.0)},
            ChangePiece{.piece = 1, .offsetMm = glm::dvec3(9.0, 0.0, 0.0)},
            PastePiece{.segment = 1, .name = key("Q")}, RemovePiece{.piece = 2}};
        QCOMPARE(run(recipe("r.json", {{key("edits"), toJson(edits)}}), "a.burin").status, 0);
        const QString file = recipeOf("a.burin", "again.json");
        LoadedVolume other = test::smallStudy();
        other.codes[0] += 1;
        const QString study = otherStudy("other2.nii.gz", other);

        const Outcome done = burin({key("run"), file, key("--study"), study, key("--session"),
            path("b.burin"), key("--apply-elsewhere")});
        QVERIFY2(done.status == 0, qPrintable(done.complaint));
        for (const char* told :
            {"edit 7 (changePiece): the piece that edit 6 (cutPiece) makes is not here",
                "edit 8 (pastePiece) is skipped: the segment that edit 2 (layerToSegment) makes",
                "edit 9 (removePiece) is skipped: the piece that edit 8 (pastePiece) makes"})
            QVERIFY2(done.complaint.contains(key(told)), qPrintable(done.complaint));
        const QJsonArray commands = history("b.burin")[key("commands")].toArray();
        QCOMPARE(commands.size(), 3);
        QCOMPARE(
            commands[0].toObject()[key("edit")].toObject()[key("name")].toString(), key("Bone"));
        QCOMPARE(commands[2].toObject()[key("edit")].toObject()[key("segment")].toInt(), 1);

        // A session that goes on has numbers of its own.
        const QString own = recipe("s.json", {{key("edits"), toJson({test::addSegment("Own")})}});
        QCOMPARE(burin({key("run"), own, key("--study"), study, key("--session"), path("c.burin")})
                     .status,
            0);
        const Outcome appended = burin({key("run"), file, key("--session"), path("c.burin"),
            key("--append"), key("--apply-elsewhere")});
        QVERIFY2(appended.status == 0, qPrintable(appended.complaint));
        const QJsonArray four = history("c.burin")[key("commands")].toArray();
        QCOMPARE(four.size(), 4);
        QCOMPARE(four[3].toObject()[key("edit")].toObject()[key("segment")].toInt(), 2);
    }
};

BURIN_TEST(RunElsewhereGlTest)

} // namespace runElsewhereGlTest

#include "RunElsewhereGlTest.moc"
