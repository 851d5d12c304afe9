// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditJson.h"
#include "core/edits/kinds/filling/FillBetweenSlices.h"
#include "core/edits/kinds/filling/MirrorSegment.h"
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/CombineSegments.h"
#include "core/edits/kinds/segments/InvertSegment.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/splitting/CopySegment.h"
#include "core/edits/kinds/splitting/SplitIslands.h"
#include "core/edits/kinds/splitting/SplitSegment.h"
#include "core/engine/EngineCommands.h"
#include "core/session/EditSession.h"
#include "core/session/SegmentWork.h"
#include "core/session/past/LabelReader.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/reference/DelayedEngine.h"
#include "tests/reference/PassingEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <utility>
#include <vector>

namespace segmentPreviewTest {

using namespace core;

namespace {

/// An oracle that refuses to write what was worked out.
class RefusingToWrite final : public reference::PassingEngine {
public:
    Ticket submit(EngineCommand command) override
    {
        if (auto* begin = std::get_if<BeginEdit>(&command)) {
            if (auto* relabel = std::get_if<RelabelListed>(&begin->edit))
                relabel->bricks.push_back(relabel->bricks.front()); // never twice
        }
        return PassingEngine::submit(std::move(command));
    }
};

/// The small study, with voxels so much smaller.
LoadedVolume studyOf(double scale)
{
    LoadedVolume study = test::smallStudy();
    for (int column = 0; column < 3; ++column)
        study.volume.geometry.indexToWorld[column] *= scale;
    return study;
}

/// A session on an oracle: segment 1 on four slices, with a hole and a speck, and segment 2 beside
/// it.
struct Bench {
    explicit Bench(EditEngine& engine, const QString& file = {}, double scale = 1.0)
        : session(*EditSession::create(engine, studyOf(scale), {.file = file}))
    {
        session->setErrorListener([this](const Error& error) { told.push_back(error.code); });
        const VolumeGeometry geometry = session->document().volumes.front().geometry;
        const auto disc = [&](const glm::dvec3& index, double radius) {
            return test::paintDiscAt(
                1, geometry.toWorld(index), geometry.direction()[2], radius * scale);
        };
        for (const Edit& edit :
            {test::addSegment("Organ"), test::addSegment("Other"), disc({20.0, 18.0, 7.0}, 6.0),
                disc({20.0, 18.0, 8.0}, 6.0), disc({20.0, 18.0, 9.0}, 6.0),
                test::eraseAt(1, {geometry.toWorld({18.0, 18.0, 8.0})}, 0.5 * scale),
                disc({18.0, 17.0, 14.0}, 4.0), disc({30.0, 12.0, 22.0}, 1.1),
                test::paintAt(2, {geometry.toWorld({28.0, 18.0, 9.0})}, 3.0 * scale)})
            isReady = session->apply(edit).has_value() && isReady;
        isReady = session->settle().has_value() && isReady;
        before = session->stateHash();
        rows = session->history().rows().size();
    }
    [[nodiscard]] bool isAsBefore()
    {
        return session->settle() && !session->openEdit() && session->stateHash() == before
            && session->history().rows().size() == rows;
    }
    /// Until what stands open is with the engine.
    [[nodiscard]] bool waitUntilSeen()
    {
        return QTest::qWaitFor([this] {
            session->poll();
            return !session->openEdit() || session->openHasBegun();
        }) && session->openHasBegun();
    }
    /// Labels as they are now, without ending what stands open.
    [[nodiscard]] std::vector<std::uint8_t> labels()
    {
        const auto reader = std::make_shared<LabelReader>(test::smallGrid().size, std::uint8_t(0));
        bool isAnswered = true;
        while (isAnswered && session->questions().readOn(reader, [&](const Result<void>& portion) {
            isAnswered = portion.has_value();
        })) {
            isAnswered = false;
            static_cast<void>(QTest::qWaitFor([&] {
                session->poll();
                return isAnswered;
            }));
        }
        return reader->takeLabels();
    }

    std::unique_ptr<EditSession> session;
    std::vector<ErrorCode> told; ///< failures after the calls that caused them
    bool isReady = true;
    QByteArray before;
    std::size_t rows = 0;
};

ReshapeSegment grown(double mm)
{
    return {.segment = 1, .operation = ShapeOperation::Grow, .mm = mm};
}

/// Between the slices of segment 1.
SplitSegment splitAcross()
{
    const VolumeGeometry geometry = test::smallStudy().volume.geometry;
    return {.segment = 1,
        .placeLps = geometry.toWorld({20.0, 18.0, 11.0}),
        .normalLps = geometry.direction()[2],
        .into = {.name = QStringLiteral("Part"), .rgb = 0x3060a0}};
}

/// One of each kind that can be previewed, by name.
const std::vector<std::pair<const char*, Edit>>& previews()
{
    static const std::vector<std::pair<const char*, Edit>> all{{"grow", grown(2.0)},
        {"shrink by sides",
            ReshapeSegment{.segment = 1,
                .operation = ShapeOperation::Shrink,
                .mm = 2.0,
                .sides = {.leftMm = 0.0}}},
        {"hollow",
            ReshapeSegment{.segment = 1,
                .operation = ShapeOperation::Hollow,
                .mm = 1.5,
                .shell = ShellPlace::Outside}},
        {"median", ReshapeSegment{.segment = 1, .operation = ShapeOperation::Median, .mm = 2.0}},
        {"smoothed together",
            ReshapeSegment{.segment = 1,
                .operation = ShapeOperation::Gaussian,
                .mm = 1.5,
                .with = std::vector<int>{2}}},
        {"within values",
            ReshapeSegment{.segment = 1,
                .operation = ShapeOperation::Grow,
                .mm = 9.0,
                .editable = EditableRange{.lower = 0.0, .upper = 100.0}}},
        {"between slices", FillBetweenSlices{.segment = 1}},
        {"mirror", MirrorSegment{.segment = 1}}, {"islands", SplitIslands{.segment = 1}},
        {"mirror beside it", MirrorSegment{.segment = 1, .keep = true}},
        {"holes", CleanSegment{.segment = 1, .rule = IslandRule::FillHoles}},
        {"largest island", CleanSegment{.segment = 1, .rule = IslandRule::KeepLargest}},
        {"small islands",
            CleanSegment{.segment = 1, .rule = IslandRule::RemoveSmall, .mm3 = 100.0}},
        {"split", splitAcross()}, {"invert", InvertSegment{.segment = 1}},
        {"invert within values",
            InvertSegment{.segment = 1, .editable = EditableRange{.lower = 0.0, .upper = 100.0}}},
        {"merge", CombineSegments{.segment = 1, .with = 2}},
        {"swap", CombineSegments{.segment = 1, .with = 2, .how = CombineSegments::How::Swap}}};
    return all;
}

/// For what takes seconds: a ball that is many times as large as the volume.
struct SlowBench : Bench {
    explicit SlowBench(EditEngine& engine)
        : Bench(engine, {}, 0.4)
    {
    }
    [[nodiscard]] bool begin()
    {
        return session
            ->begin(ReshapeSegment{.segment = 1, .operation = ShapeOperation::Close, .mm = 100.0})
            .has_value();
    }
    /// Whether it is being worked on, beside the session.
    [[nodiscard]] bool beginsToWork()
    {
        return begin() && QTest::qWaitFor([this] {
            session->poll();
            return session->segmentWork().percent().value_or(0) > 0;
        });
    }
};

} // namespace

/// Edits of whole segments that are seen before they are steps: worked out beside the session,
/// written by the engine, and open until they are committed or rolled back.
class SegmentPreviewTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void isSeenTakenBackAndTaken_data()
    {
        QTest::addColumn<int>("place");
        for (std::size_t place = 0; place < previews().size(); ++place)
            QTest::newRow(previews()[place].first) << int(place);
    }
    void isSeenTakenBackAndTaken()
    {
        QFETCH(const int, place);
        const Edit& edit = previews()[std::size_t(place)].second;
        for (const bool isLate : {false, true}) {
            reference::ReferenceEngine inner;
            reference::DelayedEngine late(inner, 11);
            Bench bench(isLate ? static_cast<EditEngine&>(late) : inner);
            EditSession& session = *bench.session;
            QVERIFY(bench.isReady);
            const std::vector<std::uint8_t> first = bench.labels();

            QVERIFY(session.begin(edit));
            QVERIFY(session.transactionOpen() && session.openIsPreview());
            QVERIFY(session.openIsReplaceable());
            QVERIFY(bench.waitUntilSeen());
            QVERIFY(!session.segmentWork().percent());
            const std::vector<std::uint8_t> seen = bench.labels();
            QVERIFY(seen != first);
            QCOMPARE(session.history().rows().size(), bench.rows);
            session.end(Ending::Rollback);
            QVERIFY(bench.isAsBefore());
            QCOMPARE(bench.labels(), first);

            // Once it is seen, and while it is still being worked out.
            QByteArray taken;
            for (const bool isSeen : {true, false}) {
                QVERIFY(session.begin(edit));
                if (isSeen)
                    QVERIFY(bench.waitUntilSeen());
                session.end(Ending::Commit);
                QVERIFY(session.settle());
                QCOMPARE(bench.labels(), seen);
                QCOMPARE(session.history().rows().back().id, session.history().position());
                taken = session.stateHash();
                QVERIFY(session.undo());
                QVERIFY(session.settle());
                QCOMPARE(session.stateHash(), bench.before);
            }
            QCOMPARE(session.history().rows().size(), bench.rows + 2);

            // The recipe comes to the same, and its row says the same.
            QVERIFY(session.apply(edit) && session.settle());
            QCOMPARE(session.stateHash(), taken);
            const std::vector<HistoryRow>& rows = session.history().rows();
            QCOMPARE(editToJson(rows[bench.rows].edit), editToJson(rows.back().edit));
            QCOMPARE(rows[bench.rows].name, rows.back().name);
            QVERIFY(bench.told.empty());
        }
    }

    /// Another preview, an edit, undo, a walk and settling: on the way, and once it is seen.
    void whateverElseIsDoneTakesItBack()
    {
        reference::ReferenceEngine engine;
        Bench bench(engine);
        EditSession& session = *bench.session;
        const std::vector<std::uint8_t> first = bench.labels();
        for (const bool isSeen : {true, false}) {
            const auto begin = [&] {
                return session.begin(grown(3.0)) && (!isSeen || bench.waitUntilSeen());
            };
            QVERIFY(begin() && bench.isAsBefore());
            QVERIFY(begin() && session.begin(grown(2.0)) && bench.waitUntilSeen());
            QCOMPARE(session.openEdit()->get<ReshapeSegment>().mm, 2.0);
            session.closeOpen();
            QVERIFY(!session.openEdit() && bench.isAsBefore());
            QVERIFY(begin() && session.apply(test::renameSegment(2, QStringLiteral("Next"))));
            QVERIFY(!session.openEdit() && session.settle());
            QCOMPARE(bench.labels(), first);
            QVERIFY(begin() && session.undo() && bench.session->settle());
            QCOMPARE(session.stateHash(), bench.before);
            bench.rows = session.history().rows().size();
            const RowId here = session.history().position();
            QVERIFY(begin() && session.goTo(2) && session.goTo(here) && bench.isAsBefore());
            // What is asked is answered meanwhile.
            QVERIFY(begin());
            QCOMPARE(bench.labels() == first, !isSeen || !session.openHasBegun());
            session.end(Ending::Rollback);
            session.end(Ending::Commit); // too late
            QVERIFY(bench.isAsBefore());
        }
        QVERIFY(bench.told.empty());
    }

    /// Work that would take long is dropped, and nobody hears of it.
    void workIsDropped()
    {
        reference::ReferenceEngine engine;
        SlowBench bench(engine);
        EditSession& session = *bench.session;
        const std::vector<std::uint8_t> first = bench.labels();
        QVERIFY(bench.beginsToWork());
        QVERIFY(!session.openHasBegun() && session.openIsPreview());
        QCOMPARE(bench.labels(), first); // questions do not wait for it
        session.end(Ending::Rollback);
        QVERIFY(!session.openEdit() && !session.segmentWork().percent());
        QVERIFY(bench.isAsBefore());
        // Begun anew in its place.
        QVERIFY(bench.beginsToWork());
        QVERIFY(session.begin(grown(2.0)) && bench.waitUntilSeen());
        session.closeOpen();
        QVERIFY(bench.isAsBefore());
        QVERIFY(bench.told.empty());
        // It goes with its session.
        QVERIFY(bench.beginsToWork());
        bench.session.reset();
    }

    /// Who aborts it is told, and can begin again.
    void canBeAborted()
    {
        reference::ReferenceEngine engine;
        SlowBench bench(engine);
        EditSession& session = *bench.session;
        for (const bool isCommitted : {false, true}) {
            QVERIFY(bench.beginsToWork());
            if (isCommitted)
                session.end(Ending::Commit);
            QVERIFY(session.segmentWork().percent());
            session.segmentWork().abort();
            // From now on, whenever its computation notices.
            QVERIFY(!session.openEdit() && !session.transactionOpen());
            QVERIFY(!session.openIsPreview());
            QVERIFY(QTest::qWaitFor([&] {
                session.poll();
                return session.idle();
            }));
            QCOMPARE(bench.told, std::vector<ErrorCode>{ErrorCode::Cancelled});
            bench.told.clear();
            QVERIFY(!session.settle()); // it tells the same once
            QVERIFY(bench.isAsBefore());
        }
    }

    /// One that nobody will end ends by itself.
    void whatTheEngineRefusesEnds()
    {
        RefusingToWrite engine;
        Bench bench(engine);
        EditSession& session = *bench.session;
        QVERIFY(session.begin(grown(2.0)));
        QVERIFY(QTest::qWaitFor([&] {
            session.poll();
            return session.idle();
        }));
        QCOMPARE(bench.told.size(), std::size_t(1));
        QVERIFY(!session.openEdit() && !session.settle());
        QVERIFY(bench.isAsBefore());
        QVERIFY(session.apply(test::renameSegment(2, QStringLiteral("Next"))));
        QVERIFY(session.settle());
    }

    void whatChangesNothingStandsOpenAndIsNoRow()
    {
        reference::ReferenceEngine engine;
        Bench bench(engine);
        EditSession& session = *bench.session;
        for (const Ending ending : {Ending::Commit, Ending::Rollback}) {
            QVERIFY(session.begin(FillBetweenSlices{.segment = 2}));
            QVERIFY(bench.waitUntilSeen() && session.openEdit());
            session.end(ending);
            QVERIFY(bench.isAsBefore());
        }
    }

    void whatIsRefusedIsNotBegun()
    {
        reference::ReferenceEngine engine;
        Bench bench(engine);
        EditSession& session = *bench.session;
        QCOMPARE(session.begin(grown(0.0)).error().code, ErrorCode::InvalidField);
        QCOMPARE(
            session.begin(FillBetweenSlices{.segment = 7}).error().code, ErrorCode::UnknownSegment);
        // It is carried out whole.
        const CopySegment copy{.segment = 1, .name = QStringLiteral("Copy")};
        QCOMPARE(session.begin(copy).error().code, ErrorCode::InvalidField);
        QVERIFY(session.apply(test::lockSegment(1)) && session.settle());
        QCOMPARE(session.begin(grown(2.0)).error().code, ErrorCode::SegmentLocked);
        QVERIFY(!session.openEdit());
    }

    /// New segments are seen by their labels, and are the document's once it is a step.
    void segmentsAreMadeWhenItIsAStep()
    {
        for (const bool isNamed : {false, true}) {
            reference::ReferenceEngine engine;
            Bench bench(engine);
            EditSession& session = *bench.session;
            SplitIslands edit{.segment = 1};
            if (isNamed)
                edit.into = usualParts(session.document(), *session.document().segment(1), 2);
            const std::vector<std::uint8_t> first = bench.labels();
            QVERIFY(session.begin(edit) && session.openIsPreview() && bench.waitUntilSeen());
            const std::vector<std::uint8_t> seen = bench.labels();
            QVERIFY(std::count(seen.begin(), seen.end(), 3) > 0);
            QVERIFY(std::count(seen.begin(), seen.end(), 4) > 0);
            QCOMPARE(session.openEdit()->get<SplitIslands>().into->size(), std::size_t(2));
            QCOMPARE(session.document().segments.size(), std::size_t(2));
            QCOMPARE(session.foreseenDocument().segments.size(), std::size_t(2));
            session.end(Ending::Rollback);
            QCOMPARE(session.foreseenDocument().segments.size(), std::size_t(2));
            QVERIFY(bench.isAsBefore());
            QCOMPARE(bench.labels(), first);
            // A segment that is added meanwhile takes the preview back, and its label.
            QVERIFY(session.begin(edit) && bench.waitUntilSeen());
            QVERIFY(session.apply(test::addSegment("Third")) && session.settle());
            QCOMPARE(bench.labels(), first);
            QVERIFY(session.undo() && session.settle());
            QCOMPARE(session.stateHash(), bench.before);
            QVERIFY(session.begin(edit) && bench.waitUntilSeen());
            session.end(Ending::Commit);
            QCOMPARE(session.foreseenDocument().segments.size(), std::size_t(4));
            QVERIFY(session.settle());
            QCOMPARE(session.document().segments.size(), std::size_t(4));
            QVERIFY(session.document().segment(3)->voxels > 0);
            QVERIFY(session.undo() && session.settle());
            QCOMPARE(session.stateHash(), bench.before);
            QCOMPARE(session.document().segments.size(), std::size_t(2));
            QVERIFY(bench.told.empty());
        }
    }

    void aSplitMakesItsSegmentWhenItIsAStep()
    {
        reference::ReferenceEngine engine;
        Bench bench(engine);
        EditSession& session = *bench.session;
        for (const Ending ending : {Ending::Rollback, Ending::Commit}) {
            QVERIFY(session.begin(splitAcross()) && bench.waitUntilSeen());
            const std::vector<std::uint8_t> seen = bench.labels();
            QVERIFY(std::count(seen.begin(), seen.end(), 3) > 0);
            QCOMPARE(session.document().segments.size(), std::size_t(2));
            QCOMPARE(session.foreseenDocument().segments.size(), std::size_t(2));
            session.end(ending);
            if (ending == Ending::Rollback)
                QVERIFY(bench.isAsBefore());
        }
        QVERIFY(session.settle());
        QCOMPARE(session.document().segments.size(), std::size_t(3));
        QVERIFY(session.document().segment(3)->voxels > 0);
        QCOMPARE(session.history().rows().size(), bench.rows + 1);
    }

    /// As a stroke under the pen: a crash leaves nothing of it. On the disk is what was taken.
    void isOnDiskWhenItIsAStep()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("session.burin"));
        const auto afterCrash = [&](const char* name) {
            const QString copy = folder.filePath(QLatin1String(name));
            for (const char* suffix : {"", "-wal"})
                static_cast<void>(
                    QFile::copy(file + QLatin1String(suffix), copy + QLatin1String(suffix)));
            reference::ReferenceEngine engine;
            const auto opened = EditSession::open(engine, test::smallStudy(), copy);
            const bool isSound = opened && (*opened)->settle();
            return std::make_pair(isSound ? (*opened)->stateHash() : QByteArray(),
                isSound ? (*opened)->history().rows().size() : 0);
        };
        reference::ReferenceEngine engine;
        Bench bench(engine, file);
        EditSession& session = *bench.session;
        QVERIFY(session.begin(grown(2.0))); // nobody polls
        QCOMPARE(afterCrash("working"), std::make_pair(bench.before, bench.rows));
        QVERIFY(session.begin(grown(2.0)) && bench.waitUntilSeen());
        QCOMPARE(afterCrash("seen"), std::make_pair(bench.before, bench.rows));
        session.end(Ending::Commit);
        QVERIFY(session.settle());
        QCOMPARE(afterCrash("taken"), std::make_pair(session.stateHash(), bench.rows + 1));
        // A session that ends takes it back.
        const QByteArray taken = session.stateHash();
        QVERIFY(session.begin(grown(2.0)) && bench.waitUntilSeen());
        bench.session.reset();
        QCOMPARE(afterCrash("closed"), std::make_pair(taken, bench.rows + 1));
    }
};

BURIN_TEST(SegmentPreviewTest)

} // namespace segmentPreviewTest

#include "SegmentPreviewTest.moc"
