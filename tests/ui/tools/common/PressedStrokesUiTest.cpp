// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/filling/EvolveContour.h"
#include "core/edits/kinds/filling/SegmentScissors.h"
#include "core/edits/kinds/sculpt/ScissorsCut.h"
#include "core/edits/kinds/splitting/SplitByCurve.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/PointerStroke.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/tools/common/PenPressure.h"
#include "ui/tools/contour/ContourTool.h"
#include "ui/tools/scissors/SegmentScissorsTool.h"
#include "ui/tools/sculpt/ScissorsTool.h"
#include "ui/views/ViewGrid.h"

#include <QTimer>
#include <QToolButton>
#include <QtTest>

#include <cmath>
#include <vector>

namespace pressedStrokesUiTest {

namespace {

using Does = ui::SegmentScissorsTool::Does;

constexpr double setMm = 5.0;
constexpr double hardest = 0.4;
constexpr double pressedMm = 2.0; ///< what that is of it
const glm::dvec3 middleVoxel(20.0, 20.0, 20.0);

/// The real window with the small head, seen from the front in 3D.
class Fixture : public test::WindowFixture {
public:
    Fixture()
        : test::WindowFixture(test::smallHead::volume())
        , view(window.views().volume())
        , slice(window.views().axial())
    {
        ui::Workspace::VolumeDisplay display = workspace.volumeDisplay();
        display.surfaceThreshold = 300.0;
        workspace.setVolumeDisplay(display);
        workspace.setCrosshairLps(place(middleVoxel));
        view.lookFrom({0.0, -1.0, 0.0});
        // Answers come when they are asked for.
        QObject::connect(&m_poll, &QTimer::timeout, &workspace, [this] { session().poll(); });
        m_poll.start(1);
    }
    /// Places of a ring around the middle of the 3D view, not quite closed.
    [[nodiscard]] std::vector<QPointF> ring() const
    {
        std::vector<QPointF> way;
        const QPointF middle = QPointF(view.width(), view.height()) / 2.0;
        for (int i = 0; i < 38; ++i) {
            const double turn = 2.0 * M_PI * i / 40.0;
            way.push_back(middle + 40.0 * QPointF(std::cos(turn), std::sin(turn)));
        }
        return way;
    }
    /// Draws the ring with a pen that touches down lightly, is pressed hardest half way, and is
    /// lifted lightly.
    void drawPressed(double pressure)
    {
        const std::vector<QPointF> way = ring();
        test::Pen pen(view);
        quint64 time = 50000;
        pen.press(way.front(), 0.1, time);
        for (std::size_t i = 1; i < way.size(); ++i)
            pen.move(way[i], i == way.size() / 2 ? pressure : 0.15, time += 8);
        pen.release(way.back(), time + 8);
        QVERIFY(session().settle());
    }
    void drawByMouse()
    {
        test::drawStroke(test::DrawnBy::Mouse, view, ring());
        QVERIFY(session().settle());
    }
    void undo()
    {
        QVERIFY(session().undo());
        QVERIFY(session().settle());
    }
    /// The switch in the option bar.
    [[nodiscard]] QToolButton& pressureButton(const char* name)
    {
        auto* button = window.findChild<QToolButton*>(QLatin1String(name));
        if (!button)
            qFatal("no %s", name);
        return *button;
    }
    template <class Edit> [[nodiscard]] const Edit& last()
    {
        return session().history().row(session().history().position()).edit.get<Edit>();
    }
    /// Whether the present step comes to the same as a recipe, behind the first so many steps.
    [[nodiscard]] bool isWhatARecipeComesTo(std::size_t behind)
    {
        const core::History& history = session().history();
        test::WorkspaceFixture recipe;
        for (std::size_t i = 0; i < behind; ++i)
            recipe.apply(history.rows()[i].edit);
        recipe.apply(history.row(history.position()).edit);
        return recipe.session().stateHash() == session().stateHash();
    }

    ui::VolumeView& view;
    ui::SliceView& slice;

private:
    QTimer m_poll;
};

/// With the bone as segment 1, erased inside of curves, down to a depth.
class SegmentFixture : public Fixture {
public:
    static constexpr std::size_t steps = 2; ///< that make the bone a segment

    SegmentFixture()
        : tool(workspace)
    {
        apply(test::newSegment(QStringLiteral("Bone"), 0xE0D0B0));
        apply(core::ThresholdSegment{.segment = 1, .lower = 300.0});
        workspace.setActiveSegment(1);
        workspace.setActiveTool(&tool);
        tool.setSettings({.depthMm = setMm});
    }

    ui::SegmentScissorsTool tool;
};

/// With a contour that evolves from bubbles; the interval holds ventricle and brain.
class ContourFixture : public Fixture {
public:
    ContourFixture()
        : tool(workspace)
    {
        ui::GrowSettings growth = workspace.growSettings();
        growth.lower = -50.0;
        growth.upper = 60.0;
        workspace.setGrowSettings(growth);
        workspace.setActiveTool(&tool);
        tool.setSettings({.bubbleMm = setMm, .valuesOfBubble = false, .generations = 3});
        tool.run().setPace(1);
        QCoreApplication::sendPostedEvents();
    }
    [[nodiscard]] bool hasPlayed() const
    {
        const ui::ContourRun& run = tool.run();
        return run.track() && !run.isWorking() && !run.isPlaying()
            && run.track()->shown() == run.track()->known();
    }
    void press(test::Pen& pen, const glm::dvec3& voxel, const std::vector<double>& pressures)
    {
        pen.press(pixel(slice, voxel), pressures.front(), m_milliseconds += 8);
        for (std::size_t i = 1; i < pressures.size(); ++i)
            pen.move(pixel(slice, voxel), pressures[i], m_milliseconds += 8);
    }
    void lift(test::Pen& pen, const glm::dvec3& voxel)
    {
        pen.release(pixel(slice, voxel), m_milliseconds += 8);
    }
    [[nodiscard]] const core::EvolveContour& accepted()
    {
        tool.accept();
        if (!session().settle())
            qFatal("the contour was not accepted");
        return last<core::EvolveContour>();
    }

    ui::ContourTool tool;

private:
    quint64 m_milliseconds = 70000;
};

} // namespace

/// Strokes of a pen that have one size, a depth or a radius: the greatest pressure of each is it.
class PressedStrokesUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void theGreatestPressureCounts()
    {
        const auto sampleOf = [](double pressure, bool isPen) {
            ui::PointerSample sample;
            sample.pressure = pressure;
            sample.isPen = isPen;
            return sample;
        };
        ui::StrokePressure stroke;
        QCOMPARE(stroke.of(10.0, 0.5), 10.0); // none yet
        stroke.begin(sampleOf(0.3, true), true);
        QVERIFY(stroke.counts());
        QCOMPARE(stroke.of(10.0, 0.5), 3.0);
        stroke.extend(sampleOf(0.7, true));
        QCOMPARE(stroke.of(10.0, 0.5), 7.0);
        stroke.extend(sampleOf(0.2, true)); // less changes nothing
        QCOMPARE(stroke.of(10.0, 0.5), 7.0);
        QCOMPARE(stroke.of(9.9, 0.5), 6.9); // as fields show it
        stroke.end();
        QVERIFY(!stroke.counts());
        QCOMPARE(stroke.of(10.0, 0.5), 10.0);
        // As a mouse, and as it is switched off at first.
        stroke.begin(sampleOf(0.3, false), true);
        QCOMPARE(stroke.of(10.0, 0.5), 10.0);
        stroke.begin(sampleOf(0.3, true), false);
        stroke.extend(sampleOf(0.5, true));
        QCOMPARE(stroke.of(10.0, 0.5), 10.0);
        // Something is left of it, and never more than is set.
        stroke.begin(sampleOf(0.01, true), true);
        QCOMPARE(stroke.of(20.0, 0.5), 2.0);
        QCOMPARE(stroke.of(2.0, 0.5), 0.5);
        QCOMPARE(stroke.of(0.3, 0.5), 0.3);
        stroke.begin(sampleOf(0.999, true), true);
        QCOMPARE(stroke.of(0.62, 0.5), 0.6);
        QCOMPARE(stroke.of(0.58, 0.5), 0.58);
    }

    void scissorsCutAsDeepAsPressed()
    {
        Fixture fixture;
        ui::ScissorsTool tool(fixture.workspace);
        fixture.workspace.setActiveTool(&tool);
        QToolButton& button = fixture.pressureButton("depthByPressure");
        QVERIFY(!button.isEnabled() && !button.isChecked()); // through everything
        tool.setSettings({.limited = true, .depthMm = setMm});
        QVERIFY(button.isEnabled());
        const auto depthMm = [&fixture] {
            return fixture.last<core::ScissorsCut>().depthMm.value_or(0.0);
        };
        fixture.drawPressed(hardest);
        QCOMPARE(depthMm(), setMm); // off, as it is at first
        const std::int64_t whole = fixture.carvedVoxels();
        fixture.undo();
        button.click();
        QVERIFY(tool.settings().depthByPressure && tool.settings().depthMm == setMm);
        fixture.drawPressed(hardest);
        QCOMPARE(depthMm(), pressedMm);
        const std::int64_t pressed = fixture.carvedVoxels();
        QVERIFY(pressed > 0 && pressed < whole);
        QVERIFY(fixture.isWhatARecipeComesTo(0));
        fixture.undo();
        fixture.drawByMouse();
        QCOMPARE(depthMm(), setMm);
        QCOMPARE(fixture.carvedVoxels(), whole);
        fixture.undo();
        // Without a depth it goes through everything, however it is pressed.
        tool.setSettings({.depthMm = setMm, .depthByPressure = true});
        fixture.drawPressed(hardest);
        QVERIFY(!fixture.last<core::ScissorsCut>().depthMm);

        ui::ScissorsTool other(fixture.workspace);
        other.applySettings(tool.settingsJson());
        QVERIFY(other.settings().depthByPressure);
    }

    void segmentScissorsEraseAsDeepAsPressed()
    {
        SegmentFixture fixture;
        QToolButton& button = fixture.pressureButton("depthByPressure");
        QVERIFY(button.isEnabled() && !button.isChecked());
        const auto depthMm = [&fixture] {
            return fixture.last<core::SegmentScissors>().depthMm.value_or(0.0);
        };
        fixture.drawPressed(hardest);
        QCOMPARE(depthMm(), setMm);
        const std::size_t whole = fixture.voxels().size();
        fixture.undo();
        const std::size_t bone = fixture.voxels().size();
        button.click();
        QVERIFY(fixture.tool.settings().depthByPressure);
        // A curve that was dropped leaves nothing of its pressure.
        const std::vector<QPointF> way = fixture.ring();
        test::Pen pen(fixture.view);
        pen.press(way[0], 1.0, 1000);
        pen.move(way[1], 1.0, 1008);
        QTest::keyClick(&fixture.view, Qt::Key_Escape);
        pen.release(way[1], 1016);
        fixture.drawPressed(hardest);
        QCOMPARE(depthMm(), pressedMm);
        const std::size_t pressed = fixture.voxels().size();
        QVERIFY(whole < pressed && pressed < bone);
        QVERIFY(fixture.isWhatARecipeComesTo(SegmentFixture::steps));
        fixture.undo();
        fixture.drawByMouse();
        QCOMPARE(depthMm(), setMm);
        fixture.undo();

        fixture.tool.setSettings({.depthByPressure = true}); // through all
        QVERIFY(!button.isEnabled());
        fixture.drawPressed(hardest);
        QVERIFY(!fixture.last<core::SegmentScissors>().depthMm);
        fixture.undo();
        fixture.tool.setSettings(
            {.does = Does::EraseOutside, .depthMm = setMm, .depthByPressure = true});
        QVERIFY(!button.isEnabled()); // there is no depth outside
        fixture.drawPressed(hardest);
        QVERIFY(!fixture.last<core::SegmentScissors>().depthMm);

        ui::SegmentScissorsTool other(fixture.workspace);
        other.applySettings(fixture.tool.settingsJson());
        QVERIFY(other.settings() == fixture.tool.settings());
    }

    void whatIsSplitOffIsAsDeepAsPressed()
    {
        SegmentFixture fixture;
        fixture.tool.setSettings(
            {.does = Does::SplitInside, .depthMm = setMm, .depthByPressure = true});
        fixture.drawPressed(hardest);
        QCOMPARE(fixture.last<core::SplitByCurve>().depthMm.value_or(0.0), pressedMm);
        QVERIFY(fixture.isWhatARecipeComesTo(SegmentFixture::steps));
    }

    void aBubbleIsAsLargeAsPressed_data()
    {
        QTest::addColumn<test::DrawnBy>("by");
        QTest::addColumn<bool>("on");
        QTest::addColumn<double>("bubbleMm");
        QTest::newRow("pen") << test::DrawnBy::Pen << true << 3.0;
        QTest::newRow("pen, switched off") << test::DrawnBy::Pen << false << setMm;
        QTest::newRow("mouse") << test::DrawnBy::Mouse << true << setMm;
    }
    void aBubbleIsAsLargeAsPressed()
    {
        QFETCH(const test::DrawnBy, by);
        QFETCH(const bool, on);
        QFETCH(const double, bubbleMm);
        ContourFixture fixture;
        QToolButton& button = fixture.pressureButton("radiusByPressure");
        QVERIFY(button.isEnabled() && !button.isChecked());
        if (on)
            button.click();
        QCOMPARE(fixture.tool.settings().radiusByPressure, on);
        if (by == test::DrawnBy::Mouse) {
            test::drawStroke(by, fixture.slice, {fixture.pixel(fixture.slice, middleVoxel)});
        } else {
            test::Pen pen(fixture.slice);
            fixture.press(pen, middleVoxel, {0.2, 0.6, 0.3});
            QCOMPARE(fixture.tool.run().isOpen(), !on); // how large is known when it is lifted
            fixture.lift(pen, middleVoxel);
        }
        QVERIFY(fixture.tool.run().isOpen());
        QTRY_VERIFY(fixture.hasPlayed());
        QCOMPARE(fixture.accepted().bubbleMm, bubbleMm);
        QVERIFY(fixture.isWhatARecipeComesTo(1));

        ui::ContourTool other(fixture.workspace);
        other.applySettings(fixture.tool.settingsJson());
        QCOMPARE(other.settings().radiusByPressure, on);
    }

    /// An edit has one radius: a further bubble is there at once, as large as the first.
    void allBubblesAreAsLargeAsTheFirst()
    {
        ContourFixture fixture;
        ui::ContourSettings settings = fixture.tool.settings();
        settings.start = ui::ContourSettings::Start::Bubbles;
        settings.radiusByPressure = true;
        fixture.tool.setSettings(settings);
        test::Pen pen(fixture.slice);
        fixture.press(pen, {16.0, 20.0, 20.0}, {0.2, 0.6});
        fixture.lift(pen, {16.0, 20.0, 20.0});
        QTRY_VERIFY(fixture.hasPlayed());
        fixture.press(pen, {24.0, 20.0, 20.0}, {1.0});
        fixture.lift(pen, {24.0, 20.0, 20.0});
        QTRY_VERIFY(fixture.hasPlayed());
        const core::EvolveContour& edit = fixture.accepted();
        QVERIFY(edit.furtherBubblesLps && edit.furtherBubblesLps->size() == 1);
        QCOMPARE(edit.bubbleMm, 3.0);
        // Where it begins with what there is, there is no radius to press.
        settings.start = ui::ContourSettings::Start::Segment;
        fixture.tool.setSettings(settings);
        QVERIFY(!fixture.pressureButton("radiusByPressure").isEnabled());
        fixture.press(pen, middleVoxel, {0.2});
        QVERIFY(fixture.tool.run().isOpen());
        fixture.lift(pen, middleVoxel);
    }

    void escapeDropsABubbleThatIsPressed()
    {
        ContourFixture fixture;
        ui::ContourSettings settings = fixture.tool.settings();
        settings.radiusByPressure = true;
        fixture.tool.setSettings(settings);
        test::Pen pen(fixture.slice);
        fixture.press(pen, middleVoxel, {0.2, 0.9});
        QTest::keyClick(&fixture.slice, Qt::Key_Escape);
        fixture.lift(pen, middleVoxel);
        QVERIFY(!fixture.tool.run().isOpen());
        // The next one is what it is pressed to itself.
        fixture.press(pen, middleVoxel, {0.2, 0.6});
        fixture.lift(pen, middleVoxel);
        QTRY_VERIFY(fixture.hasPlayed());
        QCOMPARE(fixture.accepted().bubbleMm, 3.0);
    }
};

BURIN_WINDOW_TEST(PressedStrokesUiTest)

} // namespace pressedStrokesUiTest

#include "PressedStrokesUiTest.moc"
