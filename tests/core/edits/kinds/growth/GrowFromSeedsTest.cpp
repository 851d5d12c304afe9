// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/growth/GrowFromSeeds.h"
#include "core/edits/kinds/parts/GrowBox.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/reference/DelayedEngine.h"
#include "tests/reference/PassingEngine.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTest>

#include <map>
#include <set>
#include <utility>
#include <variant>

namespace growFromSeedsTest {

using namespace core;

namespace {

struct Bench {
    explicit Bench(bool delayed = false)
        : late(inner, 11)
        , engine(delayed ? static_cast<EditEngine&>(late) : inner)
    {
        begin();
    }
    explicit Bench(EditEngine& other)
        : late(inner, 11)
        , engine(other)
    {
        begin();
    }
    void begin()
    {
        session = *EditSession::create(engine, test::smallStudy(), {});
        for (const Edit& edit : {Edit(test::addSegment("Brain")), Edit(test::addSegment("Bone")),
                 Edit(test::addSegment("Air")), Edit(test::seedInBrain(1)),
                 Edit(test::seedInBone(2)), Edit(test::seedAt(3, {at({39.0, 35.0, 33.0})}))})
            run(edit);
    }
    [[nodiscard]] static glm::dvec3 at(const glm::dvec3& voxel)
    {
        return test::smallStudy().volume.geometry.toWorld(voxel);
    }
    void run(const Edit& edit)
    {
        const Result<void> applied = session->apply(edit);
        QVERIFY2(applied, qPrintable(applied ? QString() : applied.error().arguments.join(u' ')));
        QVERIFY(session->settle());
    }
    [[nodiscard]] std::size_t rows() const { return session->history().rows().size(); }
    /// What the views show.
    [[nodiscard]] std::uint8_t seenAt(const glm::ivec3& voxel)
    {
        std::optional<std::uint8_t> seen;
        session->questions().probe(
            {voxel}, [&seen](const Result<std::vector<ProbedVoxel>>& probes) {
                seen = probes->front().label;
            });
        for (int i = 0; i < 1000 && !seen; ++i) {
            engine.finish();
            session->poll();
        }
        return seen.value_or(255);
    }

    reference::ReferenceEngine inner;
    reference::DelayedEngine late;
    EditEngine& engine; ///< the session's
    std::unique_ptr<EditSession> session;
};

/// Counts how often it is told to keep nothing for a next preview.
class CountingEngine final : public reference::PassingEngine {
public:
    Ticket submit(EngineCommand command) override
    {
        const auto* told = std::get_if<ExtendEdit>(&command);
        forgotten += told && std::holds_alternative<ForgetSpread>(told->extension) ? 1 : 0;
        return PassingEngine::submit(std::move(command));
    }
    int forgotten = 0;
};

/// The whole of the small study.
GrowFromSeeds everywhere()
{
    const VolumeGeometry geometry = test::smallStudy().volume.geometry;
    GrowFromSeeds edit;
    edit.box =
        GrowBox{geometry.toWorld({0, 0, 0}), geometry.toWorld(glm::dvec3(geometry.size) - 1.0)};
    return edit;
}

constexpr glm::ivec3 middle{20, 18, 17};
constexpr glm::ivec3 corner{0, 0, 0};

} // namespace

/// Growing from seeds as a session does it: shown, decided on, one row.
class GrowFromSeedsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void givesEverythingToTheNearest()
    {
        Bench bench;
        bench.run(everywhere());
        const std::vector<std::uint8_t> labels = *bench.session->questions().labels(0);
        const LoadedVolume study = test::smallStudy();
        // One seed in each of three even matters: each gets what is of its kind.
        std::map<int, std::set<int>> codes;
        for (std::size_t i = 0; i < labels.size(); ++i)
            codes[labels[i]].insert(study.codes[i]);
        QCOMPARE(codes.size(), std::size_t(3));
        for (const auto& [label, values] : codes)
            QVERIFY2(label > 0 && values.size() == 1, qPrintable(QString::number(label)));
        const HistoryRow& row = bench.session->history().rows().back();
        QCOMPARE(row.name, QStringLiteral("Grow 3 segments from seeds, +48 960 voxels"));
    }

    void previewShowsAndLeavesNoTrace_data()
    {
        QTest::addColumn<bool>("delayed");
        QTest::addRow("at once") << false;
        QTest::addRow("delayed") << true;
    }

    void previewShowsAndLeavesNoTrace()
    {
        QFETCH(bool, delayed);
        Bench bench(delayed);
        const QByteArray before = bench.session->stateHash();
        const std::size_t rows = bench.rows();
        QVERIFY(bench.session->begin(everywhere()));
        QVERIFY(bench.session->isOpen<GrowFromSeeds>());
        QCOMPARE(int(bench.seenAt(middle)), 1);
        QCOMPARE(int(bench.seenAt(corner)), 3);
        bench.session->forgetPreview();
        QVERIFY(!bench.session->isOpen<GrowFromSeeds>());
        QVERIFY(bench.session->settle());
        QCOMPARE(bench.rows(), rows);
        QCOMPARE(bench.session->stateHash(), before);
        QCOMPARE(int(bench.seenAt(middle)), 0);
    }

    void whateverElseIsDoneTakesThePreviewBack()
    {
        Bench bench;
        QVERIFY(bench.session->begin(everywhere()));
        QCOMPARE(int(bench.seenAt(middle)), 1);
        // A stroke lands on what was there before, not on what was only shown.
        bench.run(test::paintAt(3, {Bench::at(glm::dvec3(middle))}));
        QVERIFY(!bench.session->isOpen<GrowFromSeeds>());
        QCOMPARE(int(bench.seenAt(corner)), 0);
        QCOMPARE(int(bench.seenAt(middle)), 3);

        QVERIFY(bench.session->begin(everywhere()));
        QVERIFY(bench.session->undo());
        QVERIFY(bench.session->settle());
        QCOMPARE(int(bench.seenAt(middle)), 0);
        QCOMPARE(int(bench.seenAt(corner)), 0);
    }

    void whatIsShownIsWhatIsApplied()
    {
        Bench shown;
        QVERIFY(shown.session->begin(everywhere()));
        shown.session->end(Ending::Commit);
        QVERIFY(shown.session->settle());
        Bench whole;
        whole.run(everywhere());
        QCOMPARE(shown.session->stateHash(), whole.session->stateHash());
        QCOMPARE(shown.rows(), whole.rows());
        QVERIFY(shown.session->undo());
        QVERIFY(shown.session->settle());
        QCOMPARE(int(shown.seenAt(middle)), 0);
    }

    /// What becomes a row keeps nothing for a next preview, for it may be aborted when its costs
    /// are known; what is rolled back does.
    void whatIsAppliedKeepsNothing()
    {
        CountingEngine engine;
        Bench bench(engine);
        EditSession& session = *bench.session;
        bench.run(everywhere());
        QCOMPARE(engine.forgotten, 1);
        QVERIFY(session.undo() && session.settle());
        QVERIFY(session.begin(everywhere()));
        session.end(Ending::Rollback);
        QVERIFY(session.settle());
        QCOMPARE(engine.forgotten, 1);
        QVERIFY(session.begin(everywhere()));
        session.end(Ending::Commit);
        QVERIFY(session.settle());
        QCOMPARE(engine.forgotten, 2);
    }

    void aClosingSessionTakesThePreviewBack()
    {
        Bench bench;
        QVERIFY(bench.session->begin(everywhere()));
        QVERIFY(bench.session->settle());
        QVERIFY(!bench.session->transactionOpen());
        QCOMPARE(int(bench.seenAt(middle)), 0);
    }

    void refusesWhatCannotCompete()
    {
        Bench bench;
        GrowFromSeeds edit = everywhere();
        edit.segments = {2};
        QCOMPARE(bench.session->apply(edit).error().code, ErrorCode::InvalidField);
        edit.segments = {2, 9};
        QCOMPARE(bench.session->apply(edit).error().code, ErrorCode::UnknownSegment);
        bench.run(test::lockSegment(2));
        edit.segments = {1, 2};
        QCOMPARE(bench.session->apply(edit).error().code, ErrorCode::SegmentLocked);
        edit.segments.reset();
        edit.box = GrowBox{{9000, 0, 0}, {9001, 1, 1}};
        QCOMPARE(bench.session->apply(edit).error().code, ErrorCode::InvalidField);
        // Two may compete, but only one of them has seeds: the engine finds out.
        bench.run(test::addSegment("Empty"));
        edit = everywhere();
        edit.segments = {1, 4};
        QVERIFY(bench.session->apply(edit));
        const Result<void> settled = bench.session->settle();
        QVERIFY(!settled);
        QCOMPARE(settled.error().code, ErrorCode::InvalidField);
        // A preview that is refused does not stay open.
        QVERIFY(bench.session->begin(edit));
        QVERIFY(!bench.session->settle());
        QVERIFY(!bench.session->transactionOpen());
        QVERIFY(bench.session->idle());
    }
};

BURIN_TEST(GrowFromSeedsTest)

} // namespace growFromSeedsTest

#include "GrowFromSeedsTest.moc"
