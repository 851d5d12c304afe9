// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/edits/kinds/layers/AddLayer.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/edits/kinds/sculpt/DrillStroke.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/tools/growth/BarrierTool.h"
#include "ui/tools/growth/PaintTool.h"
#include "ui/tools/growth/SeedTool.h"
#include "ui/tools/growth/ShrinkPreview.h"
#include "ui/tools/growth/ShrinkTool.h"
#include "ui/tools/sculpt/CarveBrushTool.h"
#include "ui/tools/sculpt/DrillTool.h"
#include "ui/views/ViewGrid.h"

#include <QtTest>

#include <vector>

namespace waitingStrokesUiTest {

namespace {

using Brush = ui::Workspace::Brush;

/// The small head, whose bone the 3D view sees from the front.
class BareHead : public test::WindowFixture {
public:
    BareHead()
        : test::WindowFixture(test::smallHead::volume())
        , view(window.views().volume())
    {
        ui::Workspace::VolumeDisplay display = workspace.volumeDisplay();
        display.surfaceThreshold = 300.0;
        workspace.setVolumeDisplay(display);
        view.lookFrom({0.0, -1.0, 0.0});
    }
    /// A pixel over the bone, away from the middle.
    [[nodiscard]] QPointF beside(double mm = 8.0) const
    {
        const double perMm = 1.0 / view.context().mmPerPixel();
        return QPointF(view.width(), view.height()) / 2.0 + QPointF(mm * perMm, 0.0);
    }
    /// A stroke over the bone, away from the seed, which is let go of before its place is known.
    void drawUnanswered(ui::Tool& tool, double mm = 8.0)
    {
        workspace.setActiveTool(&tool);
        const QPointF at = beside(mm);
        test::Pen pen(view);
        pen.press(at, 1.0, 100);
        pen.move(at + QPointF(4, 0), 1.0, 110);
        pen.release(at + QPointF(4, 0), 120);
    }
    void answered()
    {
        for (int round = 0; round < 3; ++round) {
            session().poll();
            QVERIFY(session().settle());
        }
    }
    [[nodiscard]] const core::Edit& lastEdit() { return session().history().rows().back().edit; }

    ui::VolumeView& view;
};

/// The head with a second sculpt layer and two segments: the first one has grown through the bone,
/// the second one lies in another label plane.
class TwoSegments : public BareHead {
public:
    TwoSegments()
    {
        apply(core::AddLayer{.name = QStringLiteral("Sculpt 2")});
        apply(test::newSegment(QStringLiteral("Bone"), 1));
        apply(test::seedAt(1, {glm::dvec3(0.0, -14.0, 0.0)}));
        apply(test::growBetween(500.0, 1200.0));
        core::AddSegment other;
        other.name = QStringLiteral("Other");
        other.plane = 1;
        apply(other);
        workspace.setActiveSegment(1);
        workspace.setActiveLayer(1);
    }
    /// Something else becomes active, and is set, while the stroke waits.
    void chooseOthers()
    {
        workspace.setActiveSegment(2);
        workspace.setActiveLayer(2);
        for (const Brush brush : {Brush::Paint, Brush::Carve, Brush::Barrier}) {
            ui::Workspace::BrushSettings settings = workspace.brushSettings(brush);
            settings.overwriteUnlocked = true;
            workspace.setBrushSettings(brush, settings);
        }
        ui::Workspace::DrillSettings drill = workspace.drillSettings();
        drill.depthMm = 11.0;
        drill.sweep = ui::Workspace::Sweep::LeftRight;
        workspace.setDrillSettings(drill);
    }
};

/// A sketch whose pen is down until it is lifted.
class OpenSketch {
public:
    enum class By { Tip, Eraser, Mouse, MouseWithCtrl };
    OpenSketch(ui::VolumeView& view, By by, const QPointF& at)
        : m_view(view)
        , m_by(by)
        , m_at(at)
        , m_pen(view, by == By::Eraser ? test::Pen::End::Eraser : test::Pen::End::Tip)
    {
        if (isMouse()) {
            test::WindowFixture::mouse(m_view, QEvent::MouseButtonPress, m_at, keys());
            m_at += QPointF(4, 0);
            test::WindowFixture::mouse(m_view, QEvent::MouseMove, m_at, keys());
        } else {
            m_pen.press(m_at, 1.0, 100);
            m_at += QPointF(4, 0);
            m_pen.move(m_at, 1.0, 110);
        }
    }
    void lift()
    {
        if (isMouse())
            test::WindowFixture::mouse(m_view, QEvent::MouseButtonRelease, m_at, keys());
        else
            m_pen.release(m_at, 120);
    }
    [[nodiscard]] static bool isInverse(By by)
    {
        return by == By::Eraser || by == By::MouseWithCtrl;
    }

private:
    [[nodiscard]] bool isMouse() const { return m_by == By::Mouse || m_by == By::MouseWithCtrl; }
    [[nodiscard]] Qt::KeyboardModifiers keys() const
    {
        return m_by == By::MouseWithCtrl ? Qt::ControlModifier : Qt::NoModifier;
    }

    ui::VolumeView& m_view;
    By m_by;
    QPointF m_at;
    test::Pen m_pen;
};

/// Where the seeds of a plain sketch lie; it is taken back again.
std::vector<glm::dvec3> seedsOfASketch(TwoSegments& fixture, ui::SeedTool& tool)
{
    fixture.drawUnanswered(tool);
    fixture.answered();
    const std::vector<glm::dvec3> places = fixture.lastEdit().get<core::SeedStroke>().pointsLps;
    if (!fixture.session().undo() || !fixture.session().settle())
        qFatal("nothing to undo");
    return places;
}

} // namespace

/// Strokes and sketches in the 3D view that are let go of before the question of their place is
/// answered.
class WaitingStrokesUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void paintGoesToWhatWasActive()
    {
        TwoSegments fixture;
        ui::PaintTool tool(fixture.workspace);
        const std::size_t rows = fixture.rows();
        fixture.drawUnanswered(tool);
        QCOMPARE(fixture.rows(), rows);
        fixture.chooseOthers();
        fixture.answered();
        QCOMPARE(fixture.rows(), rows + 1);
        const auto& edit = fixture.lastEdit().get<core::PaintStroke>();
        QCOMPARE(edit.segment, 1);
        QVERIFY(edit.seeds); // as the segment has some
        QVERIFY(!edit.overwriteUnlocked);
        QCOMPARE(fixture.workspace.activeSegment(), 2);
    }

    /// Also where the stroke makes the first segment, once it has met something.
    void paintKeepsToTheRangeOfPenDown()
    {
        BareHead fixture;
        ui::PaintTool tool(fixture.workspace);
        ui::EditableSettings range{.on = true, .byValue = true, .lower = 500.0, .upper = 1200.0};
        fixture.workspace.setEditableSettings(range);
        const std::optional<core::EditableRange> chosen = fixture.workspace.editableRange();
        QVERIFY(chosen);
        fixture.drawUnanswered(tool);
        range.lower = -1500.0;
        fixture.workspace.setEditableSettings(range);
        fixture.answered();
        QCOMPARE(fixture.session().document().segments.size(), std::size_t(1));
        const auto& edit = fixture.lastEdit().get<core::PaintStroke>();
        QCOMPARE(edit.segment, 1);
        QVERIFY(edit.editable == chosen);
    }

    void carvingGoesToTheLayerThatWasActive()
    {
        TwoSegments fixture;
        ui::CarveBrushTool tool(fixture.workspace);
        const std::size_t rows = fixture.rows();
        fixture.drawUnanswered(tool);
        fixture.chooseOthers();
        fixture.answered();
        QCOMPARE(fixture.rows(), rows + 1);
        QCOMPARE(fixture.lastEdit().get<core::BrushStroke>().layer, 1);
    }

    void aBarrierIsOneOfTheGrowthThatWasActive()
    {
        TwoSegments fixture;
        ui::BarrierTool tool(fixture.workspace);
        const std::size_t rows = fixture.rows();
        fixture.drawUnanswered(tool);
        fixture.chooseOthers();
        fixture.answered();
        QCOMPARE(fixture.rows(), rows + 1);
        QVERIFY(!fixture.lastEdit().get<core::BarrierStroke>().plane);
    }

    void seedsAreThoseOfTheSegmentThatWasActive()
    {
        TwoSegments fixture;
        ui::SeedTool tool(fixture.workspace);
        const std::size_t rows = fixture.rows();
        fixture.workspace.setActiveSegment(2);
        fixture.drawUnanswered(tool);
        fixture.workspace.setActiveSegment(1);
        fixture.answered();
        QCOMPARE(fixture.rows(), rows + 1);
        QCOMPARE(fixture.lastEdit().get<core::SeedStroke>().segment, 2);
        QCOMPARE(fixture.workspace.activeSegment(), 1);
    }

    /// In the other plane nothing has grown that could be taken back.
    void theGrowthThatWasActiveIsTakenBack()
    {
        TwoSegments fixture;
        ui::ShrinkTool tool(fixture.workspace);
        const std::size_t rows = fixture.rows();
        fixture.drawUnanswered(tool);
        fixture.chooseOthers();
        fixture.answered();
        QCOMPARE(fixture.rows(), rows + 1);
        QVERIFY(!fixture.lastEdit().get<core::ShrinkAt>().plane);
    }

    void undoDropsASketchThatWaits_data()
    {
        QTest::addColumn<bool>("shrinks");
        QTest::newRow("seed") << false;
        QTest::newRow("shrink") << true;
    }
    void undoDropsASketchThatWaits()
    {
        QFETCH(const bool, shrinks);
        TwoSegments fixture;
        ui::SeedTool seed(fixture.workspace);
        ui::ShrinkTool shrink(fixture.workspace);
        ui::SketchTool& tool = shrinks ? static_cast<ui::SketchTool&>(shrink) : seed;
        fixture.workspace.setActiveSegment(shrinks ? 1 : 2);
        fixture.workspace.setActiveTool(&tool);
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        QAction& undo = fixture.window.actionTable()[QStringLiteral("edit.undo")];
        const std::size_t rows = fixture.rows();
        const core::RowId position = fixture.session().history().position();
        QVERIFY(!tool.canTakeStepBack());
        fixture.drawUnanswered(tool);
        QVERIFY(tool.canTakeStepBack());
        QVERIFY(undo.text().contains(QStringLiteral("the stroke that is about to come")));
        undo.trigger();
        QVERIFY(!tool.canTakeStepBack());
        QCOMPARE(said.back()[0].toString(), QStringLiteral("The sketch was dropped"));
        if (shrinks)
            QVERIFY(shrink.preview().words().isEmpty());
        fixture.answered();
        QCOMPARE(fixture.rows(), rows);
        QCOMPARE(fixture.session().history().position(), position);
        // The next one is carried out, and then there is nothing to drop.
        fixture.drawUnanswered(tool);
        fixture.answered();
        QCOMPARE(fixture.rows(), rows + 1);
        QVERIFY(!tool.canTakeStepBack());
    }

    void undoDropsOnlyTheLastOfTwo()
    {
        TwoSegments fixture;
        ui::SeedTool tool(fixture.workspace);
        fixture.workspace.setActiveSegment(2);
        const std::vector<glm::dvec3> first = seedsOfASketch(fixture, tool);
        QVERIFY(!first.empty());
        const std::size_t rows = fixture.rows();
        fixture.drawUnanswered(tool);
        fixture.drawUnanswered(tool, -6.0);
        fixture.window.actionTable()[QStringLiteral("edit.undo")].trigger();
        QVERIFY(tool.canTakeStepBack());
        fixture.answered();
        QCOMPARE(fixture.rows(), rows + 1);
        QVERIFY(fixture.lastEdit().get<core::SeedStroke>().pointsLps == first);
        QVERIFY(!tool.canTakeStepBack());
    }

    /// It was drawn after the one that waits.
    void undoDropsTheOneUnderThePenFirst()
    {
        TwoSegments fixture;
        ui::SeedTool tool(fixture.workspace);
        fixture.workspace.setActiveSegment(2);
        const std::vector<glm::dvec3> first = seedsOfASketch(fixture, tool);
        const std::size_t rows = fixture.rows();
        fixture.drawUnanswered(tool);
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        OpenSketch next(fixture.view, OpenSketch::By::Tip, fixture.beside(-6.0));
        fixture.window.actionTable()[QStringLiteral("edit.undo")].trigger();
        QVERIFY(!said.isEmpty());
        QCOMPARE(said.back()[0].toString(), QStringLiteral("The sketch was dropped"));
        QVERIFY(tool.canTakeStepBack());
        next.lift();
        fixture.answered();
        QCOMPARE(fixture.rows(), rows + 1);
        QVERIFY(fixture.lastEdit().get<core::SeedStroke>().pointsLps == first);
    }

    /// Each is what it was begun as, whichever is drawn when the answer comes.
    void eachKeepsItsOwnKeys_data()
    {
        using By = OpenSketch::By;
        QTest::addColumn<int>("waiting");
        QTest::addColumn<int>("drawn");
        QTest::newRow("tip, then eraser") << int(By::Tip) << int(By::Eraser);
        QTest::newRow("eraser, then tip") << int(By::Eraser) << int(By::Tip);
        QTest::newRow("plain, then Ctrl") << int(By::Mouse) << int(By::MouseWithCtrl);
        QTest::newRow("Ctrl, then plain") << int(By::MouseWithCtrl) << int(By::Mouse);
    }
    void eachKeepsItsOwnKeys()
    {
        using By = OpenSketch::By;
        QFETCH(const int, waiting);
        QFETCH(const int, drawn);
        TwoSegments fixture;
        ui::ShrinkTool tool(fixture.workspace);
        fixture.workspace.setActiveTool(&tool);
        const std::size_t rows = fixture.rows();
        OpenSketch first(fixture.view, By(waiting), fixture.beside());
        first.lift();
        QVERIFY(tool.canTakeStepBack());
        OpenSketch next(fixture.view, By(drawn), fixture.beside(-6.0));
        fixture.answered();
        QCOMPARE(fixture.rows(), rows + 1);
        QCOMPARE(
            fixture.lastEdit().get<core::ShrinkAt>().onlyHere, OpenSketch::isInverse(By(waiting)));
        // So that the next one meets a growth that is whole.
        QVERIFY(fixture.session().undo());
        fixture.answered();
        next.lift();
        fixture.answered();
        QCOMPARE(fixture.rows(), rows + 2);
        QCOMPARE(
            fixture.lastEdit().get<core::ShrinkAt>().onlyHere, OpenSketch::isInverse(By(drawn)));
    }

    void theDrillGoesInAsItWasSet()
    {
        TwoSegments fixture;
        ui::DrillTool tool(fixture.workspace);
        fixture.workspace.setDrillSettings(
            {.radiusMm = 3.0, .depthMm = 6.0, .sweep = ui::Workspace::Sweep::Normal});
        const std::size_t rows = fixture.rows();
        fixture.drawUnanswered(tool);
        fixture.chooseOthers();
        fixture.answered();
        QCOMPARE(fixture.rows(), rows + 1);
        const auto& edit = fixture.lastEdit().get<core::DrillStroke>();
        QCOMPARE(edit.layer, 1);
        QCOMPARE(edit.depthMm, 6.0);
        // Across the bone's face, which looks to the front and to the right, and not along it.
        const glm::dvec3 way = glm::normalize(edit.view.targetLps - edit.view.eyeLps);
        QVERIFY(way.y > 0.7);
    }

    /// A pen that rests goes deeper in mode Rate, whatever is set after it has gone down.
    void theDrillRestsInTheModeOfPenDown()
    {
        TwoSegments fixture;
        ui::DrillTool tool(fixture.workspace);
        fixture.workspace.setActiveTool(&tool);
        ui::Workspace::DrillSettings drill = fixture.workspace.drillSettings();
        drill.mode = core::DrillMode::Rate;
        drill.sweep = ui::Workspace::Sweep::Normal;
        fixture.workspace.setDrillSettings(drill);
        test::Pen pen(fixture.view);
        pen.press(fixture.beside(), 1.0, 100);
        QVERIFY(!fixture.session().transactionOpen());
        drill.mode = core::DrillMode::Limit;
        fixture.workspace.setDrillSettings(drill);
        const auto samples = [&fixture]() -> std::size_t {
            fixture.session().poll();
            const core::Edit* open = fixture.session().openEdit();
            return open ? open->get<core::DrillStroke>().samples.size() : 0;
        };
        QTRY_VERIFY(samples() > 3);
        pen.release(fixture.beside(), 400);
        fixture.answered();
        QCOMPARE(fixture.lastEdit().get<core::DrillStroke>().mode, core::DrillMode::Rate);
    }
};

BURIN_WINDOW_TEST(WaitingStrokesUiTest)

} // namespace waitingStrokesUiTest

#include "WaitingStrokesUiTest.moc"
