// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/layers/AddLayer.h"
#include "core/edits/kinds/layers/ChangeLayer.h"
#include "core/edits/kinds/layers/MoveLayer.h"
#include "core/edits/kinds/pieces/ChangePiece.h"
#include "core/edits/kinds/pieces/CutPiece.h"
#include "core/edits/kinds/pieces/RemovePiece.h"
#include "core/edits/kinds/pieces/SendPiecesHome.h"
#include "core/edits/kinds/views/Bookmarks.h"
#include "core/session/EditSession.h"
#include "tests/reference/DelayedEngine.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTemporaryDir>
#include <QTest>

namespace sculptLayersTest {

using namespace core;

namespace {

struct Bench {
    explicit Bench(const std::vector<Edit>& edits, bool delayed = false, const QString& file = {})
        : late(inner, 13)
    {
        EditEngine& engine = delayed ? static_cast<EditEngine&>(late) : inner;
        session = *EditSession::create(engine, test::smallStudy(), {.file = file});
        for (const Edit& edit : edits)
            run(edit);
    }
    void run(const Edit& edit)
    {
        const Result<void> applied = session->apply(edit);
        QVERIFY2(applied, qPrintable(applied ? QString() : applied.error().arguments.join(u' ')));
        QVERIFY(session->settle());
    }
    [[nodiscard]] QString lastName() const { return session->history().rows().back().name; }
    [[nodiscard]] std::vector<std::uint8_t> coverage(std::uint8_t layer) const
    {
        reference::DenseFields fields = inner.fields();
        return fields.coverage(layer).values;
    }
    [[nodiscard]] bool anythingCarved() const
    {
        for (const std::uint8_t value : inner.carved().values) {
            if (value >= 128)
                return true;
        }
        return false;
    }

    reference::ReferenceEngine inner;
    reference::DelayedEngine late;
    std::unique_ptr<EditSession> session;
};

Edit drillInto(int layer)
{
    return test::drillWith({.layer = layer}, test::drillAt(0));
}

Edit mute(int layer, bool muted = true)
{
    return ChangeLayer{.layer = layer, .muted = muted};
}

const Edit second = AddLayer{.name = QStringLiteral("Approach")};

} // namespace

class SculptLayersTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void changesOfPiecesNameAllThatChanged()
    {
        Bench bench({second});
        bench.run(CutPiece{.layer = 1, .name = QStringLiteral("P")});
        bench.run(ChangePiece{.piece = 1,
            .name = QStringLiteral("Q"),
            .offsetMm = glm::dvec3(50.0, 0.0, 0.0),
            .zoom = 3.0});
        QCOMPARE(bench.lastName(),
            QStringLiteral("Rename piece 'P' to 'Q', move it 50.0 mm, zoom it 3×"));
        bench.run(ChangePiece{
            .piece = 1, .name = QStringLiteral("P"), .offsetMm = glm::dvec3(0.0), .zoom = 1.0});
        QCOMPARE(bench.lastName(), QStringLiteral("Rename piece 'Q' to 'P', send it home"));
    }

    void rowsHaveNamesForPeople()
    {
        Bench bench({second});
        QCOMPARE(bench.lastName(), QStringLiteral("Add layer 'Approach'"));
        bench.run(mute(2));
        QCOMPARE(bench.lastName(), QStringLiteral("Mute layer 'Approach'"));
        bench.run(mute(2, false));
        QCOMPARE(bench.lastName(), QStringLiteral("Unmute layer 'Approach'"));
        bench.run(ChangeLayer{.layer = 2, .name = QStringLiteral("Way in")});
        QCOMPARE(bench.lastName(), QStringLiteral("Rename layer 'Approach' to 'Way in'"));
        bench.run(
            ChangeLayer{.layer = 2, .name = QStringLiteral("In"), .muted = true, .solo = true});
        QCOMPARE(
            bench.lastName(), QStringLiteral("Rename layer 'Way in' to 'In', solo it, mute it"));
        bench.run(ChangeLayer{
            .layer = 2, .name = QStringLiteral("Way in"), .muted = false, .solo = false});
        bench.run(MoveLayer{.layer = 2, .place = 1});
        QCOMPARE(bench.lastName(), QStringLiteral("Move layer 'Way in' to place 1"));
        bench.run(drillInto(2));
        QVERIFY(bench.lastName().startsWith(QStringLiteral("Drill 5.0 mm")));
        AddBookmark bookmark;
        bookmark.name = QStringLiteral("Orbit from the left");
        bookmark.view = test::frontView();
        bench.run(bookmark);
        QCOMPARE(bench.lastName(), QStringLiteral("Bookmark 'Orbit from the left'"));
        bench.run(RemoveBookmark{.bookmark = 1});
        QCOMPARE(bench.lastName(), QStringLiteral("Remove bookmark 'Orbit from the left'"));

        bench.run(CutPiece{.layer = 2, .name = QStringLiteral("Skull cap")});
        QCOMPARE(bench.lastName(), QStringLiteral("Lift 'Skull cap' off layer 'Way in'"));
        bench.run(ChangePiece{.piece = 1, .offsetMm = glm::dvec3(0, 0, 42)});
        QCOMPARE(bench.lastName(), QStringLiteral("Move piece 'Skull cap' 42.0 mm"));
        bench.run(ChangePiece{.piece = 1, .rotationDegrees = glm::dvec3(0, 30.4, 0), .zoom = 1.5});
        QCOMPARE(bench.lastName(), QStringLiteral("Turn piece 'Skull cap' 30°, zoom it 1.5×"));
        bench.run(SendPiecesHome{});
        QCOMPARE(bench.lastName(), QStringLiteral("Send all pieces home"));
        bench.run(RemovePiece{.piece = 1});
        QCOMPARE(bench.lastName(), QStringLiteral("Remove piece 'Skull cap'"));
    }

    void whatChangesNothingLeavesNoRow()
    {
        Bench bench({second, mute(2)});
        const QByteArray before = bench.session->stateHash();
        bench.run(mute(2));
        bench.run(mute(1, false));
        bench.run(ChangeLayer{.layer = 1, .name = QStringLiteral("Sculpt 1")});
        bench.run(MoveLayer{.layer = 1, .place = 1});
        bench.run(MoveLayer{.layer = 2, .place = 7});
        QCOMPARE(bench.session->history().rows().size(), std::size_t(2));
        QCOMPARE(bench.session->stateHash(), before);
    }

    /// A stroke sees what is carved in all layers that are not muted, and nothing else.
    void aMutedLayerIsAbsent_data()
    {
        QTest::addColumn<bool>("delayed");
        QTest::newRow("at once") << false;
        QTest::newRow("late and in bursts") << true;
    }
    void aMutedLayerIsAbsent()
    {
        QFETCH(bool, delayed);
        const auto alone = Bench({second, drillInto(2)}).coverage(2);
        const auto deeper = Bench({second, drillInto(1), drillInto(2)}).coverage(2);
        QVERIFY(alone != deeper);

        Bench bench({second, drillInto(1), mute(1)}, delayed);
        QVERIFY(!bench.anythingCarved());
        bench.run(drillInto(2));
        QVERIFY(bench.coverage(2) == alone);
        bench.run(mute(1, false));
        // Undo mutes it again, for the branch that begins there.
        QVERIFY(bench.session->undo());
        QVERIFY(bench.session->undo());
        bench.run(drillInto(2));
        QVERIFY(bench.coverage(2) == alone);
        // Back to where it was not muted yet.
        QVERIFY(bench.session->goTo(2));
        bench.run(drillInto(2));
        QVERIFY(bench.coverage(2) == deeper);
        QVERIFY(bench.session->goTo(3));
        QVERIFY(bench.session->settle());
        QVERIFY(!bench.anythingCarved());
    }

    void theHastyAreNoException()
    {
        const std::vector<Edit> edits{second, drillInto(1), mute(1), drillInto(2), mute(1, false),
            drillInto(2), mute(2), drillInto(1)};
        const Bench calm(edits);
        Bench hasty({}, true);
        for (const Edit& edit : edits)
            QVERIFY(hasty.session->apply(edit));
        QVERIFY(hasty.session->settle());
        QCOMPARE(hasty.session->stateHash(), calm.session->stateHash());
    }

    void strokesIntoWhatIsNotSeenAreRefused()
    {
        Bench bench({second, mute(2)});
        for (const int layer : {2, 3}) {
            const Result<void> applied = bench.session->apply(drillInto(layer));
            QVERIFY(!applied);
            QCOMPARE(applied.error().arguments.value(0), QStringLiteral("drill.layer"));
            QVERIFY(!bench.session->begin(test::begunStroke(drillInto(layer))));
        }
        QVERIFY(!bench.session->transactionOpen());
        bench.run(drillInto(1));
    }

    void standsInTheFile()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("layers.burin"));
        const std::vector<Edit> edits{
            second, drillInto(1), drillInto(2), mute(1), MoveLayer{.layer = 2, .place = 1}};
        QByteArray hash;
        {
            const Bench bench(edits, false, file);
            hash = bench.session->stateHash();
        }
        reference::ReferenceEngine engine;
        {
            auto session = EditSession::open(engine, test::smallStudy(), file);
            QVERIFY(session);
            QCOMPARE((*session)->stateHash(), hash);
            QVERIFY((*session)->document().layer(1)->muted);
            // The engine was told too.
            QVERIFY((*session)->apply(drillInto(2)));
            QVERIFY((*session)->settle());
            hash = (*session)->stateHash();
        }
        std::vector<Edit> all = edits;
        all.push_back(drillInto(2));
        QCOMPARE(Bench(all).session->stateHash(), hash);
        // Another session on the same engine begins with nothing muted.
        auto fresh = EditSession::create(engine, test::smallStudy(), {});
        QVERIFY(fresh);
        QVERIFY((*fresh)->apply(drillInto(1)));
        QVERIFY((*fresh)->settle());
        QCOMPARE((*fresh)->stateHash(), Bench({drillInto(1)}).session->stateHash());
    }

    /// A stroke may have begun in the cut of another layer: that one cannot be taken back alone.
    void layersHoldEachOtherWhereTheyMeet()
    {
        Bench bench({second, drillInto(1), drillInto(2)});
        const QByteArray before = bench.session->stateHash();
        QVERIFY(bench.session->apply(test::revertRows({2})));
        const Result<void> done = bench.session->settle();
        QVERIFY(!done);
        QCOMPARE(done.error().code, ErrorCode::StepsEntangled);
        QCOMPARE(bench.session->stateHash(), before);
        bench.run(test::revertRows({3})); // the later one can
        QCOMPARE(bench.session->stateHash(), Bench({second, drillInto(1)}).session->stateHash());
    }
};

BURIN_TEST(SculptLayersTest)

} // namespace sculptLayersTest

#include "SculptLayersTest.moc"
