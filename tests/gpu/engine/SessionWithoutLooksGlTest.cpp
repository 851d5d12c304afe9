// SPDX-License-Identifier: Apache-2.0
#include "core/brick/ThreadWithoutVoxels.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/edits/kinds/history/RevertRows.h"
#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/LayerToSegment.h"
#include "core/session/EditSession.h"
#include "core/session/SessionStorage.h"
#include "core/session/StepFindings.h"
#include "core/session/questions/Touch.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/EditEngineFixture.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>

namespace sessionWithoutLooksGlTest {

using namespace core;

namespace {

/// A cut through the whole volume, along z.
ScissorsCut through(const VolumeGeometry& geometry, double part)
{
    const glm::dvec3 far = geometry.toWorld(glm::dvec3(geometry.size - 1));
    const glm::dvec3 middle = far / 2.0;
    const double half = part * std::max(far.x, far.y);
    ScissorsCut cut;
    cut.view = {.eyeLps = middle - glm::dvec3(0.0, 0.0, 1000.0),
        .targetLps = middle,
        .up = {0.0, -1.0, 0.0},
        .heightMm = 300.0};
    cut.polygonMm = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
    return cut;
}

} // namespace

/// The thread of a window hands bricks on and looks at none of their voxels, whatever is done.
class SessionWithoutLooksGlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QVERIFY2(m_gpu.isReady(), m_gpu.why()); }
    void init() { test::failOnUnexpectedMessages(); }
    void cleanup() { QCOMPARE(m_gpu.newErrors(), 0); }

    void everyStep_data()
    {
        QTest::addColumn<bool>("inMemory");
        QTest::newRow("steps at hand") << true;
        QTest::newRow("steps from the disk") << false;
    }
    void everyStep()
    {
        QFETCH(bool, inMemory);
        // 21 952 bricks, or 343.
        const int side = test::longRun() ? 448 : 112;
        const glm::ivec3 size(side);
        LoadedVolume study;
        study.codes = test::constantVolume(size, test::tissueCode).values;
        study.volume.geometry.size = size;
        study.volume.maximum = 65535.0;
        study.volume.voxelsSha256 = "not looked at here";
        const VolumeGeometry geometry = study.volume.geometry;
        const QTemporaryDir folder;
        auto session = EditSession::create(
            m_gpu.engine(), std::move(study), {.file = folder.filePath(QStringLiteral("a.burin"))});
        QVERIFY(session);
        m_session = session->get();
        if (!inMemory)
            m_session->storage().setStepMemory(0);

        const std::int64_t before = ThreadWithoutVoxels::looks();
        const ThreadWithoutVoxels here;
        step("cut", [&] { return m_session->apply(through(geometry, 0.8)); });
        if (QTest::currentTestFailed())
            return;
        QCOMPARE(m_session->history().row(1).statistics.bricks, BrickGrid{size}.brickCount());
        step("undo", [&] { return m_session->undo(); });
        step("redo", [&] { return m_session->redo(); });
        step("add a segment",
            [&] { return m_session->apply(AddSegment{.name = QStringLiteral("A")}); });
        step("layer to segment",
            [&] { return m_session->apply(LayerToSegment{.layer = 1, .target = {.segment = 1}}); });
        step("undo of labels", [&] { return m_session->undo(); });
        step("redo of labels", [&] { return m_session->redo(); });
        step("seeds", [&] {
            return m_session->apply(
                SeedStroke{.segment = 1, .pointsLps = {geometry.toWorld(glm::dvec3(size / 2))}});
        });
        step("grow", [&] { return m_session->apply(test::growBetween(0.0, 65535.0, 5)); });
        step("shrink", [&] { return m_session->apply(ShrinkSteps{.steps = 3}); });
        step("paint", [&] {
            return m_session->apply(test::eraseAt(1, {geometry.toWorld(glm::dvec3(size / 3))}));
        });
        step("undo only here",
            [&] { return m_session->apply(RevertRows{{m_session->history().position()}}); });
        step("to the beginning", [&] { return m_session->goTo(0); });
        step("to the end",
            [&] { return m_session->goTo(RowId(m_session->history().rows().size())); });
        // As a hand on the timeline does, which waits for no walk.
        const auto last = RowId(m_session->history().rows().size());
        step("scrub", [&] {
            Result<void> gone;
            for (int walk = 1; gone && walk < 10; ++walk)
                gone = m_session->goTo(RowId(3 * walk) % last);
            return gone ? m_session->goTo(last) : gone;
        });
        QCOMPARE(m_session->history().position(), last);
        step("divide",
            [&] { return m_session->apply(DivideSegment{.segment = 1, .marginMm = 1.0}); });
        RowId touched = 0;
        step("who touched it last", [&] {
            m_session->questions().lastTouching({.segment = 1}, [&](RowId row) { touched = row; });
            return Result<void>();
        });
        QVERIFY(touched > 0);
        step("close", [&] {
            session->reset();
            return Result<void>();
        });
        QCOMPARE(ThreadWithoutVoxels::looks() - before, std::int64_t(0));
    }

    /// Strokes that are changed or removed are worked out beside the window, too.
    void revisedStrokes()
    {
        const QTemporaryDir folder;
        auto session = EditSession::create(m_gpu.engine(), test::smallStudy(),
            {.file = folder.filePath(QStringLiteral("b.burin"))});
        QVERIFY(session);
        m_session = session->get();
        // In the bone, where only a wider drill comes to.
        const glm::dvec3 beside = test::pointsInBrain().front() + glm::dvec3(-9.0, -9.5, 0.0);
        BrushStroke back = test::carveAt(test::pointsInBone(), 3.0).get<BrushStroke>();
        back.restore = true;
        const std::vector<HistoryRow>& rows = m_session->history().rows();

        const std::int64_t before = ThreadWithoutVoxels::looks();
        const ThreadWithoutVoxels here;
        step("drill", [&] { return m_session->apply(test::drillAt(0.0)); });
        step("drill into its floor", [&] { return m_session->apply(test::drillAt(2.0)); });
        step("restore", [&] { return m_session->apply(back); });
        QCOMPARE(rows.size(), std::size_t(3));
        step("revise", [&] { return m_session->apply(ReviseStroke{.row = 1, .radiusMm = 7.0}); });
        QCOMPARE(rows.size(), std::size_t(4));
        step("add a segment", [&] { return m_session->apply(test::newSegment("A")); });
        step("paint", [&] { return m_session->apply(test::paintAt(1, {beside}, 2.0)); });
        step("protect", [&] { return m_session->apply(test::protectSegment(1)); });
        QCOMPARE(rows.size(), std::size_t(7));
        step("refused", [&] { return m_session->apply(ReviseStroke{.row = 1, .radiusMm = 12.0}); });
        QCOMPARE(rows.size(), std::size_t(7));
        const Result<void> refused = m_session->settle();
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::SegmentProtected);
        step("remove", [&] { return m_session->apply(ReviseStroke{.row = 1, .removed = true}); });
        QCOMPARE(rows.size(), std::size_t(8));
        const std::vector<RowId> inside = m_session->findings().strokesOnRevisedSurface();
        QVERIFY(std::count(inside.begin(), inside.end(), RowId(2)) == 1);
        step("undo", [&] { return m_session->undo(); });
        step("close", [&] {
            session->reset();
            return Result<void>();
        });
        QCOMPARE(ThreadWithoutVoxels::looks() - before, std::int64_t(0));
    }

private:
    /// Carries a step out as a window does, and says how long its thread was busy at most.
    void step(const char* name, const std::function<Result<void>()>& begin)
    {
        QElapsedTimer clock;
        clock.start();
        const Result<void> begun = begin();
        qint64 longest = clock.nsecsElapsed();
        QVERIFY2(begun, name);
        while (qstrcmp(name, "close") != 0 && !m_session->idle()) {
            m_gpu.engine().finish();
            clock.start();
            m_session->poll();
            longest = std::max(longest, clock.nsecsElapsed());
            QThread::usleep(200);
        }
        if (test::longRun())
            qInfo("%s: at most %.1f ms at once", name, double(longest) / 1e6);
    }

    test::EditEngineFixture m_gpu;
    EditSession* m_session = nullptr;
};

BURIN_TEST(SessionWithoutLooksGlTest)

} // namespace sessionWithoutLooksGlTest

#include "SessionWithoutLooksGlTest.moc"
