// SPDX-License-Identifier: Apache-2.0
#include "core/session/questions/VoxelQuestions.h"
#include "ui/tasks/growth/LiveInterval.h"

#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "tests/reference/PassingEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/base/NumberText.h"
#include "ui/panels/growth/GrowthPanel.h"
#include "ui/widgets/HistogramRange.h"
#include "ui/widgets/HistogramRangePlot.h"
#include "ui/workspace/SegmentActions.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

namespace liveIntervalUiTest {

using test::WorkspaceFixture;
namespace head = test::smallHead;

namespace {

/// The growth panel on screen over the small head, its ventricle seeded; the histogram shows what
/// lies around ventricle (8 HU) and brain (40 HU).
class LivePanel : public WorkspaceFixture {
public:
    explicit LivePanel(double upper = 20.0)
        : panel(workspace)
        , range(*panel.findChild<ui::HistogramRange*>(QStringLiteral("growthInterval")))
        , plot(*range.plot())
    {
        panel.show();
        if (!QTest::qWaitForWindowExposed(&panel))
            qFatal("no panel");
        seed(upper);
    }
    /// In a session without segments.
    void seed(double upper)
    {
        if (!ui::addSegment(workspace))
            qFatal("no segment");
        apply(middleSeed(1));
        ui::GrowSettings settings = workspace.growSettings();
        settings.lower = 0.0;
        settings.upper = upper;
        workspace.setGrowSettings(settings);
        plot.showValues(-40.0, 120.0);
    }
    void grow()
    {
        panel.runToClosure();
        if (!QTest::qWaitFor([this] { return !panel.running(); }))
            qFatal("it grows on");
        settle();
        plot.showValues(-40.0, 120.0);
    }
    [[nodiscard]] QPoint at(double value) const
    {
        return {int(std::lround(plot.xOf(value))), plot.height() / 2};
    }
    void press(double value) { QTest::mousePress(&plot, Qt::LeftButton, {}, at(value)); }
    void moveTo(double value) { QTest::mouseMove(&plot, at(value)); }
    void release(double value)
    {
        QTest::mouseRelease(&plot, Qt::LeftButton, {}, at(value));
        settle();
    }
    void drag(double from, double to)
    {
        press(from);
        moveTo(0.5 * (from + to));
        moveTo(to);
        release(to);
    }
    [[nodiscard]] bool seen(const glm::ivec3& voxel, int label)
    {
        int found = -1;
        session().questions().probe(
            {voxel}, [&found](const core::Result<std::vector<core::ProbedVoxel>>& probes) {
                found = probes->front().label;
            });
        session().poll();
        return found == label;
    }
    [[nodiscard]] const core::ChangeInterval* lastChange()
    {
        const core::History& history = session().history();
        return history.position() == 0
            ? nullptr
            : history.row(history.position()).edit.as<core::ChangeInterval>();
    }
    [[nodiscard]] std::size_t rows() { return session().history().rows().size(); }
    [[nodiscard]] std::vector<std::uint8_t> labels() { return *session().questions().labels(0); }

    ui::GrowthPanel panel;
    ui::HistogramRange& range;
    ui::HistogramRangePlot& plot;
};

/// The oracle, but one that notes how it is asked.
class NotingEngine final : public reference::PassingEngine {
public:
    core::Ticket submit(core::EngineCommand command) override
    {
        if (const auto* compare = std::get_if<core::CompareGrowth>(&command))
            kept.push_back(compare->keep);
        if (std::holds_alternative<core::DropCutPreview>(command))
            ++drops;
        return PassingEngine::submit(std::move(command));
    }

    std::vector<bool> kept; ///< of each comparison
    int drops = 0;
};

constexpr glm::ivec3 inBrain{head::side / 2 + 9, head::side / 2, head::side / 2};

/// What growing from the seeds gives.
std::vector<std::uint8_t> fromScratch(double lower, double upper)
{
    WorkspaceFixture fixture;
    fixture.apply(test::newSegment(QStringLiteral("A"), 1));
    fixture.apply(WorkspaceFixture::middleSeed(1));
    fixture.apply(test::growBetween(lower, upper));
    return *fixture.session().questions().labels(0);
}

} // namespace

class LiveIntervalUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void whatHasGrownFollowsBothWays()
    {
        LivePanel fixture;
        fixture.grow();
        const std::size_t rows = fixture.rows();
        fixture.press(20.0);
        for (const double to : {60.0, 20.0, 80.0, 15.0, 60.0}) {
            fixture.moveTo(to);
            const int label = to > head::brainHu ? 1 : 0;
            QTRY_VERIFY2(fixture.seen(inBrain, label), qPrintable(QStringLiteral("at %1").arg(to)));
            QVERIFY(fixture.session().transactionOpen());
            QCOMPARE(fixture.rows(), rows);
        }
        fixture.release(60.0);
        QVERIFY(!fixture.session().transactionOpen());
        QCOMPARE(fixture.rows(), rows + 1);
        QVERIFY(fixture.lastChange());
        QCOMPARE(fixture.lastChange()->criteria.lower, 0.0);
        QCOMPARE(fixture.session().document().segments[0].voxels,
            head::voxelsOf(head::ventricleHu) + head::voxelsOf(head::brainHu));
    }

    /// What stands open since a preview has ended the change is a dialog's.
    void aPreviewIsNotEnded_data()
    {
        QTest::addColumn<bool>("isTaken");
        QTest::newRow("let go") << true;
        QTest::newRow("called off") << false;
    }
    void aPreviewIsNotEnded()
    {
        QFETCH(const bool, isTaken);
        LivePanel fixture;
        fixture.grow();
        ui::LiveInterval live(fixture.workspace);
        live.move(0.0, 60.0, std::nullopt);
        QVERIFY(fixture.session().isOpen<core::ChangeInterval>());
        QVERIFY(fixture.session().begin(core::ReshapeSegment{
            .segment = 1, .operation = core::ShapeOperation::Grow, .mm = 2.0}));
        if (isTaken)
            live.settle();
        else
            live.cancel();
        QVERIFY(fixture.session().openIsPreview());
        QVERIFY(live.possible());
        fixture.session().end(core::Ending::Rollback);
        fixture.settle();
        QVERIFY(fixture.lastChange());
    }

    /// In words beside the slider, while it moves, against what was there before it was pressed.
    void whatItSuspendsAndReachesIsTold()
    {
        LivePanel fixture;
        fixture.grow();
        const auto& line = *fixture.panel.findChild<QLabel*>(QStringLiteral("growIntervalChange"));
        const auto& live = *fixture.panel.findChild<ui::LiveInterval*>();
        const auto tells = [&](const QString& words) {
            return QTest::qWaitFor([&] {
                fixture.session().poll();
                return line.text() == words;
            });
        };
        const double voxelMm3 = fixture.workspace.volume()->geometry.voxelVolumeMm3();
        const QString brain = ui::millilitreText(head::voxelsOf(head::brainHu), voxelMm3);
        const QString ventricle = ui::millilitreText(head::voxelsOf(head::ventricleHu), voxelMm3);
        QVERIFY(line.isVisible() && line.text().isEmpty());

        fixture.press(20.0);
        fixture.moveTo(60.0);
        QVERIFY2(tells(QStringLiteral("+ ") + brain), qPrintable(line.text()));
        QCOMPARE(live.comparison()->reached, head::voxelsOf(head::brainHu));
        // Past the seed: then nothing is left.
        fixture.moveTo(2.0);
        QVERIFY2(tells(QStringLiteral("− %1 suspended").arg(ventricle)), qPrintable(line.text()));
        QCOMPARE(live.comparison()->suspended, head::voxelsOf(head::ventricleHu));
        QCOMPARE(live.comparison()->reached, std::int64_t(0));
        // It comes back.
        fixture.moveTo(21.0);
        QVERIFY2(tells(QStringLiteral("nothing changes")), qPrintable(line.text()));
        fixture.moveTo(60.0);
        QVERIFY2(tells(QStringLiteral("+ ") + brain), qPrintable(line.text()));
        fixture.release(60.0);
        QVERIFY(line.text().isEmpty() && !live.comparison());
        QVERIFY(line.isVisible()); // what is below stays where it is
        QCOMPARE(fixture.session().history().rows().back().statistics.voxelsChanged,
            head::voxelsOf(head::brainHu));

        // The next drag counts from here, and Escape ends it.
        fixture.press(fixture.range.upper());
        fixture.moveTo(20.0);
        QVERIFY2(tells(QStringLiteral("− %1 suspended").arg(brain)), qPrintable(line.text()));
        QTest::keyClick(&fixture.plot, Qt::Key_Escape);
        QVERIFY(line.text().isEmpty());
        fixture.release(20.0);
        QVERIFY(line.text().isEmpty());
        fixture.panel.findChild<QCheckBox*>(QStringLiteral("growLive"))->click();
        QVERIFY(!line.isVisible());
    }

    /// What is suspended stays marked while the 3D view shows it, however short the drag was.
    void whatTheViewIn3DShowsIsKept()
    {
        NotingEngine engine;
        LivePanel fixture;
        fixture.workspace.setSession(*core::EditSession::create(engine, head::volume(), {}));
        fixture.seed(20.0);
        fixture.grow();
        auto& box = *fixture.panel.findChild<QCheckBox*>(QStringLiteral("growSuspended"));
        const auto& line = *fixture.panel.findChild<QLabel*>(QStringLiteral("growIntervalChange"));
        fixture.press(20.0);
        fixture.moveTo(60.0);
        QVERIFY(QTest::qWaitFor([&] {
            fixture.session().poll();
            return !line.text().isEmpty();
        }));
        fixture.release(60.0);
        const std::size_t asked = engine.kept.size();
        QVERIFY(asked > 0);
        QVERIFY(std::count(engine.kept.begin(), engine.kept.end(), true) == 0);

        box.click();
        QCOMPARE(engine.drops, 0);
        fixture.drag(fixture.range.upper(), 20.0);
        QVERIFY(fixture.lastChange() && fixture.seen(inBrain, 0));
        QVERIFY(engine.kept.size() > asked);
        for (std::size_t i = asked; i < engine.kept.size(); ++i)
            QVERIFY(engine.kept[i]);
        box.click();
        fixture.settle();
        QCOMPARE(engine.drops, 1);
    }

    void aReleaseIsOneStepAndEqualsGrowingFromScratch()
    {
        LivePanel fixture;
        fixture.grow();
        std::size_t rows = fixture.rows();
        double from = 20.0;
        // Past the seed too: then nothing is left, and it comes back.
        for (const double to : {70.0, 30.0, 2.0, 45.0, 25.0, 100.0}) {
            fixture.drag(from, to);
            QCOMPARE(fixture.rows(), ++rows);
            QVERIFY(fixture.lastChange());
            const core::GrowCriteria& criteria = fixture.lastChange()->criteria;
            QVERIFY(std::abs(criteria.upper - to) < 2.0);
            QVERIFY(fixture.labels() == fromScratch(criteria.lower, criteria.upper));
            from = fixture.range.upper();
        }
        // The other bound.
        fixture.drag(0.0, 20.0);
        QCOMPARE(fixture.rows(), rows + 1);
        QCOMPARE(fixture.session().document().segments[0].voxels, std::int64_t(0));
    }

    void escapeTakesTheDragBack()
    {
        LivePanel fixture;
        fixture.grow();
        const std::size_t rows = fixture.rows();
        const QByteArray grown = fixture.session().stateHash();
        fixture.press(20.0);
        fixture.moveTo(60.0);
        QTRY_VERIFY(fixture.seen(inBrain, 1));
        QTest::keyClick(&fixture.plot, Qt::Key_Escape);
        QCOMPARE(fixture.range.upper(), 20.0);
        QCOMPARE(fixture.workspace.growSettings().upper, 20.0);
        // What is moved before the button is let go is nothing any more.
        fixture.moveTo(80.0);
        fixture.release(80.0);
        QVERIFY(!fixture.session().transactionOpen());
        QCOMPARE(fixture.rows(), rows);
        QCOMPARE(fixture.session().stateHash(), grown);
        QCOMPARE(fixture.range.upper(), 20.0);
    }

    void undoTakesTheStepBackAndTheBoundsWithIt()
    {
        LivePanel fixture;
        fixture.grow();
        const QByteArray grown = fixture.session().stateHash();
        fixture.drag(20.0, 60.0);
        const double wider = fixture.range.upper();
        QVERIFY(wider > 50.0);
        const QByteArray widened = fixture.session().stateHash();
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QCOMPARE(fixture.session().stateHash(), grown);
        QCOMPARE(fixture.range.upper(), 20.0);
        QVERIFY(fixture.session().redo());
        fixture.settle();
        QCOMPARE(fixture.session().stateHash(), widened);
        QVERIFY(std::abs(fixture.range.upper() - wider) < 0.01);
        // Other steps leave bounds alone that were moved without their growth.
        fixture.panel.findChild<QCheckBox*>(QStringLiteral("growLive"))->click();
        fixture.drag(fixture.range.upper(), 100.0);
        fixture.apply(test::newSegment(QStringLiteral("B"), 1));
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QVERIFY(fixture.range.upper() > 90.0);
    }

    void onlyWhatHasGrownFollowsAndOnlyIfAsked()
    {
        LivePanel fixture;
        const std::size_t rows = fixture.rows();
        fixture.drag(20.0, 30.0);
        QCOMPARE(fixture.rows(), rows);
        QVERIFY(std::abs(fixture.workspace.growSettings().upper - 30.0) < 2.0);
        fixture.grow();
        const QByteArray grown = fixture.session().stateHash();
        fixture.panel.findChild<QCheckBox*>(QStringLiteral("growLive"))->click();
        fixture.drag(fixture.range.upper(), 60.0);
        QCOMPARE(fixture.rows(), rows + 1);
        QCOMPARE(fixture.session().stateHash(), grown);
    }

    void aTypedNumberIsAStep()
    {
        LivePanel fixture;
        fixture.grow();
        const std::size_t rows = fixture.rows();
        auto* upper = fixture.range.findChild<QDoubleSpinBox*>(QStringLiteral("rangeUpper"));
        upper->setFocus();
        upper->selectAll();
        QTest::keyClicks(upper, QStringLiteral("50"));
        QTest::keyClick(upper, Qt::Key_Return);
        fixture.settle();
        QCOMPARE(fixture.rows(), rows + 1);
        QVERIFY(fixture.lastChange());
        QCOMPARE(fixture.lastChange()->criteria.upper, 50.0);
        QVERIFY(fixture.labels() == fromScratch(0.0, 50.0));
    }
};

BURIN_WINDOW_TEST(LiveIntervalUiTest)

} // namespace liveIntervalUiTest

#include "LiveIntervalUiTest.moc"
