// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/LabelFetch.h"

#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/engine/EngineCommands.h"
#include "core/engine/EngineResult.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/measure/LiveStatistics.h"
#include "ui/tools/contour/ContourRun.h"

#include <QSignalSpy>
#include <QTimer>
#include <QtTest>

#include <functional>
#include <set>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace labelFetchUiTest {

namespace {

/// The oracle, which fails to read bricks when it is told to.
class FailingReads final : public core::EditEngine {
public:
    core::Result<void> openVolume(
        const glm::ivec3& size, std::span<const std::uint16_t> codes) override
    {
        return m_inner.openVolume(size, codes);
    }
    core::Ticket submit(core::EngineCommand command) override
    {
        const bool fails = mayFail > 0 && std::holds_alternative<core::ReadBricks>(command);
        const core::Ticket ticket = m_inner.submit(std::move(command));
        if (fails) {
            m_failing.insert(ticket);
            --mayFail;
            ++failures;
        }
        return ticket;
    }
    [[nodiscard]] std::vector<core::EngineResult> collect() override
    {
        std::vector<core::EngineResult> results = m_inner.collect();
        for (core::EngineResult& result : results) {
            if (m_failing.erase(result.ticket) > 0)
                result.error =
                    core::Error{core::ErrorCode::Internal, {QStringLiteral("bricks"), QString()}};
        }
        return results;
    }
    void finish() override { m_inner.finish(); }
    void setWakeUp(std::function<void()> wakeUp) override { m_inner.setWakeUp(std::move(wakeUp)); }
    [[nodiscard]] core::GrowthProgress growthProgress() const override
    {
        return m_inner.growthProgress();
    }

    static constexpr int always = 1000000;
    int mayFail = 0; ///< so often from now on
    int failures = 0; ///< so far

private:
    reference::ReferenceEngine m_inner;
    std::set<core::Ticket> m_failing;
};

/// The small head with a segment of a few voxels.
struct Fixture {
    Fixture()
        : workspace(frames)
    {
        auto session = core::EditSession::create(engine, test::smallHead::volume(), {});
        if (!session)
            qFatal("no session");
        workspace.setSession(std::move(*session));
        apply(test::newSegment(QStringLiteral("Organ")));
        apply(test::paintAt(1, {glm::dvec3(0.0)}, 2.0));
        // Answers come when they are asked for.
        QObject::connect(&poll, &QTimer::timeout, &poll, [this] { workspace.session()->poll(); });
        poll.start(1);
    }
    void apply(const core::Edit& edit)
    {
        if (!workspace.session()->apply(edit) || !workspace.session()->settle())
            qFatal("no edit");
    }

    FailingReads engine;
    test::NoFrames frames;
    ui::Workspace workspace;
    QTimer poll;
};

core::EvolveContour someContour()
{
    return {.segment = 1, .lower = -30.0, .upper = 80.0, .softness = 10.0, .generations = 3};
}

} // namespace

/// Who reads labels again when the study was edited meanwhile does not do so for ever.
class LabelFetchUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// A few failures in a row without an edit are enough; an edit, a success and cancelling begin
    /// the count anew.
    void failuresInARowAreCounted()
    {
        Fixture fixture;
        ui::LabelFetch fetch;
        QSignalSpy failed(&fetch, &ui::LabelFetch::failed);
        QSignalSpy finished(&fetch, &ui::LabelFetch::finished);
        const core::Error error{core::ErrorCode::Internal, {}};
        const auto fail = [&](int times) {
            fixture.engine.mayFail = times;
            for (int each = 0; each < times; ++each) {
                const qsizetype before = failed.size();
                fetch.start(*fixture.workspace.session(), {0});
                QTRY_COMPARE(failed.size(), before + 1);
            }
        };
        constexpr int most = ui::LabelFetch::mostFailures;
        fail(most - 1);
        QVERIFY(fetch.mayTryAgain(error));
        QVERIFY(!fetch.mayTryAgain({core::ErrorCode::OutOfMemory, {}}));
        fail(1);
        QVERIFY(!fetch.mayTryAgain(error));
        fixture.apply(test::paintAt(1, {glm::dvec3(5.0, 0.0, 0.0)}, 2.0));
        fail(1);
        QVERIFY(fetch.mayTryAgain(error));
        fail(most - 1);
        QVERIFY(!fetch.mayTryAgain(error));
        fetch.start(*fixture.workspace.session(), {0});
        QTRY_COMPARE(finished.size(), 1);
        fail(most - 1);
        QVERIFY(fetch.mayTryAgain(error));
        fetch.cancel();
        fail(most - 1);
        QVERIFY(fetch.mayTryAgain(error));
    }

    /// What is previewed since is no step yet, and its labels are not those that were asked for.
    void whatBeginsToStandOpenIsNotRead()
    {
        Fixture fixture;
        core::EditSession& session = *fixture.workspace.session();
        ui::LabelFetch fetch;
        QSignalSpy failed(&fetch, &ui::LabelFetch::failed);
        QSignalSpy finished(&fetch, &ui::LabelFetch::finished);
        fetch.start(session, {0});
        QVERIFY(session.begin(core::ReshapeSegment{
            .segment = 1, .operation = core::ShapeOperation::Grow, .mm = 2.0}));
        QTRY_COMPARE(failed.size() + finished.size(), 1);
        QCOMPARE(failed.size(), 1);
        QVERIFY(session.openIsPreview());
        session.end(core::Ending::Rollback);
        fetch.start(session, {0});
        QTRY_COMPARE(finished.size(), 1);
        QCOMPARE(failed.size(), 1);
    }

    /// Until all is read, or nobody wants it any more.
    void othersKnowThatSomebodyReads()
    {
        Fixture fixture;
        const core::VoxelQuestions& questions = fixture.workspace.session()->questions();
        ui::LabelFetch fetch;
        QSignalSpy finished(&fetch, &ui::LabelFetch::finished);
        QSignalSpy failed(&fetch, &ui::LabelFetch::failed);
        QVERIFY(!questions.isBeingRead());
        fetch.start(*fixture.workspace.session(), {0});
        QVERIFY(questions.isBeingRead());
        QTRY_COMPARE(finished.size(), 1);
        QVERIFY(!questions.isBeingRead());
        fetch.start(*fixture.workspace.session(), {0});
        fetch.cancel();
        QVERIFY(!questions.isBeingRead());
        fixture.engine.mayFail = 1;
        fetch.start(*fixture.workspace.session(), {0});
        QTRY_COMPARE(failed.size(), 1);
        QVERIFY(!questions.isBeingRead());
    }

    /// A contour is dropped, with the reason, once.
    void aContourGivesUp()
    {
        Fixture fixture;
        ui::ContourRun run(fixture.workspace);
        run.setPace(1);
        QSignalSpy failed(&run, &ui::ContourRun::failed);
        fixture.engine.mayFail = FailingReads::always;
        run.begin(someContour());
        QTRY_COMPARE(failed.size(), 1);
        QVERIFY(!run.isOpen());
        QCOMPARE(fixture.engine.failures, ui::LabelFetch::mostFailures);
        QTest::qWait(100);
        QCOMPARE(failed.size(), 1);
        QCOMPARE(fixture.engine.failures, ui::LabelFetch::mostFailures);
        // One that fails for a moment comes after all.
        fixture.engine.mayFail = ui::LabelFetch::mostFailures - 1;
        run.begin(someContour());
        QTRY_VERIFY(run.track() && !run.isWorking());
        QCOMPARE(fixture.engine.mayFail, 0);
        QCOMPARE(failed.size(), 1);
    }

    /// So do statistics, until the study is edited.
    void statisticsGiveUp()
    {
        Fixture fixture;
        ui::LiveStatistics statistics(fixture.workspace);
        QSignalSpy failed(&statistics, &ui::LiveStatistics::failed);
        fixture.engine.mayFail = FailingReads::always;
        statistics.setWatched(true);
        QTRY_COMPARE(failed.size(), 1);
        QVERIFY(!statistics.isLooking());
        QCOMPARE(fixture.engine.failures, ui::LabelFetch::mostFailures);
        QTest::qWait(300);
        QCOMPARE(failed.size(), 1);
        QCOMPARE(fixture.engine.failures, ui::LabelFetch::mostFailures);
        fixture.engine.mayFail = 0;
        fixture.apply(test::paintAt(1, {glm::dvec3(5.0, 0.0, 0.0)}, 2.0));
        QTRY_VERIFY(statistics.of(1));
        QVERIFY(!statistics.isBehind(1));
        QCOMPARE(failed.size(), 1);
    }
};

BURIN_WINDOW_TEST(LabelFetchUiTest)

} // namespace labelFetchUiTest

#include "LabelFetchUiTest.moc"
