// SPDX-License-Identifier: Apache-2.0
#include "core/session/EditSession.h"
#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/edits/kinds/parts/PenSample.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/edits/kinds/segments/MoveSegment.h"
#include "core/session/SessionDisplay.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/reference/DelayedEngine.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <atomic>

namespace editSessionTest {

using namespace core;

namespace {

/// A session on the oracle, told by itself or late.
struct Bench {
    explicit Bench(bool delayed = false, const QString& file = {})
        : late(inner, 7)
    {
        EditEngine& engine = delayed ? static_cast<EditEngine&>(late) : inner;
        session = *EditSession::create(engine, test::smallStudy(), {.file = file});
    }
    void run(const Edit& edit)
    {
        const Result<void> applied = session->apply(edit);
        QVERIFY2(applied, qPrintable(applied ? QString() : applied.error().arguments.join(u' ')));
        QVERIFY(session->settle());
    }
    [[nodiscard]] const HistoryRow& lastRow() const { return session->history().rows().back(); }
    [[nodiscard]] std::int64_t voxels(int label)
    {
        const std::vector<std::uint8_t> labels = *session->questions().labels(0);
        return std::count(labels.begin(), labels.end(), label);
    }

    reference::ReferenceEngine inner;
    reference::DelayedEngine late;
    std::unique_ptr<EditSession> session;
};

} // namespace

class EditSessionTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void rowsHaveNamesForPeople()
    {
        Bench bench;
        bench.run(test::addSegment("Skull"));
        QCOMPARE(bench.lastRow().name, QStringLiteral("Add segment 'Skull'"));
        bench.run(test::seedInBrain(1));
        QCOMPARE(bench.lastRow().name, QStringLiteral("Seed stroke for 'Skull', 2 voxels"));
        bench.run(test::growBrain(3));
        QCOMPARE(bench.lastRow().name,
            QStringLiteral("Grow 'Skull' 3 steps, +%1 voxels").arg(bench.voxels(1)));
        bench.run(test::growBrain());
        QVERIFY(bench.lastRow().name.startsWith(QStringLiteral("Grow ")));
        QVERIFY(
            bench.lastRow().name.contains(QRegularExpression(QStringLiteral("\\+\\d \\d{3} "))));
        bench.run(test::drillAt(0));
        QCOMPARE(bench.lastRow().name,
            QStringLiteral("Drill 5.0 mm, %1 bricks").arg(bench.lastRow().statistics.bricks));
        bench.run(ChangeSegment{.segment = 1, .name = QStringLiteral("Brain")});
        QCOMPARE(bench.lastRow().name, QStringLiteral("Rename segment 1 to 'Brain'"));
        QCOMPARE(bench.session->document().segment(1)->name, QStringLiteral("Brain"));
        bench.run(ChangeSegment{.segment = 1,
            .name = QStringLiteral("B"),
            .rgb = 0x123456,
            .code =
                CodedConcept{QStringLiteral("SCT"), QStringLiteral("1"), QStringLiteral("Brain")},
            .locked = true,
            .uncarvable = true});
        QCOMPARE(bench.lastRow().name,
            QStringLiteral("Rename segment 1 to 'B', code it as Brain, recolour it, lock it, "
                           "protect it from sculpting"));
        // What is as before is no deed.
        bench.run(ChangeSegment{
            .segment = 1, .name = QStringLiteral("B"), .rgb = 0x654321, .locked = false});
        QCOMPARE(bench.lastRow().name, QStringLiteral("Recolour segment 'B', unlock it"));
    }

    void countsVoxelsOfSegments()
    {
        Bench bench;
        for (const Edit& edit : test::manyEdits()) {
            bench.run(edit);
            for (const Segment& segment : bench.session->document().segments)
                QCOMPARE(segment.voxels, bench.voxels(segment.label));
        }
        QVERIFY(bench.session->document().segment(1)->voxels > 1000);
        QVERIFY(bench.session->document().segment(2)->voxels > 0);
        QVERIFY(bench.session->goTo(4));
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.session->document().segment(1)->voxels, bench.voxels(1));
    }

    void undoAllAndRedoAll_data()
    {
        QTest::addColumn<bool>("delayed");
        QTest::newRow("at once") << false;
        QTest::newRow("late and in bursts") << true;
    }
    void undoAllAndRedoAll()
    {
        QFETCH(bool, delayed);
        Bench bench(delayed);
        QCOMPARE(bench.session->history().rows().size(), std::size_t(0));
        std::vector<QByteArray> hashes{bench.session->stateHash()};
        for (const Edit& edit : test::manyEdits()) {
            bench.run(edit);
            hashes.push_back(bench.session->stateHash());
            QCOMPARE(bench.lastRow().stateHash, hashes.back());
        }
        const std::size_t rows = test::manyEdits().size();
        QCOMPARE(bench.session->history().rows().size(), rows);
        for (std::size_t i = 1; i < hashes.size(); ++i)
            QVERIFY(hashes[i] != hashes[i - 1]);

        for (std::size_t row = rows; row > 0; --row) {
            QVERIFY(bench.session->undo());
            QVERIFY(bench.session->settle());
            QCOMPARE(bench.session->stateHash(), hashes[row - 1]);
        }
        QVERIFY(bench.inner.fields().occupiedBricks().empty());
        QVERIFY(bench.session->document().segments.empty());
        QVERIFY(!bench.session->undo());
        for (std::size_t row = 1; row <= rows; ++row) {
            QVERIFY(bench.session->redo());
            QVERIFY(bench.session->settle());
            QCOMPARE(bench.session->stateHash(), hashes[row]);
        }
        QVERIFY(!bench.session->redo());
    }

    void nobodyHasToWait()
    {
        // The same edits and undos thrown in at once, with news taken in as it comes.
        Bench calm;
        for (const Edit& edit : test::manyEdits())
            calm.run(edit);
        QVERIFY(calm.session->undo());
        QVERIFY(calm.session->settle());

        Bench hasty(true);
        for (const Edit& edit : test::manyEdits()) {
            QVERIFY(hasty.session->apply(edit));
            hasty.session->poll();
        }
        QVERIFY(hasty.session->undo());
        QVERIFY(hasty.session->undo());
        QVERIFY(hasty.session->redo());
        QVERIFY(hasty.session->settle());
        QCOMPARE(hasty.session->stateHash(), calm.session->stateHash());
        QCOMPARE(hasty.session->history().position(), calm.session->history().position());
        for (std::size_t i = 0; i < calm.session->history().rows().size(); ++i)
            QCOMPARE(hasty.session->history().rows()[i].stateHash,
                calm.session->history().rows()[i].stateHash);
    }

    void branchesAreKept()
    {
        Bench bench;
        for (const Edit& edit :
            {Edit(test::addSegment("A")), Edit(test::drillAt(-6)), Edit(test::drillAt(6))})
            bench.run(edit);
        const QByteArray first = bench.session->stateHash();
        QVERIFY(bench.session->goTo(1));
        bench.run(test::drillAt(0));
        const QByteArray second = bench.session->stateHash();
        QCOMPARE(bench.lastRow().parent, RowId(1));
        QVERIFY(bench.session->goTo(3));
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.session->stateHash(), first);
        QVERIFY(bench.session->goTo(4));
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.session->stateHash(), second);
        QVERIFY(bench.session->goTo(0));
        QVERIFY(bench.session->settle());
        QVERIFY(bench.inner.fields().occupiedBricks().empty());
        QVERIFY(!bench.session->goTo(5));
        QVERIFY(!bench.session->goTo(-1));
    }

    void aRollbackLeavesNoTrace()
    {
        Bench bench;
        bench.run(test::addSegment("A"));
        const QByteArray before = bench.session->stateHash();
        const Edit stroke = test::drillAt(0);
        QVERIFY(bench.session->begin(test::begunStroke(stroke)));
        bench.session->extend(PenSamples{.samples = *penSamplesOf(stroke)});
        QVERIFY(bench.session->transactionOpen());
        QVERIFY(!bench.inner.fields().occupiedBricks().empty());
        bench.session->end(Ending::Rollback);
        QVERIFY(!bench.session->transactionOpen());
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.session->history().rows().size(), std::size_t(1));
        QCOMPARE(bench.session->stateHash(), before);
        QVERIFY(bench.inner.fields().occupiedBricks().empty());
    }

    void anEditThatChangesNothingLeavesNoRow()
    {
        Bench bench;
        bench.run(test::addSegment("A"));
        bench.run(ChangeSegment{.segment = 1, .name = QStringLiteral("A")});
        Edit beside = test::drillAt(0);
        for (PenSample& sample : *penSamplesOf(beside))
            sample.xMm += 500;
        bench.run(beside);
        bench.run(test::growBrain()); // no seeds
        QCOMPARE(bench.session->history().rows().size(), std::size_t(1));
        bench.run(test::drillAt(0));
        bench.run(test::drillAt(0)); // deeper below the new surface
        const std::size_t rows = bench.session->history().rows().size();
        QVERIFY(rows >= 2);
    }

    void aStrokeInPiecesEqualsTheWhole_data() { undoAllAndRedoAll_data(); }
    void aStrokeInPiecesEqualsTheWhole()
    {
        QFETCH(bool, delayed);
        Edit stroke = test::drillAt(-8);
        std::vector<PenSample>& samples = *penSamplesOf(stroke);
        for (int i = 0; i < 20; ++i)
            samples.push_back({.xMm = -5 + i * 0.517,
                .yMm = i * 0.311 - 2,
                .pressure = 0.3 + 0.03 * i,
                .tSeconds = 0.2 + 0.01 * i});
        Bench whole;
        whole.run(stroke);

        Bench pieces(delayed);
        QVERIFY(pieces.session->begin(test::begunStroke(stroke)));
        for (std::size_t i = 0; i < samples.size(); i += 3) {
            pieces.session->extend(
                PenSamples{.samples = {samples.begin() + std::ptrdiff_t(i),
                               samples.begin() + std::ptrdiff_t(std::min(i + 3, samples.size()))}});
            pieces.session->poll();
        }
        pieces.session->end(Ending::Commit);
        QVERIFY(pieces.session->settle());
        QCOMPARE(pieces.session->stateHash(), whole.session->stateHash());
        QCOMPARE(pieces.lastRow().name, whole.lastRow().name);
        QCOMPARE(penSamplesOf(pieces.lastRow().edit)->size(), samples.size());
    }

    void aRunningGrowthIsClosedByWhateverComes_data()
    {
        QTest::addColumn<int>("what");
        QTest::newRow("an edit") << 0;
        QTest::newRow("undo") << 1;
        QTest::newRow("another growth") << 2;
        QTest::newRow("saving") << 3;
        QTest::newRow("walking") << 4;
    }
    void aRunningGrowthIsClosedByWhateverComes()
    {
        QFETCH(int, what);
        Bench bench;
        bench.run(test::addSegment("Brain"));
        bench.run(test::seedInBrain(1));
        const QByteArray seeded = bench.session->stateHash();
        QVERIFY(bench.session->begin(test::growBrain()));
        bench.session->extend(GrowAdvance{.steps = 2});
        bench.session->poll();
        QVERIFY(bench.session->transactionOpen());
        if (what == 0)
            QVERIFY(bench.session->apply(test::drillAt(0)));
        else if (what == 1)
            QVERIFY(bench.session->undo());
        else if (what == 2)
            QVERIFY(bench.session->begin(test::growBrain()));
        else if (what == 4)
            QVERIFY(bench.session->goTo(0));
        QVERIFY(bench.session->settle());
        QVERIFY(!bench.session->transactionOpen());
        const HistoryRow& grown = bench.session->history().row(3);
        QCOMPARE(*growStepsOf(grown.edit), std::optional<int>(2));
        QCOMPARE(grown.growthGeneration, 3u);
        if (what == 1)
            QCOMPARE(bench.session->stateHash(), seeded);
        if (what == 2)
            QCOMPARE(bench.session->history().rows().size(), std::size_t(3));

        // What was recorded leads to the same state.
        Bench replay;
        for (const Edit& edit :
            {Edit(test::addSegment("Brain")), Edit(test::seedInBrain(1)), grown.edit})
            replay.run(edit);
        QCOMPARE(replay.session->stateHash(), grown.stateHash);
    }

    /// The window asks by the kind what stands open; what does not apply to it is ignored.
    void whatStandsOpenIsKnown()
    {
        Bench bench;
        EditSession& session = *bench.session;
        QVERIFY(!session.openEdit() && !session.openIsRefused());
        session.extend(ToSteps{2}); // nothing is open
        session.forgetPreview();
        session.closeOpen();
        bench.run(test::addSegment("Brain"));
        bench.run(test::seedInBrain(1));
        QVERIFY(session.begin(test::growBrain()));
        session.extend(GrowAdvance{.steps = 2});
        session.extend(ToDepth{1.0}); // a growth has none
        session.extend(ToSteps{-1});
        session.forgetPreview(); // it is none
        session.poll();
        QVERIFY(session.isOpen<GrowSteps>() && !session.isOpen<ShrinkSteps>());
        QVERIFY(session.transactionOpen() && !session.openIsRefused());
        session.closeOpen();
        QVERIFY(!session.openEdit() && !session.transactionOpen());
        QVERIFY(session.settle());
        QCOMPARE(session.history().rows().size(), std::size_t(3));
        QCOMPARE(*growStepsOf(bench.lastRow().edit), std::optional<int>(2));
    }

    void aGrowthSaysHowFarItCame()
    {
        // Without fresh seeds the opening adds nothing, so steps and generations agree.
        Bench bench;
        bench.run(test::addSegment("Brain"));
        bench.run(test::seedInBrain(1));
        bench.run(test::growBrain(1));
        QVERIFY(bench.session->begin(test::growBrain()));
        bench.session->extend(GrowAdvance{.steps = 2});
        bench.session->extend(GrowAdvance{.steps = 1});
        bench.session->end(Ending::Commit);
        QVERIFY(bench.session->settle());
        QCOMPARE(*growStepsOf(bench.lastRow().edit), std::optional<int>(3));
        QCOMPARE(bench.lastRow().growthGeneration, 5u);
        QVERIFY(bench.session->begin(test::growBrain()));
        bench.session->extend(GrowAdvance{});
        bench.session->end(Ending::Commit);
        QVERIFY(bench.session->settle());
        QVERIFY(!*growStepsOf(bench.lastRow().edit));
    }

    void aGrowthIsScrubbed()
    {
        Bench whole;
        Bench scrubbed;
        for (Bench* each : {&whole, &scrubbed}) {
            for (const Edit& edit : {Edit(test::addSegment("Brain")), Edit(test::seedInBrain(1)),
                     Edit(test::growBrain(6))})
                each->run(edit);
        }
        const QByteArray grown = whole.session->stateHash();
        whole.run(ShrinkSteps{.steps = 2});
        EditSession& session = *scrubbed.session;
        QVERIFY(session.begin(ShrinkSteps{.steps = 0}));
        for (const int steps : {1, 5, 100, 0, 4, 2})
            session.extend(ToSteps{steps});
        session.end(Ending::Commit);
        QVERIFY(session.settle());
        QCOMPARE(session.stateHash(), whole.session->stateHash());
        QCOMPARE(scrubbed.lastRow().edit.get<ShrinkSteps>().steps, std::optional<int>(2));
        QCOMPARE(scrubbed.lastRow().growthGeneration, whole.lastRow().growthGeneration);
        QCOMPARE(scrubbed.lastRow().name, whole.lastRow().name);
        QVERIFY(session.undo());
        QVERIFY(session.settle());
        QCOMPARE(session.stateHash(), grown);

        // There and back again, or taken back, is no step; nor is one that never moved.
        const std::size_t rows = session.history().rows().size();
        for (const Ending ending : {Ending::Commit, Ending::Rollback}) {
            QVERIFY(session.begin(ShrinkSteps{.steps = 0}));
            session.extend(ToSteps{3});
            if (ending == Ending::Commit)
                session.extend(ToSteps{0});
            session.end(ending);
            QVERIFY(session.settle());
            QCOMPARE(session.stateHash(), grown);
            QCOMPARE(session.history().rows().size(), rows);
        }
        // All the way back leaves the seeds, as "to the seeds" does.
        QVERIFY(session.begin(ShrinkSteps{.steps = 0}));
        session.extend(ToSteps{1000});
        session.closeOpen();
        QVERIFY(session.settle());
        QVERIFY(whole.session->undo());
        whole.run(ShrinkSteps{});
        QCOMPARE(session.stateHash(), whole.session->stateHash());
    }

    void undoneGrowthGrowsAgainTheSame()
    {
        Bench bench;
        for (const Edit& edit : {Edit(test::addSegment("Brain")), Edit(test::seedInBrain(1)),
                 Edit(test::growBrain(2)), Edit(test::growBrain(2))})
            bench.run(edit);
        const QByteArray hash = bench.session->stateHash();
        QVERIFY(bench.session->undo());
        bench.run(test::growBrain(2));
        QCOMPARE(bench.session->stateHash(), hash);
        QCOMPARE(bench.lastRow().id, RowId(5));
        QCOMPARE(bench.lastRow().parent, RowId(3));
    }

    void aLockedSegmentIsNeitherGrownNorOvergrown()
    {
        Bench bench;
        for (const Edit& edit :
            {Edit(test::addSegment("A")), Edit(test::addSegment("B")), Edit(test::seedInBrain(1)),
                Edit(test::growBrain(3)), Edit(ChangeSegment{.segment = 1, .locked = true})})
            bench.run(edit);
        QCOMPARE(bench.lastRow().name, QStringLiteral("Lock segment 'A'"));
        const std::int64_t locked = bench.voxels(1);
        QVERIFY(locked > 10);
        QCOMPARE(bench.session->apply(test::seedInBrain(1)).error().code, ErrorCode::SegmentLocked);
        SeedStroke beside = test::seedInBrain(2).get<SeedStroke>();
        beside.pointsLps = {beside.pointsLps.back() + glm::dvec3(6, 0, 0)};
        bench.run(beside);
        const Edit grow = test::growBy({.lower = 0, .upper = 100, .overwriteUnlocked = true});
        bench.run(grow);
        QCOMPARE(bench.voxels(1), locked);
        QVERIFY(bench.voxels(2) > 10 * locked);
        bench.run(ChangeSegment{.segment = 2, .locked = true});
        QCOMPARE(bench.session->apply(grow).error().code, ErrorCode::SegmentLocked);
        bench.run(ChangeSegment{.segment = 2, .locked = false});

        bench.run(ChangeSegment{.segment = 1, .locked = false});
        QCOMPARE(bench.lastRow().name, QStringLiteral("Unlock segment 'A'"));
        bench.run(test::seedInBone(1));
        bench.run(test::growBone());
        QVERIFY(bench.voxels(1) > locked);
    }

    void segmentsAreMovedWithinTheirList()
    {
        Bench bench;
        for (const char* name : {"A", "B", "C"})
            bench.run(test::addSegment(name));
        const auto order = [&bench] {
            QString names;
            for (const Segment& segment : bench.session->document().segments)
                names += segment.name;
            return names;
        };
        bench.run(MoveSegment{.segment = 1, .place = 2});
        QCOMPARE(order(), QStringLiteral("BAC"));
        QCOMPARE(bench.lastRow().name, QStringLiteral("Move segment 'A' to place 2"));
        bench.run(MoveSegment{.segment = 3, .place = 1});
        QCOMPARE(order(), QStringLiteral("CBA"));
        bench.run(MoveSegment{.segment = 3, .place = 99});
        QCOMPARE(order(), QStringLiteral("BAC"));
        const std::size_t rows = bench.session->history().rows().size();
        bench.run(MoveSegment{.segment = 3, .place = 3}); // it is there: no step
        QCOMPARE(bench.session->history().rows().size(), rows);
        QVERIFY(bench.session->undo());
        QVERIFY(bench.session->settle());
        QCOMPARE(order(), QStringLiteral("CBA"));
        QCOMPARE(bench.session->apply(MoveSegment{.segment = 9, .place = 1}).error().code,
            ErrorCode::UnknownSegment);
        bench.run(test::addSegment("D"));
        QCOMPARE(bench.session->document().segments.back().label, std::uint8_t(4));
    }

    void refusesBeforeAnythingChanges()
    {
        Bench bench;
        bench.run(test::addSegment("A"));
        const QByteArray before = bench.session->stateHash();
        QCOMPARE(
            bench.session->apply(test::seedInBrain(2)).error().code, ErrorCode::UnknownSegment);
        SeedStroke outside = test::seedInBrain(1).get<SeedStroke>();
        outside.pointsLps.push_back({1000, 0, 0});
        QCOMPARE(bench.session->apply(outside).error().code, ErrorCode::SeedOutsideVolume);
        QCOMPARE(bench.session->apply(test::growBetween(200, 100)).error().code,
            ErrorCode::InvalidField);
        const Edit empty = test::begunStroke(test::drillAt(0));
        QCOMPARE(bench.session->apply(empty).error().code, ErrorCode::InvalidField);
        QVERIFY(!bench.session->begin(test::seedInBrain(1)));
        QVERIFY(bench.session->begin(test::drillAt(0)));
        QVERIFY(!bench.session->begin(test::drillAt(0)));
        bench.session->end(Ending::Rollback);
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.session->history().rows().size(), std::size_t(1));
        QCOMPARE(bench.session->stateHash(), before);
    }

    void segmentsOfEditsInLineAreKnown()
    {
        Bench bench(true);
        QVERIFY(bench.session->apply(test::drillAt(0)));
        QVERIFY(bench.session->apply(test::addSegment("A")));
        QVERIFY(bench.session->apply(test::seedInBrain(1)));
        QCOMPARE(
            bench.session->apply(test::seedInBrain(2)).error().code, ErrorCode::UnknownSegment);
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.session->history().rows().size(), std::size_t(3));
    }

    void whatCannotBeToldBeforeIsToldAfter()
    {
        Bench bench(true);
        bench.run(test::addSegment("A"));
        std::vector<ErrorCode> told;
        bench.session->setErrorListener(
            [&told](const Error& error) { told.push_back(error.code); });
        QVERIFY(bench.session->apply(test::drillAt(0)));
        QVERIFY(bench.session->undo());
        QVERIFY(bench.session->undo());
        QVERIFY(bench.session->apply(test::seedInBrain(1))); // the segment is gone by then
        const Result<void> settled = bench.session->settle();
        QVERIFY(!settled);
        QCOMPARE(settled.error().code, ErrorCode::UnknownSegment);
        QCOMPARE(told, std::vector<ErrorCode>{ErrorCode::UnknownSegment});
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.session->history().rows().size(), std::size_t(2));
        QCOMPARE(bench.session->history().position(), RowId(0));
    }

    void wakesWhoeverPolls()
    {
        // Nothing but the wake-up says when to poll; that must be enough to come to the end.
        reference::ReferenceEngine oracle;
        reference::DelayedEngine late(oracle, 3);
        std::atomic<bool> woken = false;
        const auto session =
            *EditSession::create(late, test::smallStudy(), {.wakeUp = [&woken] { woken = true; }});
        for (const Edit& edit : test::manyEdits())
            QVERIFY(session->apply(edit));
        QVERIFY(session->undo());
        const std::size_t rows = test::manyEdits().size();
        const auto finished = [&] {
            const History& history = session->history();
            return history.rows().size() == rows && history.position() == RowId(rows - 1)
                && !history.rows().back().stateHash.isEmpty();
        };
        while (!finished()) {
            QTRY_VERIFY_WITH_TIMEOUT(woken, 60000);
            woken = false;
            session->poll();
        }
    }

    void tellsWhatChangedWhere()
    {
        Bench bench;
        std::vector<DocumentChange> news;
        bench.session->setListener(
            [&news](const DocumentChange& change) { news.push_back(change); });
        bench.run(test::drillAt(0));
        const auto coverage =
            std::find_if(news.begin(), news.end(), [](const DocumentChange& change) {
                return change.what == DocumentChange::What::Coverage;
            });
        QVERIFY(coverage != news.end());
        QVERIFY(!coverage->box.empty());
        QVERIFY(coverage->box.maximum.y <= 36 && coverage->box.maximum.z <= 34);
        const auto isHistory = [](const DocumentChange& change) {
            return change.what == DocumentChange::What::History;
        };
        QVERIFY(std::any_of(news.begin(), news.end(), isHistory));
        news.clear();
        QVERIFY(bench.session->undo());
        QVERIFY(bench.session->settle());
        QVERIFY(std::any_of(news.begin(), news.end(), isHistory));
        QVERIFY(std::any_of(news.begin(), news.end(), [&](const DocumentChange& change) {
            return change.what == DocumentChange::What::Coverage && !change.box.empty();
        }));
    }

    void answersQuestionsInTheirPlace()
    {
        Bench bench(true);
        QVERIFY(bench.session->apply(test::addSegment("A")));
        QVERIFY(bench.session->apply(test::seedInBrain(1)));
        QVERIFY(bench.session->apply(test::growBrain(2)));
        QVERIFY(bench.session->undo());
        std::vector<int> labels;
        const auto probe = [&] {
            bench.session->questions().probe(
                {{20, 18, 17}}, [&](const Result<std::vector<ProbedVoxel>>& probes) {
                    labels.push_back(probes->at(0).label);
                });
        };
        probe();
        QVERIFY(bench.session->redo());
        probe();
        QVERIFY(bench.session->settle());
        QCOMPARE(labels, (std::vector<int>{0, 1}));
    }

    void visibilityIsNoStep()
    {
        Bench bench;
        bench.run(test::addSegment("A"));
        const QByteArray hash = bench.session->stateHash();
        bench.session->display().setSegmentVisible(1, false);
        QVERIFY(!bench.session->document().segment(1)->visible);
        QCOMPARE(bench.session->stateHash(), hash);
        QVERIFY(bench.session->undo());
        QVERIFY(bench.session->redo());
        QVERIFY(bench.session->settle());
        QVERIFY(!bench.session->document().segment(1)->visible);
        QCOMPARE(bench.session->history().rows().size(), std::size_t(1));
    }
};

BURIN_TEST(EditSessionTest)

} // namespace editSessionTest

#include "EditSessionTest.moc"
