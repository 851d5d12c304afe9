// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/contour/ContourTool.h"

#include "core/brick/ThreadWithoutVoxels.h"
#include "core/contour/ContourRule.h"
#include "core/contour/ContourWatch.h"
#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/session/SegmentWork.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/reference/filling/Contour.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/PointerStroke.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/base/Actions.h"
#include "ui/panels/contour/ContourPanel.h"
#include "ui/views/ViewGrid.h"
#include "ui/widgets/StepSlider.h"
#include "ui/workspace/PendingSeeds.h"
#include "ui/workspace/SegmentActions.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>
#include <QTimer>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace contourToolUiTest {

namespace {

using Labels = std::vector<std::uint8_t>;

/// The real window with the small head, whose middle voxel (20, 20, 20) has the crosshair: there is
/// the ventricle (8 HU), around it the brain (40 HU). The interval holds the ventricle alone.
class Fixture : public test::WindowFixture {
public:
    Fixture()
        : test::WindowFixture(test::smallHead::volume())
        , tool(workspace)
        , panel(*new ui::ContourPanel(workspace, tool))
        , view(window.views().axial())
    {
        window.addPanel(&panel);
        window.showPanels(true);
        ui::GrowSettings growth = workspace.growSettings();
        growth.lower = -50.0;
        growth.upper = 20.0;
        workspace.setGrowSettings(growth);
        workspace.setCrosshairLps(place({20.0, 20.0, 20.0}));
        workspace.setActiveTool(&tool);
        tool.setSettings({.bubbleMm = 2.0, .valuesOfBubble = false, .generations = 30});
        tool.run().setPace(1);
        // Answers come when they are asked for.
        QObject::connect(&m_poll, &QTimer::timeout, &tool, [this] { session().poll(); });
        m_poll.start(1);
        QCoreApplication::sendPostedEvents();
    }
    [[nodiscard]] const core::EvolveContour& lastEdit()
    {
        return session().history().rows().back().edit.get<core::EvolveContour>();
    }
    [[nodiscard]] Labels labels() { return *session().questions().labels(0); }
    void click(const glm::dvec3& index) { WindowFixture::click(view, pixel(view, index)); }
    void clickBy(test::DrawnBy by, const glm::dvec3& index, Qt::KeyboardModifiers modifiers = {})
    {
        test::drawStroke(by, view, {pixel(view, index)}, modifiers);
    }
    void hoverWith(Qt::KeyboardModifiers modifiers)
    {
        hover(view, pixel(view, {20.0, 20.0, 20.0}), modifiers);
    }
    /// A ball of 8 mm around the middle: the ventricle, and the brain around it.
    void addOrgan()
    {
        apply(test::newSegment(QStringLiteral("Organ")));
        workspace.setActiveSegment(1);
        apply(test::paintAt(1, {place({20.0, 20.0, 20.0})}, 8.0));
    }
    /// How many voxels of the segment have a value.
    [[nodiscard]] std::int64_t voxelsWith(double hu)
    {
        const std::vector<std::uint16_t> codes = test::smallHead::volume().codes;
        const Labels now = labels();
        std::int64_t count = 0;
        for (std::size_t voxel = 0; voxel < now.size(); ++voxel)
            count += now[voxel] == 1 && int(codes[voxel]) - 1024 == int(hu) ? 1 : 0;
        return count;
    }
    void press(const char* button)
    {
        auto* found = panel.findChild<QPushButton*>(QLatin1String(button));
        QVERIFY(found && found->isEnabled());
        QTest::mouseClick(found, Qt::LeftButton);
    }
    template <class Widget> [[nodiscard]] Widget& in(const char* name)
    {
        auto* found = panel.findChild<Widget*>(QLatin1String(name));
        if (!found)
            qFatal("no %s", name);
        return *found;
    }
    /// All generations are worked out, and it has been played to the last one.
    [[nodiscard]] bool hasPlayed() const
    {
        const ui::ContourRun& run = tool.run();
        return run.track() && !run.isWorking() && !run.isPlaying()
            && run.track()->shown() == run.track()->known();
    }
    [[nodiscard]] int shown() const { return tool.run().track()->shown(); }
    /// Which voxels the segment would have, of the whole volume.
    [[nodiscard]] std::vector<bool> shownVoxels() const
    {
        // A state is worked out beside the window, which reads none of its voxels.
        if (!QTest::qWaitFor([this] { return tool.run().isInSight(); }))
            return {};
        const core::VoxelsAllowed looks; // a test has the time
        const glm::ivec3 size = workspace.volume()->geometry.size;
        std::vector<bool> has;
        for (int z = 0; z < size.z; ++z) {
            for (int y = 0; y < size.y; ++y) {
                for (int x = 0; x < size.x; ++x)
                    has.push_back(tool.run().state()->isInside({x, y, z}));
            }
        }
        return has;
    }
    [[nodiscard]] std::vector<bool> writtenVoxels(int label = 1)
    {
        std::vector<bool> has;
        for (const std::uint8_t each : labels())
            has.push_back(each == label);
        return has;
    }
    /// By the oracle, of a study whose labels were these.
    [[nodiscard]] std::vector<bool> expected(
        const core::EvolveContour& edit, const Labels& before, bool takesOthers = false)
    {
        const core::LoadedVolume head = test::smallHead::volume();
        return reference::evolvedContour(edit,
            core::contourRule(edit, session().document()).value(), head, before,
            [takesOthers](int) { return takesOthers; });
    }

    ui::ContourTool tool;
    ui::ContourPanel& panel;
    ui::SliceView& view;

private:
    QTimer m_poll;
};

} // namespace

class ContourToolUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// A click, a look at what evolves, an earlier generation, Enter: one row, voxel by voxel what
    /// was shown, and what the oracle says.
    void aBubbleEvolvesAndIsAccepted_data() { test::addMouseAndPen(); }
    void aBubbleEvolvesAndIsAccepted()
    {
        QFETCH(const test::DrawnBy, by);
        Fixture fixture;
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        const std::int64_t looks = core::ThreadWithoutVoxels::looks();
        fixture.clickBy(by, {20.0, 20.0, 20.0});
        QVERIFY(fixture.tool.run().isOpen());
        QTRY_VERIFY(fixture.hasPlayed());
        QTRY_VERIFY(fixture.tool.run().isInSight());
        (void)fixture.view.grab(); // it is drawn
        QCOMPARE(core::ThreadWithoutVoxels::looks(), looks); // the window read no voxels for it
        const int known = fixture.tool.run().track()->known();
        QVERIFY(fixture.tool.run().rests());
        QVERIFY2(known >= 3 && known < 30, qPrintable(QString::number(known)));
        // Nothing of the session has changed: there is not even a segment.
        QCOMPARE(fixture.rows(), std::size_t(0));
        QVERIFY(fixture.session().document().segments.empty());
        const Labels before = fixture.labels();
        QCOMPARE(std::count(before.begin(), before.end(), 0), std::ptrdiff_t(before.size()));

        QTest::keyClick(&fixture.view, Qt::Key_Left);
        QCOMPARE(fixture.shown(), known - 1);
        QTest::keyClick(&fixture.view, Qt::Key_Right);
        QTest::keyClick(&fixture.view, Qt::Key_Right); // there is no further one
        QCOMPARE(fixture.shown(), known);
        QTest::keyClick(&fixture.view, Qt::Key_Left);
        QTest::keyClick(&fixture.view, Qt::Key_Left);
        QCOMPARE(fixture.shown(), known - 2);
        const std::vector<bool> seen = fixture.shownVoxels();
        QVERIFY(std::count(seen.begin(), seen.end(), true) > 50);
        QCOMPARE(fixture.tool.run().track()->gained(),
            std::int64_t(std::count(seen.begin(), seen.end(), true)));

        QTest::keyClick(&fixture.view, Qt::Key_Return);
        QVERIFY(!fixture.tool.run().isOpen());
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(2));
        const core::EvolveContour edit = fixture.lastEdit();
        QCOMPARE(edit.generations, known - 2);
        QCOMPARE(edit.bubbleMm, 2.0);
        QCOMPARE(edit.lower, std::optional<double>(-50.0));
        QCOMPARE(edit.upper, std::optional<double>(20.0));
        QVERIFY(fixture.writtenVoxels() == seen);
        QVERIFY(seen == fixture.expected(edit, before));
        const QString name = fixture.session().history().rows().back().name;
        QVERIFY2(
            name.startsWith(QStringLiteral("Evolve the contour of 'Segment 1' from a bubble, +")),
            qPrintable(name));
        QTRY_COMPARE(said.size(), 1);
        QCOMPARE(said.back().front().toString(), name + QStringLiteral("; Ctrl+Z takes it back"));
        QVERIFY(test::isWhatARecipeComesTo(fixture.session()));
    }

    /// Ctrl and the eraser end take away what evolves from the bubble, and nothing else of the
    /// segment.
    void itErasesFromABubble_data() { test::addWhatInverts(); }
    void itErasesFromABubble()
    {
        QFETCH(const test::DrawnBy, by);
        Fixture fixture;
        fixture.addOrgan();
        const Labels before = fixture.labels();
        const std::int64_t ventricle = fixture.voxelsWith(test::smallHead::ventricleHu);
        const std::int64_t brain = fixture.voxelsWith(test::smallHead::brainHu);
        QVERIFY(ventricle > 200 && brain > 500);
        fixture.clickBy(by, {20.0, 20.0, 20.0}, test::invertingKeys(by));
        QTRY_VERIFY(fixture.hasPlayed());
        QVERIFY(fixture.tool.run().rests());
        QVERIFY2(fixture.tool.shownText().contains(QStringLiteral(" · erases ")),
            qPrintable(fixture.tool.shownText()));
        QCOMPARE(fixture.tool.run().track()->gained(), std::int64_t(0));
        const std::vector<bool> seen = fixture.shownVoxels();
        if (const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS"); !folder.isEmpty())
            fixture.window.grab().save(folder + QStringLiteral("/contour-erases.png"));
        QVERIFY(fixture.labels() == before); // nothing has changed yet
        QTest::keyClick(&fixture.view, Qt::Key_Return);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(3));
        QVERIFY(fixture.lastEdit().erase == true && fixture.lastEdit().bubbleLps);
        const QString name = fixture.session().history().rows().back().name;
        QVERIFY2(name.startsWith(QStringLiteral("Erase 'Organ' by a contour from a bubble, ")),
            qPrintable(name));
        QVERIFY(fixture.writtenVoxels() == seen);
        QVERIFY(seen == fixture.expected(fixture.lastEdit(), before));
        QVERIFY(fixture.voxelsWith(test::smallHead::ventricleHu) * 20 < ventricle);
        QVERIFY(fixture.voxelsWith(test::smallHead::brainHu) * 50 > brain * 49);
        QVERIFY(test::isWhatARecipeComesTo(fixture.session()));
    }

    /// From the segment it comes in from all around it, as far as values lie in the interval.
    void itErasesFromAllAround_data() { test::addWhatInverts(); }
    void itErasesFromAllAround()
    {
        QFETCH(const test::DrawnBy, by);
        Fixture fixture;
        fixture.addOrgan();
        const Labels before = fixture.labels();
        const std::int64_t ventricle = fixture.voxelsWith(test::smallHead::ventricleHu);
        const std::int64_t brain = fixture.voxelsWith(test::smallHead::brainHu);
        ui::GrowSettings growth = fixture.workspace.growSettings();
        growth.lower = 30.0;
        growth.upper = 60.0; // the brain alone
        fixture.workspace.setGrowSettings(growth);
        ui::ContourSettings settings = fixture.tool.settings();
        settings.start = ui::ContourSettings::Start::Segment;
        fixture.tool.setSettings(settings);
        fixture.clickBy(by, {5.0, 5.0, 20.0}, test::invertingKeys(by)); // anywhere
        QTRY_VERIFY(fixture.hasPlayed());
        const std::vector<bool> seen = fixture.shownVoxels();
        QTest::keyClick(&fixture.view, Qt::Key_Return);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(3));
        QVERIFY(fixture.lastEdit().erase == true && !fixture.lastEdit().bubbleLps);
        const QString name = fixture.session().history().rows().back().name;
        QVERIFY2(name.startsWith(QStringLiteral("Erase 'Organ' by a contour from outside, ")),
            qPrintable(name));
        QVERIFY(fixture.writtenVoxels() == seen);
        QVERIFY(seen == fixture.expected(fixture.lastEdit(), before));
        QVERIFY(fixture.voxelsWith(test::smallHead::brainHu) * 20 < brain);
        QVERIFY(fixture.voxelsWith(test::smallHead::ventricleHu) * 10 > ventricle * 9);
        QVERIFY(test::isWhatARecipeComesTo(fixture.session()));
    }

    /// Shift+click adds bubbles to what is watched; undo takes them back, one after the other.
    void furtherBubblesJoin()
    {
        Fixture fixture;
        ui::GrowSettings growth = fixture.workspace.growSettings();
        growth.upper = 60.0; // the brain as well
        fixture.workspace.setGrowSettings(growth);
        ui::ContourSettings settings = fixture.tool.settings();
        settings.generations = 2;
        fixture.tool.setSettings(settings);
        const Labels before = fixture.labels();
        // Without a contour it is the first one.
        fixture.clickBy(test::DrawnBy::Mouse, {15.0, 20.0, 20.0}, Qt::ShiftModifier);
        QTRY_VERIFY(fixture.hasPlayed());
        const std::vector<bool> alone = fixture.shownVoxels();
        QCOMPARE(fixture.tool.stepText(), QStringLiteral("the contour that is watched"));
        fixture.hoverWith(Qt::ShiftModifier);
        fixture.clickBy(test::DrawnBy::Mouse, {25.0, 20.0, 20.0}, Qt::ShiftModifier);
        QTRY_VERIFY(fixture.hasPlayed());
        QCOMPARE(fixture.shown(), 2); // where it was
        const std::vector<bool> two = fixture.shownVoxels();
        QVERIFY(std::count(two.begin(), two.end(), true)
            > std::count(alone.begin(), alone.end(), true));
        fixture.clickBy(test::DrawnBy::Mouse, {20.0, 26.0, 20.0}, Qt::ShiftModifier);
        QTRY_VERIFY(fixture.hasPlayed());
        QVERIFY(fixture.shownVoxels() != two);
        QCOMPARE(fixture.tool.stepText(), QStringLiteral("the last bubble"));
        QVERIFY(fixture.tool.canTakeStepBack());
        fixture.tool.takeStepBack();
        QTRY_VERIFY(!fixture.tool.run().isWorking());
        QVERIFY(fixture.shownVoxels() == two);
        QCOMPARE(fixture.rows(), std::size_t(0));
        // All have the radius that is set.
        fixture.tool.changeRadius(1);
        QTRY_VERIFY(!fixture.tool.run().isWorking());
        const std::vector<bool> seen = fixture.shownVoxels();
        QVERIFY(seen != two);
        QTest::keyClick(&fixture.view, Qt::Key_Return);
        QVERIFY(fixture.session().settle());
        const core::EvolveContour edit = fixture.lastEdit();
        QCOMPARE(edit.bubbleMm, 2.5);
        QVERIFY(edit.furtherBubblesLps && edit.furtherBubblesLps->size() == 1);
        QVERIFY(fixture.writtenVoxels() == seen);
        QVERIFY(seen == fixture.expected(edit, before));
        const QString name = fixture.session().history().rows().back().name;
        QVERIFY2(
            name.startsWith(QStringLiteral("Evolve the contour of 'Segment 1' from 2 bubbles, +")),
            qPrintable(name));
        QVERIFY(test::isWhatARecipeComesTo(fixture.session()));
        // A click without Shift begins anew, and there is nothing to take back but it.
        fixture.clickBy(test::DrawnBy::Mouse, {20.0, 20.0, 20.0});
        QTRY_VERIFY(fixture.hasPlayed());
        QCOMPARE(fixture.tool.stepText(), QStringLiteral("the contour that is watched"));
        fixture.tool.takeStepBack();
        QVERIFY(!fixture.tool.run().isOpen());
    }

    /// Where several bubbles are chosen, each click adds one: a pen needs no keyboard.
    void clicksAddBubbles_data() { test::addMouseAndPen(); }
    void clicksAddBubbles()
    {
        QFETCH(const test::DrawnBy, by);
        Fixture fixture;
        ui::ContourSettings settings = fixture.tool.settings();
        settings.start = ui::ContourSettings::Start::Bubbles;
        settings.generations = 2;
        QSignalSpy told(&fixture.tool, &ui::Tool::nameChanged);
        fixture.tool.setSettings(settings);
        QCOMPARE(told.size(), 1); // the hint is another one
        QCOMPARE(fixture.tool.target(), QStringLiteral("fills a new segment"));
        const Labels before = fixture.labels();
        for (const glm::dvec3& place : {glm::dvec3(15.0, 20.0, 20.0), glm::dvec3(25.0, 20.0, 20.0),
                 glm::dvec3(20.0, 26.0, 20.0)}) {
            fixture.clickBy(by, place);
            QTRY_VERIFY(fixture.hasPlayed());
        }
        const std::vector<bool> seen = fixture.shownVoxels();
        QTest::keyClick(&fixture.view, Qt::Key_Return);
        QVERIFY(fixture.session().settle());
        const core::EvolveContour edit = fixture.lastEdit();
        QVERIFY(edit.furtherBubblesLps && edit.furtherBubblesLps->size() == 2);
        QVERIFY(fixture.writtenVoxels() == seen);
        QVERIFY(seen == fixture.expected(edit, before));
        // After Esc it begins anew.
        fixture.clickBy(by, {20.0, 20.0, 20.0});
        QTRY_VERIFY(fixture.hasPlayed());
        QTest::keyClick(&fixture.view, Qt::Key_Escape);
        fixture.clickBy(by, {15.0, 20.0, 20.0});
        QTRY_VERIFY(fixture.hasPlayed());
        QCOMPARE(fixture.tool.stepText(), QStringLiteral("the contour that is watched"));
    }

    /// The values at all bubbles count as those of one sketch, if those of a bubble do.
    void furtherBubblesTellTheirValues()
    {
        Fixture fixture;
        ui::ContourSettings settings = fixture.tool.settings();
        settings.valuesOfBubble = true;
        fixture.tool.setSettings(settings);
        fixture.click({20.0, 20.0, 20.0});
        QTRY_VERIFY(fixture.hasPlayed());
        QVERIFY(fixture.workspace.growSettings().upper < test::smallHead::brainHu);
        // Most of them are in the brain then.
        for (const glm::dvec3& brain :
            {glm::dvec3(27.0, 20.0, 20.0), glm::dvec3(13.0, 20.0, 20.0)}) {
            fixture.clickBy(test::DrawnBy::Mouse, brain, Qt::ShiftModifier);
            QTRY_VERIFY(fixture.hasPlayed());
        }
        QTRY_VERIFY(fixture.workspace.growSettings().upper >= test::smallHead::brainHu);
        QTRY_VERIFY(fixture.hasPlayed());
        QTest::keyClick(&fixture.view, Qt::Key_Return);
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.lastEdit().furtherBubblesLps
            && fixture.lastEdit().furtherBubblesLps->size() == 2);
        QVERIFY(*fixture.lastEdit().upper >= test::smallHead::brainHu);
    }

    /// With a bubble added to the segment as it stands; one that erases from all around has none.
    void aBubbleJoinsTheSegment()
    {
        Fixture fixture;
        fixture.apply(test::newSegment(QStringLiteral("Organ")));
        fixture.workspace.setActiveSegment(1);
        fixture.apply(test::paintAt(1, {fixture.place({16.0, 20.0, 20.0})}, 2.5));
        ui::ContourSettings settings = fixture.tool.settings();
        settings.start = ui::ContourSettings::Start::Segment;
        settings.generations = 2;
        fixture.tool.setSettings(settings);
        const Labels before = fixture.labels();
        fixture.click({20.0, 20.0, 20.0});
        QTRY_VERIFY(fixture.hasPlayed());
        const std::vector<bool> alone = fixture.shownVoxels();
        fixture.clickBy(test::DrawnBy::Mouse, {22.0, 20.0, 20.0}, Qt::ShiftModifier);
        QTRY_VERIFY(fixture.hasPlayed());
        const std::vector<bool> seen = fixture.shownVoxels();
        QVERIFY(seen != alone);
        // Taken back, it is as if it had not been added; and at the generation that one looks at.
        const double lower = fixture.workspace.growSettings().lower;
        fixture.tool.takeStepBack();
        QTRY_VERIFY(fixture.hasPlayed());
        QVERIFY(fixture.shownVoxels() == alone);
        const auto isAt = [&fixture](int generation) {
            const ui::ContourRun& run = fixture.tool.run();
            return run.track() && !run.isWorking() && !run.isPlaying()
                && fixture.shown() == generation;
        };
        fixture.tool.run().goTo(1);
        QTRY_VERIFY(isAt(1));
        fixture.clickBy(test::DrawnBy::Mouse, {22.0, 20.0, 20.0}, Qt::ShiftModifier);
        QTRY_VERIFY(fixture.tool.run().shownEdit() && fixture.tool.run().shownEdit()->bubbleLps);
        QTRY_VERIFY(isAt(1));
        QTest::qWait(100);
        QVERIFY(isAt(1));
        QCOMPARE(fixture.workspace.growSettings().lower, lower);
        fixture.tool.run().goTo(2);
        QTRY_VERIFY(fixture.hasPlayed());
        QVERIFY(fixture.shownVoxels() == seen);
        QTest::keyClick(&fixture.view, Qt::Key_Return);
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.lastEdit().bubbleLps && !fixture.lastEdit().furtherBubblesLps);
        QVERIFY(fixture.writtenVoxels() == seen);
        QVERIFY(seen == fixture.expected(fixture.lastEdit(), before));
        fixture.clickBy(test::DrawnBy::Mouse, {20.0, 20.0, 20.0}, Qt::ControlModifier);
        QVERIFY(fixture.tool.run().isOpen());
        fixture.tool.addBubble(fixture.place({20.0, 20.0, 20.0})); // begins anew
        QTRY_VERIFY(fixture.hasPlayed());
        QVERIFY(fixture.tool.run().shownEdit());
        QVERIFY(!fixture.tool.run().shownEdit()->bubbleLps);
    }

    /// From a bubble around each seed of the active segment that no growth has come to.
    void seedsEvolve()
    {
        Fixture fixture;
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        for (const char* name : {"Organ", "Other"})
            fixture.apply(test::newSegment(QLatin1String(name)));
        fixture.workspace.setActiveSegment(1);
        ui::ContourSettings settings = fixture.tool.settings();
        settings.start = ui::ContourSettings::Start::Seeds;
        fixture.tool.setSettings(settings);
        fixture.click({20.0, 20.0, 20.0});
        QCOMPARE(said.size(), 1);
        QVERIFY(said.back().front().toString().contains(QStringLiteral("no seeds that wait")));
        QVERIFY(!fixture.tool.run().isOpen());
        fixture.apply(core::SeedStroke{.segment = 1,
            .pointsLps = {fixture.place({18.0, 20.0, 20.0}), fixture.place({22.0, 20.0, 20.0})}});
        fixture.apply(
            core::SeedStroke{.segment = 2, .pointsLps = {fixture.place({20.0, 24.0, 20.0})}});
        QTRY_COMPARE(fixture.workspace.seeds().seeds().size(), std::size_t(3));
        const Labels before = fixture.labels();
        fixture.click({5.0, 5.0, 20.0}); // anywhere
        QTRY_VERIFY(fixture.hasPlayed());
        const std::vector<bool> seen = fixture.shownVoxels();
        QVERIFY(std::count(seen.begin(), seen.end(), true) > 50);
        QTest::keyClick(&fixture.view, Qt::Key_Return);
        QVERIFY(fixture.session().settle());
        const core::EvolveContour edit = fixture.lastEdit();
        QCOMPARE(edit.segment, 1);
        QVERIFY(edit.bubbleLps == fixture.place({18.0, 20.0, 20.0}));
        QVERIFY(
            edit.furtherBubblesLps == (std::vector<glm::dvec3>{fixture.place({22.0, 20.0, 20.0})}));
        QVERIFY(fixture.writtenVoxels() == seen);
        QVERIFY(seen == fixture.expected(edit, before));
        QVERIFY(test::isWhatARecipeComesTo(fixture.session()));
    }

    /// A bubble that holds all of the segment has nothing left to evolve into.
    void aBubbleOverAllErasesAll()
    {
        Fixture fixture;
        fixture.apply(test::newSegment(QStringLiteral("Organ")));
        fixture.workspace.setActiveSegment(1);
        fixture.apply(test::paintAt(1, {fixture.place({20.0, 20.0, 20.0})}, 1.5));
        fixture.clickBy(test::DrawnBy::Eraser, {20.0, 20.0, 20.0});
        QTRY_VERIFY(fixture.hasPlayed());
        QTest::keyClick(&fixture.view, Qt::Key_Return);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(3));
        QVERIFY(fixture.voxels().empty());
    }

    void whatCannotBeErasedSaysWhy()
    {
        Fixture fixture;
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        fixture.clickBy(test::DrawnBy::Eraser, {20.0, 20.0, 20.0});
        QCOMPARE(said.size(), 1);
        QCOMPARE(said.back().front().toString(), QStringLiteral("There is no segment to erase"));
        QVERIFY(!fixture.tool.run().isOpen());
        QCOMPARE(fixture.rows(), std::size_t(0));
        fixture.addOrgan();
        fixture.clickBy(test::DrawnBy::Eraser, {35.0, 20.0, 20.0});
        QTRY_COMPARE(said.size(), 2);
        QCOMPARE(said.back().front().toString(),
            QStringLiteral("The segment has no voxels in the bubble"));
        QVERIFY(!fixture.tool.run().isOpen());
        QCOMPARE(fixture.rows(), std::size_t(2));
        // What it would do is said before the click.
        fixture.hoverWith({});
        QCOMPARE(fixture.tool.target(), QStringLiteral("evolves Organ"));
        fixture.hoverWith(Qt::ControlModifier);
        QCOMPARE(fixture.tool.target(), QStringLiteral("erases Organ"));
        QVERIFY(fixture.tool.hint().contains(QStringLiteral("eraser end")));
        QVERIFY(fixture.tool.keys().contains(QStringLiteral("Ctrl erases")));
    }

    /// Each generation that the bar of the panel shows is what its button writes.
    void theBarGoesForwardsAndBackwards()
    {
        Fixture fixture;
        fixture.press("contourPlay"); // a bubble at the crosshair
        QTRY_VERIFY(fixture.hasPlayed());
        const int known = fixture.tool.run().track()->known();
        auto& bar = fixture.in<ui::StepSlider>("contourBar");
        QCOMPARE(bar.maximum(), known);
        QCOMPARE(bar.value(), known);
        const auto drag = [&](int generation) {
            QTest::mouseClick(&bar, Qt::LeftButton, {},
                QPoint(int(std::lround(bar.xOf(generation))), bar.height() / 2));
        };
        std::vector<std::vector<bool>> states;
        for (int generation = 0; generation <= known; ++generation) {
            drag(generation);
            QCOMPARE(fixture.shown(), generation);
            states.push_back(fixture.shownVoxels());
        }
        for (int generation = known; generation >= 0; generation -= 2) {
            drag(generation);
            QVERIFY(fixture.shownVoxels() == states[std::size_t(generation)]);
        }
        drag(0);
        QVERIFY(!fixture.in<QPushButton>("contourAccept").isEnabled());
        // Played from there, it goes to the end; at the end, from the beginning.
        fixture.press("contourPlay");
        QVERIFY(fixture.tool.run().isPlaying());
        QTRY_VERIFY(fixture.hasPlayed());
        fixture.press("contourPlay");
        QTRY_VERIFY(fixture.hasPlayed());
        QVERIFY(fixture.shownVoxels() == states.back());
        for (const int generation : {known, 1}) {
            drag(generation);
            fixture.press("contourAccept");
            QVERIFY(fixture.session().settle());
            QCOMPARE(fixture.lastEdit().generations, generation);
            QVERIFY(fixture.writtenVoxels() == states[std::size_t(generation)]);
            QVERIFY(fixture.session().undo() && fixture.session().settle());
            QTRY_VERIFY(fixture.session().idle());
            fixture.press("contourPlay");
            QTRY_VERIFY(fixture.hasPlayed());
        }
        QVERIFY(fixture.shownVoxels() == states.back());
    }

    /// Esc, the button, undo, another tool and closing leave nothing.
    void nothingIsLeft_data()
    {
        QTest::addColumn<int>("how");
        for (int how = 0; how < 5; ++how)
            QTest::addRow("way %d", how) << how;
    }
    void nothingIsLeft()
    {
        QFETCH(const int, how);
        Fixture fixture;
        fixture.apply(test::newSegment(QStringLiteral("Organ")));
        fixture.workspace.setActiveSegment(1);
        fixture.apply(test::paintAt(1, {fixture.place({20.0, 20.0, 20.0})}, 1.0));
        const Labels before = fixture.labels();
        const QByteArray hash = fixture.session().stateHash();
        fixture.click({20.0, 20.0, 20.0});
        if (how != 0) // else it is dropped while voxels are read
            QTRY_VERIFY(fixture.hasPlayed());
        if (how <= 1)
            QTest::keyClick(&fixture.view, Qt::Key_Escape);
        else if (how == 2)
            fixture.press("contourAbort");
        else if (how == 3)
            fixture.window.actionTable()[QStringLiteral("edit.undo")].trigger();
        else
            fixture.workspace.setActiveTool(nullptr);
        QVERIFY(!fixture.tool.run().isOpen());
        QVERIFY(!fixture.tool.run().track());
        QVERIFY(!fixture.tool.run().shownEdit());
        QTest::qWait(30);
        QVERIFY(!fixture.tool.run().track());
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(2));
        QCOMPARE(fixture.session().stateHash(), hash);
        QVERIFY(fixture.labels() == before);
        fixture.workspace.setActiveTool(&fixture.tool);
        QVERIFY(!fixture.in<QPushButton>("contourAbort").isEnabled());
        QVERIFY(!fixture.in<QPushButton>("contourAccept").isEnabled());
    }

    /// What drops a contour without being asked to says so, before it does what it was asked for.
    void whatDropsItSaysSo_data()
    {
        QTest::addColumn<QString>("how");
        QTest::addColumn<bool>("waits");
        for (const char* how : {"redo", "another tool", "another segment"}) {
            QTest::addRow("%s", how) << QString::fromLatin1(how) << false;
            QTest::addRow("%s, before it begins", how) << QString::fromLatin1(how) << true;
        }
    }
    void whatDropsItSaysSo()
    {
        QFETCH(const QString, how);
        QFETCH(const bool, waits);
        Fixture fixture;
        for (const char* name : {"Organ", "Other"})
            fixture.apply(test::newSegment(QLatin1String(name)));
        fixture.workspace.setActiveSegment(1);
        fixture.apply(test::paintAt(2, {fixture.place({23.0, 20.0, 20.0})}, 2.0));
        const Labels painted = fixture.labels();
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QTRY_VERIFY(fixture.session().idle());
        if (waits) { // for the values of the bubble
            ui::ContourSettings settings = fixture.tool.settings();
            settings.valuesOfBubble = true;
            fixture.tool.setSettings(settings);
        }
        fixture.click({20.0, 20.0, 20.0});
        QCOMPARE(fixture.tool.run().isOpen(), !waits);
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        QAction& redo = fixture.window.actionTable()[QStringLiteral("edit.redo")];
        QVERIFY(redo.isEnabled());
        if (how == QLatin1String("redo"))
            redo.trigger();
        else if (how == QLatin1String("another tool"))
            fixture.workspace.setActiveTool(nullptr);
        else
            fixture.workspace.setActiveSegment(2);
        QVERIFY(!fixture.tool.run().isOpen());
        QVERIFY(!said.empty());
        QCOMPARE(said.front().front().toString(),
            QStringLiteral(
                "The contour was dropped, as nobody had accepted it; nothing has changed"));
        QVERIFY(fixture.session().settle());
        QTest::qWait(30);
        QVERIFY(!fixture.tool.run().isOpen()); // nor does it begin later
        QCOMPARE(fixture.labels() == painted, how == QLatin1String("redo"));
        QCOMPARE(fixture.rows(), std::size_t(3));
        // Where nothing is watched, nothing is said.
        said.clear();
        fixture.workspace.setActiveTool(fixture.workspace.activeTool() ? nullptr : &fixture.tool);
        QCOMPARE(said.size(), 0);
    }

    /// The interval of growth is told at the pointer only where a click starts with it.
    void thePointerTellsWhatCounts()
    {
        Fixture fixture;
        fixture.hoverWith({});
        const auto shown = [&fixture](double lower, bool ofBubble) {
            ui::ContourSettings settings = fixture.tool.settings();
            settings.valuesOfBubble = ofBubble;
            fixture.tool.setSettings(settings);
            ui::GrowSettings growth = fixture.workspace.growSettings();
            growth.lower = lower;
            fixture.workspace.setGrowSettings(growth);
            QCoreApplication::processEvents();
            return fixture.view.grab().toImage();
        };
        QVERIFY(shown(-100.0, false) != shown(-50.0, false));
        QCOMPARE(shown(-100.0, true), shown(-50.0, true));
    }

    /// Where there is no segment one is made when the contour is accepted, and not before.
    void noSegmentIsLeft()
    {
        Fixture fixture;
        const QByteArray hash = fixture.session().stateHash();
        QCOMPARE(fixture.tool.target(), QStringLiteral("fills a new segment"));
        fixture.click({20.0, 20.0, 20.0});
        QTRY_VERIFY(fixture.hasPlayed());
        const std::vector<bool> seen = fixture.shownVoxels();
        QVERIFY(std::count(seen.begin(), seen.end(), true) > 50);
        QTest::keyClick(&fixture.view, Qt::Key_Escape);
        QVERIFY(!fixture.tool.run().isOpen());
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(0));
        QVERIFY(fixture.session().document().segments.empty());
        QCOMPARE(fixture.session().stateHash(), hash);
        // A segment that somebody makes meanwhile is another one: nothing is watched any more.
        fixture.click({20.0, 20.0, 20.0});
        QVERIFY(fixture.tool.run().isOpen());
        QVERIFY(ui::addSegment(fixture.workspace));
        QVERIFY(!fixture.tool.run().isOpen());
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QTRY_VERIFY(fixture.session().idle());
        QVERIFY(fixture.session().document().segments.empty());
        fixture.click({20.0, 20.0, 20.0});
        QTRY_VERIFY(fixture.hasPlayed());
        QVERIFY(fixture.shownVoxels() == seen);
        QTest::keyClick(&fixture.view, Qt::Key_Return);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().document().segments.size(), std::size_t(1));
        const int label = fixture.session().document().segments.front().label;
        QCOMPARE(fixture.lastEdit().segment, label);
        QCOMPARE(fixture.workspace.activeSegment(), label);
        QVERIFY(fixture.writtenVoxels(label) == seen);
    }

    /// Where memory is used up it stops and says so; what is shown can be accepted.
    void memoryEndsIt()
    {
        Fixture fixture;
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        fixture.tool.run().setMostBytes(0.0); // not even one generation
        fixture.click({20.0, 20.0, 20.0});
        QTRY_VERIFY(fixture.hasPlayed());
        QCOMPARE(said.size(), 1);
        QVERIFY(said.front().front().toString().contains(QStringLiteral("more memory")));
        QVERIFY(fixture.tool.run().isOutOfMemory() && !fixture.tool.run().rests());
        QCOMPARE(fixture.panel.summary(), QStringLiteral("no more memory"));
        QCOMPARE(fixture.tool.run().track()->known(), 0);
        QVERIFY(!fixture.tool.run().shownEdit());
        // A box of fewer voxels than the study has, and some of what changes.
        const double least = core::watchedContourBytes(40U * 40U * 40U, 0);
        fixture.tool.drop();
        QTest::qWait(1);
        fixture.tool.run().setMostBytes(least + 4.0 * 100.0);
        ui::GrowSettings growth = fixture.workspace.growSettings();
        growth.upper = 100.0; // the brain as well
        fixture.workspace.setGrowSettings(growth);
        fixture.click({20.0, 20.0, 20.0});
        QTRY_VERIFY(fixture.hasPlayed());
        QVERIFY(fixture.tool.run().isOutOfMemory());
        QCOMPARE(said.size(), 2);
        QVERIFY(fixture.shown() >= 1);
        const std::vector<bool> seen = fixture.shownVoxels();
        fixture.press("contourAccept");
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.writtenVoxels() == seen);
    }

    /// From the segment as it stands, with a new rule by slider and field while it is watched.
    void theSegmentEvolvesAsTheSlidersSay()
    {
        Fixture fixture;
        fixture.apply(test::newSegment(QStringLiteral("Organ")));
        fixture.workspace.setActiveSegment(1);
        fixture.apply(test::paintAt(1, {fixture.place({21.0, 20.0, 20.0})}, 2.5));
        const Labels before = fixture.labels();
        ui::ContourSettings settings = fixture.tool.settings();
        settings.start = ui::ContourSettings::Start::Segment;
        settings.generations = 3;
        fixture.tool.setSettings(settings);
        fixture.click({5.0, 5.0, 20.0}); // anywhere
        QTRY_VERIFY(fixture.hasPlayed());
        QCOMPARE(fixture.shown(), 3);
        QVERIFY(!fixture.tool.run().rests());
        const std::vector<bool> first = fixture.shownVoxels();

        fixture.in<QSlider>("contourSmoothness").setValue(0);
        QCOMPARE(fixture.tool.settings().smoothness, 0);
        QTRY_VERIFY(!fixture.tool.run().isWorking());
        QCOMPARE(fixture.shown(), 3); // where it was
        fixture.in<QDoubleSpinBox>("contourUpper").setValue(60.0); // the brain as well
        QCOMPARE(fixture.workspace.growSettings().upper, 60.0);
        QTRY_VERIFY(!fixture.tool.run().isWorking());
        fixture.in<QSlider>("contourEdge").setValue(30);
        QTRY_VERIFY(!fixture.tool.run().isWorking());
        fixture.in<QSlider>("contourSmoothness").setValue(20);
        QTRY_VERIFY(!fixture.tool.run().isWorking());
        fixture.in<QSpinBox>("contourGenerations").setValue(7);
        QTRY_VERIFY(!fixture.tool.run().isWorking());
        QCOMPARE(fixture.tool.run().track()->known(), 7);
        QCOMPARE(fixture.shown(), 3);
        QTest::keyClick(&fixture.view, Qt::Key_Right);
        QTest::keyClick(&fixture.view, Qt::Key_Right);
        QCOMPARE(fixture.shown(), 5);
        const std::vector<bool> seen = fixture.shownVoxels();
        QVERIFY(seen != first);
        fixture.press("contourAccept");
        QVERIFY(fixture.session().settle());
        const core::EvolveContour edit = fixture.lastEdit();
        QVERIFY(!edit.bubbleLps);
        QCOMPARE(edit.smoothness, 20);
        QCOMPARE(edit.edge, 30);
        QVERIFY(edit.edgeGradient > 0.0);
        QCOMPARE(edit.generations, 5);
        QVERIFY(fixture.writtenVoxels() == seen);
        QVERIFY(seen == fixture.expected(edit, before));
    }

    /// Other segments, locks and the editable range count for what is shown as for what is written.
    void whatMayNotChangeStays_data()
    {
        QTest::addColumn<bool>("over");
        QTest::addColumn<bool>("locked");
        QTest::addColumn<bool>("ranged");
        QTest::addRow("others stay") << false << false << false;
        QTest::addRow("over others") << true << false << false;
        QTest::addRow("over others, but it is locked") << true << true << false;
        QTest::addRow("editable range") << true << false << true;
    }
    void whatMayNotChangeStays()
    {
        QFETCH(const bool, over);
        QFETCH(const bool, locked);
        QFETCH(const bool, ranged);
        Fixture fixture;
        for (const char* name : {"Organ", "Other"})
            fixture.apply(test::newSegment(QLatin1String(name)));
        fixture.apply(test::paintAt(2, {fixture.place({23.0, 20.0, 20.0})}, 2.0));
        if (locked)
            fixture.apply(test::lockSegment(2));
        fixture.workspace.setActiveSegment(1);
        if (ranged)
            fixture.workspace.setEditableSettings(
                {.on = true, .where = ui::EditableSettings::Where::Inside, .segment = 2});
        QWidget parent;
        QWidget* options = fixture.tool.createOptions(&parent);
        auto* overOthers = options->findChild<QCheckBox*>(QStringLiteral("contourOverwrite"));
        QVERIFY(overOthers);
        if (over)
            overOthers->click();
        const Labels before = fixture.labels();
        fixture.click({20.0, 20.0, 20.0});
        QTRY_VERIFY(fixture.hasPlayed());
        const std::vector<bool> seen = fixture.shownVoxels();
        QVERIFY(std::count(seen.begin(), seen.end(), true) > 5);
        QTest::keyClick(&fixture.view, Qt::Key_Enter);
        QVERIFY(fixture.session().settle());
        const core::EvolveContour edit = fixture.lastEdit();
        QCOMPARE(edit.overwriteUnlocked, over);
        QCOMPARE(edit.editable.has_value(), ranged);
        QVERIFY(fixture.writtenVoxels() == seen);
        const bool takes = over && !locked;
        std::vector<bool> expected = fixture.expected(edit, before, takes);
        for (std::size_t voxel = 0; ranged && voxel < expected.size(); ++voxel)
            expected[voxel] = expected[voxel] && before[voxel] == 2;
        QVERIFY(seen == expected);
        const std::vector<bool> others = fixture.writtenVoxels(2);
        const std::ptrdiff_t left = std::count(others.begin(), others.end(), true);
        const std::ptrdiff_t had = std::count(before.begin(), before.end(), 2);
        QCOMPARE(left < had, takes);
    }

    /// Labels that change while it is watched are those with which it begins.
    void itFollowsTheLabels()
    {
        Fixture fixture;
        for (const char* name : {"Organ", "Other"})
            fixture.apply(test::newSegment(QLatin1String(name)));
        fixture.workspace.setActiveSegment(1);
        fixture.click({20.0, 20.0, 20.0});
        QTRY_VERIFY(fixture.hasPlayed());
        const std::vector<bool> first = fixture.shownVoxels();
        fixture.apply(test::paintAt(2, {fixture.place({23.0, 20.0, 20.0})}, 2.0));
        QTRY_VERIFY(!fixture.tool.run().isWorking() && fixture.tool.run().shownEdit());
        const std::vector<bool> seen = fixture.shownVoxels();
        QVERIFY(seen != first);
        const Labels before = fixture.labels();
        fixture.press("contourAccept");
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.writtenVoxels() == seen);
        QVERIFY(seen == fixture.expected(fixture.lastEdit(), before));
        // Another one is active: nothing is watched any more.
        fixture.click({20.0, 20.0, 20.0});
        QTRY_VERIFY(fixture.hasPlayed());
        fixture.workspace.setActiveSegment(2);
        QVERIFY(!fixture.tool.run().isOpen());
    }

    /// A bubble sets the interval as a sketch does, unless somebody has set one.
    void aBubbleTellsTheValues()
    {
        Fixture fixture;
        auto& ofBubble = fixture.in<QCheckBox>("contourOfBubble");
        QVERIFY(!ofBubble.isChecked());
        ofBubble.click();
        QVERIFY(fixture.tool.settings().valuesOfBubble);
        ui::GrowSettings growth = fixture.workspace.growSettings();
        growth.lower = 500.0;
        growth.upper = 600.0;
        fixture.workspace.setGrowSettings(growth);
        fixture.click({20.0, 20.0, 20.0});
        QVERIFY(!fixture.tool.run().isOpen()); // it is looked at first
        QTRY_VERIFY(fixture.hasPlayed());
        growth = fixture.workspace.growSettings();
        QVERIFY2(growth.lower > -500.0 && growth.lower <= test::smallHead::ventricleHu
                && growth.upper >= test::smallHead::ventricleHu
                && growth.upper < test::smallHead::brainHu,
            qPrintable(QStringLiteral("%1 … %2").arg(growth.lower).arg(growth.upper)));
        QCOMPARE(fixture.tool.run().track()->gained(),
            test::smallHead::voxelsOf(test::smallHead::ventricleHu));
        // Esc while it is looked at: nothing begins.
        fixture.click({20.0, 20.0, 20.0});
        QTest::keyClick(&fixture.view, Qt::Key_Escape);
        QTest::qWait(30);
        QVERIFY(!fixture.tool.run().isOpen());
        // What is typed stays.
        fixture.in<QDoubleSpinBox>("contourUpper").setValue(60.0);
        QVERIFY(!ofBubble.isChecked());
        fixture.click({20.0, 20.0, 20.0});
        QTRY_VERIFY(fixture.hasPlayed());
        QCOMPARE(fixture.workspace.growSettings().upper, 60.0);
        QVERIFY(fixture.tool.run().track()->gained()
            > test::smallHead::voxelsOf(test::smallHead::ventricleHu));
    }

    /// What a dialog previews is no reason to wait, and Esc is not about it.
    void aPreviewHoldsNothingUp()
    {
        Fixture fixture;
        fixture.addOrgan();
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        // It is worked on as long as nobody polls.
        QVERIFY(fixture.session().begin(core::ReshapeSegment{
            .segment = 1, .operation = core::ShapeOperation::Grow, .mm = 3.0}));
        QVERIFY(fixture.session().segmentWork().percent() && fixture.session().openIsPreview());
        fixture.tool.cancel();
        QVERIFY(fixture.session().segmentWork().percent() && fixture.session().openIsPreview());
        const ui::ViewContext context = fixture.view.context();
        ui::PointerSample sample;
        sample.position = context.toPixel(fixture.place({20.0, 20.0, 20.0}));
        fixture.tool.press(sample, context);
        fixture.tool.release(sample, context);
        for (const QList<QVariant>& each : said)
            QVERIFY2(!each.front().toString().contains(QStringLiteral("worked out")),
                qPrintable(each.front().toString()));
        QTRY_VERIFY(fixture.hasPlayed());
        QVERIFY(!fixture.session().openEdit());
    }

    void whatCannotBeSaysWhy()
    {
        Fixture fixture;
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        QSignalSpy failed(&fixture.workspace, &ui::Workspace::failed);
        fixture.click({20.0, 60.0, 20.0});
        QCOMPARE(said.size(), 1);
        QCOMPARE(said.back().front().toString(), QStringLiteral("Click inside the volume"));
        ui::ContourSettings settings = fixture.tool.settings();
        settings.start = ui::ContourSettings::Start::Segment;
        fixture.tool.setSettings(settings);
        QCOMPARE(fixture.tool.target(), QStringLiteral("no segment to begin with"));
        fixture.click({20.0, 20.0, 20.0});
        QCOMPARE(said.size(), 2);
        QCOMPARE(fixture.rows(), std::size_t(0));
        fixture.apply(test::newSegment(QStringLiteral("Organ")));
        fixture.workspace.setActiveSegment(1);
        fixture.click({20.0, 20.0, 20.0});
        QTRY_COMPARE(said.size(), 3);
        QVERIFY(said.back().front().toString().contains(QStringLiteral("has no voxels")));
        QVERIFY(!fixture.tool.run().isOpen());
        fixture.apply(test::lockSegment(1));
        QCOMPARE(fixture.tool.target(), QStringLiteral("Organ is locked"));
        QCOMPARE(failed.size(), 0);
        settings.start = ui::ContourSettings::Start::Bubble;
        fixture.tool.setSettings(settings);
        fixture.click({20.0, 20.0, 20.0});
        QTRY_COMPARE(failed.size(), 1);
        QVERIFY(!fixture.tool.run().isOpen());
        QCOMPARE(fixture.rows(), std::size_t(2));
    }

    /// The panel is there with the tool alone; what a session kept comes back, within bounds.
    void settingsAreKept()
    {
        Fixture fixture;
        QVERIFY(fixture.panel.hasSomething());
        QTRY_VERIFY(fixture.panel.isVisible());
        fixture.workspace.setActiveTool(nullptr);
        QVERIFY(!fixture.panel.hasSomething());
        QTRY_VERIFY(!fixture.panel.isVisible());
        fixture.workspace.setActiveTool(&fixture.tool);
        QTRY_VERIFY(fixture.panel.isVisible());
        const ui::ContourSettings settings{.start = ui::ContourSettings::Start::Segment,
            .bubbleMm = 7.5,
            .valuesOfBubble = false,
            .softness = 60,
            .smoothness = 70,
            .edge = 80,
            .edgeGradient = 33.0,
            .generations = 44};
        fixture.tool.setSettings(settings);
        QCOMPARE(fixture.in<QSlider>("contourSoftness").value(), 60);
        QCOMPARE(fixture.in<QSlider>("contourSmoothness").value(), 70);
        QCOMPARE(fixture.in<QSlider>("contourEdge").value(), 80);
        QCOMPARE(fixture.in<QDoubleSpinBox>("contourGradient").value(), 33.0);
        QCOMPARE(fixture.in<QSpinBox>("contourGenerations").value(), 44);
        QVERIFY(fixture.tool.settings() == settings); // showing them changes nothing
        QWidget parent;
        QWidget* options = fixture.tool.createOptions(&parent);
        auto* start = options->findChild<QComboBox*>(QStringLiteral("contourStart"));
        auto* bubble = options->findChild<QDoubleSpinBox*>(QStringLiteral("contourBubble"));
        QVERIFY(start && bubble);
        QCOMPARE(start->currentText(), QStringLiteral("from the segment"));
        QCOMPARE(bubble->value(), 7.5);
        fixture.tool.changeRadius(2);
        QCOMPARE(bubble->value(), 8.5);
        bubble->setValue(7.5);
        const QJsonObject kept = fixture.tool.settingsJson();
        fixture.tool.setSettings({});
        fixture.tool.applySettings(kept);
        QVERIFY(fixture.tool.settings() == settings);
        ui::ContourSettings seeds = settings;
        seeds.start = ui::ContourSettings::Start::Seeds;
        fixture.tool.setSettings(seeds);
        QCOMPARE(start->currentText(), QStringLiteral("from the seeds"));
        const QJsonObject ofSeeds = fixture.tool.settingsJson();
        fixture.tool.setSettings({});
        fixture.tool.applySettings(ofSeeds);
        QVERIFY(fixture.tool.settings() == seeds);
        ui::ContourSettings bubbles = settings;
        bubbles.start = ui::ContourSettings::Start::Bubbles;
        fixture.tool.setSettings(bubbles);
        QCOMPARE(start->currentText(), QStringLiteral("from bubbles"));
        const QJsonObject ofBubbles = fixture.tool.settingsJson();
        fixture.tool.setSettings({});
        fixture.tool.applySettings(ofBubbles);
        QVERIFY(fixture.tool.settings() == bubbles);
        // Sessions that know of no seeds say one of two.
        fixture.tool.applySettings({{QStringLiteral("fromSegment"), false}});
        QVERIFY(fixture.tool.settings().start == ui::ContourSettings::Start::Bubble);
        fixture.tool.applySettings({{QStringLiteral("fromSegment"), true}});
        QVERIFY(fixture.tool.settings() == settings);
        fixture.tool.applySettings({{QStringLiteral("bubbleMm"), -1.0},
            {QStringLiteral("smoothness"), 101}, {QStringLiteral("generations"), 0}});
        QVERIFY(fixture.tool.settings() == settings);
    }
};

BURIN_WINDOW_TEST(ContourToolUiTest)

} // namespace contourToolUiTest

#include "ContourToolUiTest.moc"
