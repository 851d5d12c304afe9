// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/growth/GrowthTurns.h"

#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/session/EditSession.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/panels/growth/GrowthPanel.h"
#include "ui/tasks/growth/GrowthRun.h"
#include "ui/widgets/HistogramRange.h"
#include "ui/workspace/PendingSeeds.h"
#include "ui/workspace/SegmentActions.h"

#include <QAbstractButton>
#include <QLabel>
#include <QtTest>

#include <utility>

namespace growthTurnsUiTest {

using test::WorkspaceFixture;
using ui::GrowthTurn;
using ui::growthTurns;
using Segments = std::vector<int>;

namespace {

/// Ventricle and brain of the small head, sketched one after the other, each with the interval
/// that was offered.
class TwoSegments : public WorkspaceFixture {
public:
    TwoSegments()
        : panel(workspace)
    {
        panel.show();
        // The fronts in the shell of brain meet, which the guard would ask about.
        ui::GrowSettings settings = workspace.growSettings();
        settings.guard.on = false;
        workspace.setGrowSettings(settings);
        sketch(1, {0.0, 0.0, 0.0});
        sketch(2, {8.0, 0.0, 0.0});
    }
    void click(const char* name)
    {
        QTest::mouseClick(panel.findChild<QAbstractButton*>(QLatin1String(name)), Qt::LeftButton);
    }
    [[nodiscard]] bool waitUntilGrown()
    {
        // To settle would end a growth that is under way.
        const bool over = QTest::qWaitFor([this] {
            session().poll();
            return !panel.running();
        });
        settle();
        return over;
    }
    [[nodiscard]] std::int64_t voxels(int label)
    {
        return session().document().segment(label)->voxels;
    }
    ui::GrowthPanel panel;

private:
    void sketch(int label, const glm::dvec3& lps)
    {
        if (!ui::addSegment(workspace))
            qFatal("no segment");
        apply(test::seedAt(label, {lps}));
        const bool offered = QTest::qWaitFor([&] {
            settle();
            return workspace.seeds().intervals().of(label).has_value();
        });
        if (!offered)
            qFatal("no interval was offered");
    }
};

/// As a dialog shows it.
core::Edit preview(int segment)
{
    return core::ReshapeSegment{
        .segment = segment, .operation = core::ShapeOperation::Grow, .mm = 2.0};
}

} // namespace

class GrowthTurnsUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void oneIntervalIsOneTurnOfAll()
    {
        QVERIFY(growthTurns({}, 1, {}).empty());
        const std::vector<GrowthTurn> all{{.lower = 3.0, .upper = 5.0}};
        QCOMPARE(growthTurns({{7, 3.0, 5.0}}, 1, {}), all);
        QCOMPARE(growthTurns({{1, 3.0, 5.0}, {2, 3.0, 5.0, false}}, 2, {}), all);
    }

    void eachGrowsInItsOwnInterval()
    {
        // The active one begins; what has grown in another interval rests.
        const std::vector<GrowthTurn> turns = growthTurns(
            {{1, 0.0, 10.0}, {2, 100.0, 110.0}, {3, 50.0, 60.0, false}}, 2, Segments{3});
        QCOMPARE(turns,
            (std::vector<GrowthTurn>{{.segments = Segments{2}, .lower = 100.0, .upper = 110.0},
                {.segments = Segments{1}, .lower = 0.0, .upper = 10.0}}));
    }

    /// Bone would claim the seeds of a vessel whose interval lies within its own.
    void theInnerIntervalGrowsFirst()
    {
        const std::vector<GrowthTurn> turns{
            {.segments = Segments{2}, .lower = 250.0, .upper = 450.0},
            {.segments = Segments{1}, .lower = 226.0, .upper = 3071.0}};
        QCOMPARE(growthTurns({{1, 226.0, 3071.0}, {2, 250.0, 450.0}}, 1, {}), turns);
        QCOMPARE(growthTurns({{1, 226.0, 3071.0}, {2, 250.0, 450.0}}, 2, {}), turns);
    }

    void thoseThatCompeteGrowTogether()
    {
        const std::vector<GrowthTurn> together{
            {.segments = Segments{1, 4}, .lower = 0.0, .upper = 12.0}};
        QCOMPARE(growthTurns({{1, 0.0, 10.0}, {4, 2.0, 12.0}}, 4, {}), together);
        // They go on together; others that resemble them do not.
        QCOMPARE(growthTurns({{1, 0.0, 10.0, false}, {2, 1.0, 11.0, false}, {4, 2.0, 12.0, false}},
                     4, Segments{1, 4}),
            together);
    }

    /// One press of Grow: two rows, and neither segment took what belongs to the other's interval.
    void segmentsGrowOneAfterTheOther()
    {
        TwoSegments two;
        const auto* told = two.panel.findChild<QLabel*>(QStringLiteral("growTurns"));
        QVERIFY(told->isVisible());
        QCOMPARE(told->text(),
            QStringLiteral("One after the other, each in its own interval: Segment 2, Segment 1."));
        const core::RowId before = two.session().history().position();
        two.click("growPlay");
        QVERIFY(two.waitUntilGrown());
        const core::History& history = two.session().history();
        QCOMPARE(history.position(), before + 2);
        for (const int label : {2, 1}) {
            const core::Edit& grown = history.row(before + (label == 2 ? 1 : 2)).edit;
            QVERIFY(grown.is<core::GrowSteps>());
            QCOMPARE(core::growCriteriaOf(grown)->segments, std::optional(Segments{label}));
        }
        QCOMPARE(two.voxels(1), test::smallHead::voxelsOf(test::smallHead::ventricleHu));
        QCOMPARE(two.voxels(2), test::smallHead::voxelsOf(test::smallHead::brainHu));
        QCOMPARE(told->text(),
            QStringLiteral("Only Segment 2 grows: the others have intervals of their own."));
    }

    /// A preview that a dialog shows between two turns goes, and comes again after them.
    void aPreviewBetweenTurnsHoldsNothingUp()
    {
        TwoSegments two;
        const core::RowId before = two.session().history().position();
        auto* run = two.panel.findChild<ui::GrowthRun*>();
        QVERIFY(run);
        bool isBetween = false;
        QObject::connect(run, &ui::GrowthRun::changed, run, [&] {
            if (isBetween || !run->running() || two.session().transactionOpen())
                return;
            isBetween = two.session().begin(preview(2)).has_value();
        });
        two.click("growPlay");
        QVERIFY(two.waitUntilGrown());
        QVERIFY(isBetween);
        QCOMPARE(two.session().history().position(), before + 2);
        QCOMPARE(two.voxels(1), test::smallHead::voxelsOf(test::smallHead::ventricleHu));
        QCOMPARE(two.voxels(2), test::smallHead::voxelsOf(test::smallHead::brainHu));
    }

    /// Somebody's stroke closes the growth; who pauses that afterwards does not end the stroke.
    void aStrokeIsNotEndedWithTheGrowth()
    {
        TwoSegments two;
        ui::GrowSettings settings = two.workspace.growSettings();
        settings.generationsPerSecond = 1.0;
        two.workspace.setGrowSettings(settings);
        two.click("growPlay");
        QVERIFY(two.panel.running());
        const core::Edit stroke = test::paintAt(1, {glm::dvec3(0.0)}, 1.0);
        QVERIFY(two.session().begin(stroke));
        QVERIFY(two.panel.running()); // nobody has looked yet
        two.click("growPlay");
        QVERIFY(!two.panel.running());
        QVERIFY(two.session().isOpen<core::PaintStroke>());
        two.session().end(core::Ending::Rollback);
        // Nor does one that looks by itself.
        two.settle();
        two.click("growPlay");
        QVERIFY(two.panel.running());
        QVERIFY(two.session().begin(stroke));
        QTRY_VERIFY(!two.panel.running());
        QVERIFY(two.session().isOpen<core::PaintStroke>());
        two.session().end(core::Ending::Rollback);
        two.settle();
    }

    /// One that begins while a turn grows ends the growth, and stays.
    void aPreviewEndsTheGrowth()
    {
        TwoSegments two;
        auto* run = two.panel.findChild<ui::GrowthRun*>();
        QVERIFY(run);
        bool isBeside = false;
        QObject::connect(
            run, &ui::GrowthRun::changed, run,
            [&] {
                if (!isBeside && run->running() && two.session().transactionOpen())
                    isBeside = two.session().begin(preview(2)).has_value();
            },
            Qt::QueuedConnection);
        two.click("growPlay");
        QTRY_VERIFY(isBeside);
        QTRY_VERIFY(!two.panel.running());
        QVERIFY(two.session().openIsPreview());
        two.session().end(core::Ending::Rollback);
        two.settle();
        QVERIFY(!two.panel.running());
    }

    /// The interval of one is not forced upon the other.
    void aLiveChangeLeavesTheOthers()
    {
        TwoSegments two;
        two.click("growToClosure");
        QVERIFY(two.waitUntilGrown());
        const std::int64_t brain = two.voxels(2);
        two.workspace.setActiveSegment(1);
        auto* range = two.panel.findChild<ui::HistogramRange*>(QStringLiteral("growthInterval"));
        range->setRange(500.0, 1500.0);
        Q_EMIT range->rangeEdited(500.0, 1500.0);
        Q_EMIT range->rangeSettled();
        QVERIFY(QTest::qWaitFor([&] {
            two.settle();
            return two.voxels(1) == 0;
        }));
        QCOMPARE(two.voxels(2), brain);
        const core::History& history = two.session().history();
        const auto* change = history.row(history.position()).edit.as<core::ChangeInterval>();
        QVERIFY(change);
        QCOMPARE(change->criteria.segments, std::optional(Segments{1}));
        // Undo brings the bounds back to the segment that they belong to.
        const auto second = two.workspace.seeds().intervals().of(2);
        two.workspace.setActiveSegment(2);
        QVERIFY(two.session().undo());
        two.settle();
        QCOMPARE(two.workspace.seeds().intervals().of(2), second);
        QCOMPARE(two.workspace.growSettings().lower, second->lower);
    }

    /// Those that grew together follow an interval together, and go back to what each of them had.
    void sharedBoundsComeBack()
    {
        TwoSegments two;
        for (const int label : {1, 2}) {
            two.workspace.setActiveSegment(label);
            ui::GrowSettings settings = two.workspace.growSettings();
            settings.lower = 0.0;
            settings.upper = label == 1 ? 50.0 : 60.0;
            two.workspace.setGrowSettings(settings);
        }
        two.click("growToClosure");
        QVERIFY(two.waitUntilGrown());
        const core::History& history = two.session().history();
        const core::RowId grown = history.position();
        const core::Edit& both = history.row(grown).edit;
        QVERIFY(both.is<core::GrowSteps>());
        QCOMPARE(core::growCriteriaOf(both)->segments, std::optional(Segments{1, 2}));
        const auto interval = [&two](int label) {
            return *two.workspace.seeds().intervals().of(label);
        };
        const auto bounds = [&interval](int label) {
            return std::pair(interval(label).lower, interval(label).upper);
        };
        auto* range = two.panel.findChild<ui::HistogramRange*>(QStringLiteral("growthInterval"));
        range->setRange(0.0, 30.0);
        Q_EMIT range->rangeEdited(0.0, 30.0);
        Q_EMIT range->rangeSettled();
        QVERIFY(QTest::qWaitFor([&] {
            two.settle();
            return history.position() == grown + 1;
        }));
        for (const int label : {1, 2})
            QCOMPARE(bounds(label), std::pair(0.0, 30.0));
        for (int time = 0; time < 2; ++time) {
            QVERIFY(two.session().undo());
            two.settle();
            QCOMPARE(bounds(1), std::pair(0.0, 50.0));
            QCOMPARE(bounds(2), std::pair(0.0, 60.0));
            QCOMPARE(two.workspace.growSettings().upper, 60.0); // 2 is the active one
            QVERIFY(two.session().redo());
            two.settle();
            for (const int label : {1, 2})
                QCOMPARE(bounds(label), std::pair(0.0, 30.0));
            QCOMPARE(two.workspace.growSettings().upper, 30.0);
        }
        // What was set since, of a segment that no undone step grew, stays.
        QVERIFY(ui::addSegment(two.workspace));
        two.settle();
        ui::GrowSettings settings = two.workspace.growSettings();
        settings.upper = 77.0;
        two.workspace.setGrowSettings(settings);
        QVERIFY(two.session().goTo(grown));
        QVERIFY(two.session().goTo(grown + 2));
        two.settle();
        QCOMPARE(interval(3).upper, 77.0);
        QCOMPARE(bounds(1), std::pair(0.0, 30.0));
    }
};

BURIN_WINDOW_TEST(GrowthTurnsUiTest)

} // namespace growthTurnsUiTest

#include "GrowthTurnsUiTest.moc"
