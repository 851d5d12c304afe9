// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/surface/ChangeMarks.h"
#include "core/edits/kinds/surface/DropSurface.h"
#include "core/edits/kinds/surface/FollowMask.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/SpherePush.h"
#include "core/edits/kinds/surface/SurfaceBarrier.h"
#include "core/edits/kinds/surface/WriteBack.h"
#include "core/edits/open/StrokeExtension.h"
#include "core/refine/mesh/SurfaceDelta.h"
#include "core/session/operations/EditOperation.h"
#include "core/session/operations/OperationQueue.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTest>

#include <future>
#include <memory>
#include <new>
#include <vector>

namespace abandonedSurfaceTest {

using namespace core;

namespace {

glm::dvec3 at(const glm::dvec3& index)
{
    return test::smallGrid().toWorld(index);
}

SpherePush push(std::vector<glm::dvec3> pointsLps)
{
    return {.path = {.radiusMm = 3.0, .pointsLps = std::move(pointsLps)}};
}

/// Segment 1 with its surface, and a session on it whose side thread can be held up.
struct Bench {
    explicit Bench(const std::vector<Edit>& first)
    {
        LoadedVolume study = test::smallStudy();
        isReady = engine.openVolume(study.volume.geometry.size, study.codes).has_value();
        queue = std::make_unique<OperationQueue>(
            engine, std::move(study.volume), nullptr, std::function<void()>());
        queue->setErrorListener([this](const Error& error) { told.push_back(error.code); });
        std::vector<Edit> all{
            test::addSegment("Organ"), test::paintAt(1, {at({20.0, 18.0, 12.0})}, 6.0)};
        all.insert(all.end(), first.begin(), first.end());
        for (const Edit& edit : all)
            isReady = carryOut(edit) && isReady;
        before = hash();
        mesh = sha256Of(state().surface.mesh);
        rows = state().history.rows().size();
    }
    [[nodiscard]] SessionState& state() const { return queue->state(); }
    [[nodiscard]] QByteArray hash() const
    {
        return state().worker->stateHash(state().documentJson());
    }
    /// @return whether it is done and left a row
    [[nodiscard]] bool carryOut(const Edit& edit) const
    {
        const std::size_t known = state().history.rows().size();
        if (!queue->check(edit))
            return false;
        queue->submit(operationOf(edit));
        return queue->settle() && state().history.rows().size() == known + 1;
    }
    /// As where there is no memory for what the session's thread is about to do.
    void refuseMemory() const
    {
        queue->guard([] { throw std::bad_alloc(); });
    }
    [[nodiscard]] bool isAsBefore() const
    {
        return state().history.rows().size() == rows && hash() == before
            && sha256Of(state().surface.mesh) == mesh && state().surface.isIntact()
            && !state().lost() && queue->idle();
    }

    reference::ReferenceEngine engine;
    std::unique_ptr<OperationQueue> queue;
    std::vector<ErrorCode> told;
    bool isReady = true;
    QByteArray before;
    QByteArray mesh;
    std::size_t rows = 0;
};

} // namespace

/// Memory that is refused on the session's thread while the side thread has the surface takes the
/// edit back, and work goes on.
class AbandonedSurfaceTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void whatIsAsideIsTakenBack_data()
    {
        QTest::addColumn<std::vector<Edit>>("first");
        QTest::addColumn<Edit>("edit");
        QTest::addColumn<bool>("through");
        const Edit lay = LaySurface{.segment = 1, .vertices = 300};
        const Edit moved = push({at({27.5, 18.0, 12.0}), at({25.0, 18.0, 12.0})});
        const Edit more = test::paintAt(1, {at({24.0, 18.0, 12.0})}, 5.0);
        for (const bool through : {false, true}) {
            const auto add = [through](const char* name, const std::vector<Edit>& first,
                                 const Edit& edit) {
                QTest::addRow("%s, %s", name, through ? "when it is through" : "before it begins")
                    << first << edit << through;
            };
            add("lay", {}, lay);
            add("push", {lay}, moved);
            add("marks", {lay}, ChangeMarks{.way = ChangeMarks::Way::Invert});
            add("drop", {lay}, DropSurface{});
            add("follow", {lay, more}, FollowMask{});
            add("write back", {lay, moved}, WriteBack{});
            add("barrier", {lay}, SurfaceBarrier{});
        }
    }
    void whatIsAsideIsTakenBack()
    {
        QFETCH(const std::vector<Edit>, first);
        QFETCH(const Edit, edit);
        QFETCH(const bool, through);
        QByteArray expected;
        {
            const Bench bench(first);
            QVERIFY(bench.isReady && bench.carryOut(edit));
            expected = bench.hash();
        }
        const Bench bench(first);
        std::promise<void> gate;
        bench.state().side->post(
            [open = gate.get_future().share()] {
                open.wait();
                return SideThread::Sequel();
            },
            [](SessionState&, const Error&) {});
        bench.queue->submit(operationOf(edit));
        constexpr int portions = 50; // of what it reads, at most
        for (int i = 0; i < portions; ++i)
            bench.queue->waitForEngine();
        if (through) {
            gate.set_value();
            bench.state().side->finish();
        }
        bench.refuseMemory();
        if (!through)
            gate.set_value();
        QVERIFY(!bench.queue->settle());
        QCOMPARE(bench.told, std::vector{ErrorCode::OutOfMemory});
        QVERIFY(bench.isAsBefore());
        QVERIFY(bench.carryOut(edit));
        QCOMPARE(bench.hash(), expected);
    }

    void soIsAStrokeUnderThePen()
    {
        const std::vector<glm::dvec3> way{at({27.5, 18.0, 12.0}), at({25.0, 18.0, 12.0})};
        const Bench bench({LaySurface{.segment = 1, .vertices = 300}});
        QVERIFY(bench.isReady);
        bench.queue->submit(openOperationOf(push({way[0]})));
        OpenOperation* const stroke = bench.queue->interactive();
        QVERIFY(stroke);
        stroke->extend(bench.state(), PathPoints{.pointsLps = {way[1]}});
        bench.state().side->finish();
        QVERIFY(sha256Of(bench.state().surface.mesh) != bench.mesh);
        bench.refuseMemory();
        QVERIFY(!bench.queue->interactive());
        QVERIFY(!bench.queue->settle());
        QCOMPARE(bench.told, std::vector{ErrorCode::OutOfMemory});
        QVERIFY(bench.isAsBefore());
        QVERIFY(bench.carryOut(push(way)));
    }
};

BURIN_TEST(AbandonedSurfaceTest)

} // namespace abandonedSurfaceTest

#include "AbandonedSurfaceTest.moc"
