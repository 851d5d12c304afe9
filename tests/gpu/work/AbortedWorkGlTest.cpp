// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/growth/GrowFromSeeds.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/CombineSegments.h"
#include "core/edits/kinds/segments/InvertSegment.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/splitting/SplitSegment.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/session/EditSession.h"
#include "core/session/SegmentWork.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/faults/WorkOfGl.h"
#include "tests/support/fixtures/EditEngineFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/GradedBall.h"
#include "tests/support/scenes/PlainEdits.h"

#include <QScopeGuard>
#include <QtTest>

#include <memory>
#include <utility>
#include <vector>

namespace abortedWorkGlTest {

using namespace core;
using Ball = test::GradedBall;

namespace {

constexpr int side = 256; // 4096 bricks
constexpr int bricksOfSlice = 1024; ///< at most
constexpr int slicesBefore = 2; ///< of the edit, before it is aborted

struct Aborted {
    const char* name;
    Edit edit;
    /// At most so many work groups put back what was changed, one for each brick of labels or
    /// seeds.
    int mostGroups = 2 * slicesBefore * bricksOfSlice;
    bool fillsVolume = false; ///< the second segment has all of the volume before
};

/// Edits that the engine carries out in slices, each with more than it does in two of them.
const std::vector<Aborted>& engineEdits()
{
    static const GrowBox whole{.fromLps = glm::dvec3(0.0), .toLps = glm::dvec3(double(side - 1))};
    static const std::vector<Aborted> all{{"invert", InvertSegment{.segment = 1}},
        {"threshold", ThresholdSegment{.segment = 1}},
        {"merge", CombineSegments{.segment = 1, .with = 2}, 2 * slicesBefore * bricksOfSlice, true},
        {"grow from seeds", GrowFromSeeds{.box = whole}, 0}};
    return all;
}

/// Edits that are worked out beside the session first.
const std::vector<std::pair<const char*, Edit>>& workedOutEdits()
{
    static const std::vector<std::pair<const char*, Edit>> all{
        {"smooth", ReshapeSegment{.segment = 1, .operation = ShapeOperation::Median, .mm = 2.0}},
        {"keep largest", CleanSegment{.segment = 1, .rule = IslandRule::KeepLargest}},
        {"split by a plane",
            SplitSegment{.segment = 1,
                .placeLps = Ball::middle,
                .normalLps = {0.0, 1.0, 0.0},
                .into = {.name = QStringLiteral("Part"), .rgb = 0x3060a0}}}};
    return all;
}

} // namespace

/// What is still done after an abort was asked for, counted in work instead of time: the slice that
/// has begun, and putting back what was changed. The engine's slices are done one by one here.
class AbortedWorkGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY2(m_gpu.isReady(), m_gpu.why()); }
    void init() { test::failOnUnexpectedMessages(); }
    void cleanup() { QCOMPARE(m_gpu.newErrors(), 0); }
    void theEngineDoesNoFurtherSlice_data();
    void theEngineDoesNoFurtherSlice();
    void whatIsReadIsGivenUpInBetween();
    void whatIsDroppedGetsNoFurtherSlice();
    void nothingFollowsWhatIsWorkedOut_data();
    void nothingFollowsWhatIsWorkedOut();

private:
    /// Two segments with a dab each; null: that failed.
    [[nodiscard]] std::unique_ptr<EditSession> opened(bool fillsVolume = false);
    /// Begins what the session was told, and does some slices of it.
    [[nodiscard]] bool doFirstSlices();

    test::EditEngineFixture m_gpu;
};

std::unique_ptr<EditSession> AbortedWorkGlTest::opened(bool fillsVolume)
{
    auto session = EditSession::create(m_gpu.engine(), Ball::in(side), {});
    if (!session)
        return nullptr;
    const glm::dvec3 aside(9.0, 0.0, 0.0);
    std::vector<Edit> edits{test::newSegment(QStringLiteral("A")),
        test::newSegment(QStringLiteral("B")), test::paintAt(1, {Ball::middle - aside}, 4.0),
        test::paintAt(2, {Ball::middle + aside}, 4.0)};
    if (fillsVolume)
        edits.push_back(ThresholdSegment{.segment = 2, .mode = ThresholdSegment::Mode::Add});
    for (const Edit& edit : edits) {
        if (!(*session)->apply(edit))
            return nullptr;
    }
    if (!(*session)->settle())
        return nullptr;
    m_gpu.rest();
    return *std::move(session);
}

bool AbortedWorkGlTest::doFirstSlices()
{
    bool isDone = m_gpu.doSlice(); // it begins
    for (int slice = 0; slice < slicesBefore; ++slice)
        isDone = m_gpu.doSlice() && isDone;
    return isDone && m_gpu.engine().growthProgress().running;
}

void AbortedWorkGlTest::theEngineDoesNoFurtherSlice_data()
{
    QTest::addColumn<int>("place");
    for (std::size_t place = 0; place < engineEdits().size(); ++place)
        QTest::newRow(engineEdits()[place].name) << int(place);
}

void AbortedWorkGlTest::theEngineDoesNoFurtherSlice()
{
    QFETCH(const int, place);
    const Aborted& aborted = engineEdits()[std::size_t(place)];
    const auto session = opened(aborted.fillsVolume);
    QVERIFY(session);
    const QByteArray before = session->stateHash();
    const std::size_t rows = session->history().rows().size();
    const auto labels = m_gpu.read(gpu::VolumeField::Labels);

    test::WorkOfGl work;
    m_gpu.hold();
    const auto goOn = qScopeGuard([this] { m_gpu.goOn(); }); // lest the session waits for ever
    QVERIFY(session->apply(aborted.edit));
    QVERIFY(doFirstSlices());
    const test::GlWork first = work.take();
    QVERIFY(first.dispatches > 0);
    QVERIFY(session->segmentWork().percent());
    session->segmentWork().abort();
    QVERIFY(!session->segmentWork().percent());
    QVERIFY(m_gpu.doSlice());
    session->poll();
    QVERIFY(session->idle());
    const test::GlWork rest = work.take();
    m_gpu.goOn();
    qInfo("%s: %d dispatches of %lld groups, then %d of %lld", aborted.name, first.dispatches,
        qlonglong(first.groups), rest.dispatches, qlonglong(rest.groups));
    QVERIFY(rest.groups <= aborted.mostGroups);

    QVERIFY(!session->settle()); // it tells that it was cancelled
    QVERIFY(session->settle());
    QCOMPARE(session->history().rows().size(), rows);
    QCOMPARE(session->stateHash(), before);
    QVERIFY(m_gpu.read(gpu::VolumeField::Labels).values == labels.values);
    if (aborted.mostGroups == 0)
        return;
    // As a whole it is much more than what was left to do.
    m_gpu.rest();
    static_cast<void>(work.take());
    QVERIFY(session->apply(aborted.edit) && session->settle());
    m_gpu.rest();
    QVERIFY(work.take().groups > 2 * rest.groups);
    QCOMPARE(session->history().rows().size(), rows + 1);
}

/// What an edit of the whole volume has changed is read in parts before it is a step.
void AbortedWorkGlTest::whatIsReadIsGivenUpInBetween()
{
    const auto session = opened();
    QVERIFY(session);
    const QByteArray before = session->stateHash();
    const std::size_t rows = session->history().rows().size();
    const auto labels = m_gpu.read(gpu::VolumeField::Labels);
    constexpr std::int64_t bytesOfPart = std::int64_t(2048) * BrickGrid::voxelsPerBrick;

    test::WorkOfGl work;
    m_gpu.hold();
    const auto goOn = qScopeGuard([this] { m_gpu.goOn(); });
    QVERIFY(session->apply(InvertSegment{.segment = 1}));
    QVERIFY(m_gpu.doSlice()); // it begins
    while (m_gpu.engine().growthProgress().running)
        QVERIFY(m_gpu.doSlice());
    static_cast<void>(work.take());
    QVERIFY(m_gpu.doSlice()); // a part is read
    const test::GlWork part = work.take();
    qInfo("a part: %lld bytes", qlonglong(part.bytesDown));
    QVERIFY(part.bytesDown >= bytesOfPart && part.bytesDown < 2 * bytesOfPart);
    session->poll();
    QVERIFY(!session->idle());
    session->segmentWork().abort();
    QVERIFY(m_gpu.doSlice());
    session->poll();
    QVERIFY(session->idle());
    m_gpu.goOn();
    QVERIFY(!session->settle() && session->settle());
    QCOMPARE(session->history().rows().size(), rows);
    QCOMPARE(session->stateHash(), before);
    QVERIFY(m_gpu.read(gpu::VolumeField::Labels).values == labels.values);

    // Where it is not given up it is a step with all of its changes, which can be taken back.
    QVERIFY(session->apply(InvertSegment{.segment = 1}) && session->settle());
    QCOMPARE(session->history().rows().size(), rows + 1);
    QVERIFY(session->stateHash() != before);
    const auto& statistics = session->history().rows().back().statistics;
    QCOMPARE(statistics.bricks, int(side / 16 * (side / 16) * (side / 16)));
    QVERIFY(session->undo() && session->settle());
    QCOMPARE(session->stateHash(), before);
    QVERIFY(m_gpu.read(gpu::VolumeField::Labels).values == labels.values);
}

/// Previews and growths that are rolled back.
void AbortedWorkGlTest::whatIsDroppedGetsNoFurtherSlice()
{
    const auto session = opened();
    QVERIFY(session);
    QVERIFY(session->apply(test::seedAt(1, {Ball::middle - glm::dvec3(9.0, 0.0, 0.0)})));
    QVERIFY(session->settle());
    const QByteArray before = session->stateHash();
    const GrowSteps growth = test::growBetween(0.0, 60000.0).get<GrowSteps>();
    for (const Edit& edit :
        std::vector<Edit>{ThresholdSegment{.segment = 1}, InvertSegment{.segment = 1}, growth}) {
        m_gpu.rest();
        test::WorkOfGl work;
        m_gpu.hold();
        const auto goOn = qScopeGuard([this] { m_gpu.goOn(); });
        QVERIFY(session->begin(edit));
        if (edit.is<GrowSteps>())
            session->extend(GrowAdvance{});
        QVERIFY(m_gpu.doSlice() && doFirstSlices());
        static_cast<void>(work.take());
        session->end(Ending::Rollback);
        QVERIFY(m_gpu.doSlice());
        session->poll();
        QVERIFY(session->idle());
        QVERIFY(work.take().groups <= 2 * (slicesBefore + 1) * bricksOfSlice);
        m_gpu.goOn();
        QVERIFY(session->settle());
        QCOMPARE(session->stateHash(), before);
    }
}

void AbortedWorkGlTest::nothingFollowsWhatIsWorkedOut_data()
{
    QTest::addColumn<int>("place");
    for (std::size_t place = 0; place < workedOutEdits().size(); ++place)
        QTest::newRow(workedOutEdits()[place].first) << int(place);
}

/// Labels are read in portions, worked on beside the session, and written.
void AbortedWorkGlTest::nothingFollowsWhatIsWorkedOut()
{
    QFETCH(const int, place);
    const Edit& edit = workedOutEdits()[std::size_t(place)].second;
    const auto session = opened();
    QVERIFY(session);
    const QByteArray before = session->stateHash();
    test::WorkOfGl work;
    m_gpu.hold();
    const auto goOn = qScopeGuard([this] { m_gpu.goOn(); });
    QVERIFY(session->apply(edit));
    QVERIFY(session->segmentWork().percent());
    session->segmentWork().abort();
    static_cast<void>(work.take());
    QVERIFY(m_gpu.doSlice()); // the portion that was asked for
    QVERIFY(work.take().dispatches <= 2);
    session->poll();
    QVERIFY(session->idle());
    m_gpu.goOn();
    m_gpu.rest();
    QCOMPARE(work.take().dispatches, 0);
    QVERIFY(!session->settle() && session->settle());
    QCOMPARE(session->stateHash(), before);
}

BURIN_TEST(AbortedWorkGlTest)

} // namespace abortedWorkGlTest

#include "AbortedWorkGlTest.moc"
