// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/AnyEdit.h"
#include "core/edits/kinds/EditParts.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/PointerStroke.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/menus/EditableButton.h"
#include "ui/panels/growth/GrowthPanel.h"
#include "ui/panels/growth/SpreadBar.h"
#include "ui/panels/refine/ChunksPanel.h"
#include "ui/settings/growth/GrowSettings.h"
#include "ui/tasks/growth/LiveInterval.h"
#include "ui/tools/contour/ContourTool.h"
#include "ui/tools/growth/FloodFillTool.h"
#include "ui/tools/growth/PaintTool.h"
#include "ui/tools/nudge/NudgeTool.h"
#include "ui/tools/outline/FillOutlineTool.h"
#include "ui/tools/refine/ChunkTool.h"
#include "ui/tools/scissors/SegmentScissorsTool.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/Chunks.h"
#include "ui/workspace/CuttingPlane.h"
#include "ui/workspace/LayerActions.h"
#include "ui/workspace/Refinement.h"
#include "ui/workspace/SegmentActions.h"

#include <QCheckBox>
#include <QDialog>
#include <QMenu>
#include <QPushButton>
#include <QTimer>
#include <QtTest>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <typeinfo>
#include <utility>
#include <vector>

namespace editableEverywhereUiTest {

namespace {

using ui::Workspace;

// Labels of the segments.
constexpr int shell = 1;
constexpr int ball = 2;
constexpr int drawn = 3;

/// The real window with the small head. Its segments are the brain, which is hollow and has an
/// island, a ball far from it, and discs in two slices. The ventricle, around the middle voxel
/// (20, 20, 20), is free. All values may be edited, which is a range as any other.
class Fixture : public test::WindowFixture {
public:
    Fixture()
        : test::WindowFixture(test::smallHead::volume())
        , axial(window.views().axial())
        , volume(window.views().volume())
    {
        workspace.setCrosshairLps(middle());
        volume.lookFrom({0.0, -1.0, 0.0});
        for (const char* name : {"Shell", "Ball", "Drawn"})
            apply(test::newSegment(QLatin1String(name)));
        apply(test::thresholdOf(shell, 20.0, 100.0));
        apply(test::paintAt(shell, {island()}, 2.0));
        apply(test::paintAt(ball, {place({20.0, 20.0, 5.0})}, 4.0));
        for (const double slice : {3.0, 9.0})
            apply(test::paintDiscAt(drawn, place({6.0, 6.0, slice}), {0.0, 0.0, 1.0}, 4.0));
        workspace.setActiveSegment(ball);
        workspace.setEditableSettings(
            {.on = true, .byValue = true, .lower = -1500.0, .upper = 3000.0});
        // As the engine's thread wakes the window in the program.
        QObject::connect(&m_poll, &QTimer::timeout, &m_poll, [this] { session().poll(); });
        m_poll.start(1);
    }
    // The tools go before the window, which shows the options of the one in hand.
    ~Fixture() { workspace.setActiveTool(nullptr); }
    Fixture(const Fixture&) = delete;
    Fixture& operator=(const Fixture&) = delete;

    [[nodiscard]] glm::dvec3 middle() const { return place({20.0, 20.0, 20.0}); }
    [[nodiscard]] glm::dvec3 island() const { return place({20.0, 20.0, 37.0}); }
    /// Draws over the axial slice through the middle, by the voxels' indices.
    void draw(const std::vector<glm::dvec2>& way)
    {
        std::vector<QPointF> pixels;
        for (const glm::dvec2& index : way)
            pixels.push_back(pixel(axial, {index.x, index.y, 20.0}));
        test::drawStroke(test::DrawnBy::Mouse, axial, pixels);
        settle();
    }
    /// A rectangle over the middle of the 3D view.
    void drawOver3d()
    {
        const QPointF at = QPointF(volume.width(), volume.height()) / 2.0;
        const QPointF half = QPointF(7.0, 5.0) / volume.context().mmPerPixel();
        test::drawStroke(test::DrawnBy::Mouse, volume, {at - half, at, at + half});
        settle();
    }
    void settle()
    {
        QVERIFY(session().settle());
        QCoreApplication::processEvents();
    }
    /// Takes a new tool in hand. It lives until the fixture goes.
    template <class T> T& take()
    {
        auto tool = std::make_unique<T>(workspace);
        T& taken = *tool;
        m_tools.push_back(std::move(tool));
        workspace.setActiveTool(&taken);
        return taken;
    }
    [[nodiscard]] static bool comes(const std::function<bool()>& there)
    {
        return QTest::qWaitFor(there, 60000);
    }

    ui::SliceView& axial;
    ui::VolumeView& volume;

private:
    QTimer m_poll;
    std::vector<std::unique_ptr<ui::Tool>> m_tools;
};

void paint(Fixture& on)
{
    on.take<ui::PaintTool>();
    on.draw({{20.0, 20.0}});
}

void nudge(Fixture& on)
{
    on.workspace.setActiveSegment(shell);
    auto& tool = on.take<ui::NudgeTool>();
    tool.setSettings({.radiusMm = 10.0, .fits = true});
    on.draw({{29.0, 20.0}, {32.0, 20.0}, {35.0, 20.0}});
    QVERIFY(Fixture::comes([&tool] { return !tool.isPushing(); }));
}

void fillAnOutline(Fixture& on)
{
    on.take<ui::FillOutlineTool>().setShape(ui::FillOutlineTool::Shape::Rectangle);
    on.draw({{17.6, 17.6}, {20.0, 20.0}, {22.4, 22.4}});
}

void flood(Fixture& on)
{
    on.take<ui::FloodFillTool>().setSettings({.in3D = false, .corners = false, .tolerance = 10.0});
    on.draw({{20.0, 20.0}});
}

void evolve(Fixture& on)
{
    ui::GrowSettings growth = on.workspace.growSettings();
    growth.lower = -50.0;
    growth.upper = 20.0;
    on.workspace.setGrowSettings(growth);
    auto& tool = on.take<ui::ContourTool>();
    tool.setSettings({.bubbleMm = 2.0, .valuesOfBubble = false, .generations = 30});
    tool.run().setPace(1);
    test::drawStroke(
        test::DrawnBy::Mouse, on.axial, {on.pixel(on.axial, glm::dvec3(20.0, 20.0, 20.0))});
    QVERIFY(Fixture::comes([&tool] {
        const ui::ContourRun& run = tool.run();
        return run.track() && !run.isWorking() && !run.isPlaying()
            && run.track()->shown() == run.track()->known();
    }));
    QTest::keyClick(&on.axial, Qt::Key_Return);
}

void cutWithScissors(Fixture& on, ui::SegmentScissorsTool::Does does)
{
    on.workspace.setActiveSegment(shell);
    on.take<ui::SegmentScissorsTool>().setSettings(
        {.does = does, .shape = ui::SegmentScissorsTool::Shape::Rectangle});
    on.drawOver3d();
}

void clickAChunk(Fixture& on)
{
    const ui::ChunksPanel panel(on.workspace);
    on.workspace.setActiveSegment(shell);
    on.take<ui::ChunkTool>();
    ui::Chunks& chunks = on.workspace.chunks();
    chunks.divide(8.0);
    on.settle();
    QVERIFY(Fixture::comes([&chunks] { return chunks.map() != nullptr; }));
    ui::Chunks::Look look = chunks.look();
    look.count = 5;
    look.bodies = ui::Chunks::Bodies::All;
    chunks.setLook(look);
    on.settle();
    QVERIFY(Fixture::comes([&chunks] { return !chunks.isCounting(); }));
    on.draw({{34.0, 20.0}}); // of the bone
}

void writeASurfaceBack(Fixture& on)
{
    on.apply(core::LaySurface{.segment = ball, .vertices = 400});
    const glm::dvec3 side = on.place({24.0, 20.0, 5.0});
    core::PointDrag drag{.path = {.radiusMm = 3.0, .pointsLps = {side}}};
    for (double mm = 1.0; mm <= 4.0; mm += 1.0)
        drag.path.pointsLps.push_back(side + glm::dvec3(mm, 0.0, 0.0));
    on.apply(drag);
    on.settle();
    on.workspace.refinement().writeBack();
}

void splitByThePlane(Fixture& on)
{
    on.workspace.plane().setPose(
        ui::CuttingPlane::poseFacing(on.place({20.2, 20.2, 20.2}), {1.0, 0.0, 0.0}));
    ui::splitByPlane(on.workspace, shell);
}

void makeALayerASegment(Fixture& on)
{
    on.apply(test::carveAt({{0.0, -14.5, 0.0}}, 2.0));
    ui::layerToSegment(on.workspace, 1, std::nullopt);
}

/// Grows from the middle through the ventricle.
void grow(Fixture& on)
{
    on.apply(test::seedAt(ball, {on.middle()}));
    ui::GrowSettings growth = on.workspace.growSettings();
    growth.lower = -50.0;
    growth.upper = 20.0;
    on.workspace.setGrowSettings(growth);
    ui::GrowthPanel panel(on.workspace);
    panel.runToClosure();
    QVERIFY(Fixture::comes([&panel] { return !panel.running(); }));
    on.settle();
}

void moveTheInterval(Fixture& on)
{
    grow(on);
    ui::LiveInterval interval(on.workspace);
    interval.move(-50.0, 5.0);
    interval.settle();
}

void shareOut(Fixture& on)
{
    ui::SpreadBar bar(on.workspace);
    bar.preview();
    auto* apply = bar.findChild<QPushButton*>(QStringLiteral("spreadApply"));
    QVERIFY(Fixture::comes([apply] { return apply->isEnabled(); }));
    bar.apply();
    on.settle();
}

/// One way in which tools or menus change labels.
struct Way {
    const char* name;
    std::size_t kind; ///< of the edit, in core::AllEdits
    std::function<void(Fixture&)> make;
};

std::vector<Way> ways()
{
    using core::editPlace;
    using Does = ui::SegmentScissorsTool::Does;
    const auto scissors = [](Does does) {
        return [does](Fixture& on) { cutWithScissors(on, does); };
    };
    // What an action of segments does, as panels, menus and dialogs call it.
    const auto act = [](auto action) {
        return [action](Fixture& on) { action(on.workspace, on); };
    };
    return {{"paint", editPlace<core::PaintStroke>, paint},
        {"nudge", editPlace<core::PaintStroke>, nudge},
        {"outline", editPlace<core::FillOutline>, fillAnOutline},
        {"flood fill", editPlace<core::FloodFill>, flood},
        {"contour", editPlace<core::EvolveContour>, evolve},
        {"segment scissors, erase", editPlace<core::SegmentScissors>, scissors(Does::EraseInside)},
        {"segment scissors, fill", editPlace<core::SegmentScissors>, scissors(Does::FillInside)},
        {"split inside a curve", editPlace<core::SplitByCurve>, scissors(Does::SplitInside)},
        {"growth", editPlace<core::GrowSteps>, grow},
        {"interval", editPlace<core::ChangeInterval>, moveTheInterval},
        {"sharing out", editPlace<core::GrowFromSeeds>, shareOut},
        {"chunks", editPlace<core::ChunkToggle>, clickAChunk},
        {"write back", editPlace<core::WriteBack>, writeASurfaceBack},
        {"split by the plane", editPlace<core::SplitSegment>, splitByThePlane},
        {"layer to segment", editPlace<core::LayerToSegment>, makeALayerASegment},
        {"what is seen", editPlace<core::SegmentSeen>,
            act([](Workspace& all, Fixture&) { ui::segmentWhatIsSeen(all, std::nullopt); })},
        {"fill holes", editPlace<core::CleanSegment>,
            act([](Workspace& all, Fixture&) { ui::fillHoles(all, shell); })},
        {"keep the largest island", editPlace<core::CleanSegment>,
            act([](Workspace& all, Fixture&) { ui::keepLargestIsland(all, shell); })},
        {"remove small islands", editPlace<core::CleanSegment>,
            act([](Workspace& all, Fixture&) { ui::removeSmallIslands(all, shell); })},
        {"remove the clicked island", editPlace<core::CleanSegment>,
            act([](Workspace& all, Fixture& on) { ui::removeIsland(all, shell, on.island()); })},
        {"keep the clicked island", editPlace<core::CleanSegment>,
            act([](Workspace& all, Fixture& on) { ui::keepOnlyIsland(all, shell, on.island()); })},
        {"give the clicked island", editPlace<core::CleanSegment>,
            act([](Workspace& all, Fixture& on) {
                ui::giveIsland(all, shell, ball, on.island());
            })},
        {"split islands", editPlace<core::SplitIslands>,
            act([](Workspace& all, Fixture&) { ui::splitIslands(all, {.segment = shell}); })},
        {"threshold", editPlace<core::ThresholdSegment>, act([](Workspace& all, Fixture&) {
             ui::takeThreshold(all, {.segment = ball, .lower = 800.0}, false);
         })},
        {"reshape", editPlace<core::ReshapeSegment>, act([](Workspace& all, Fixture&) {
             ui::reshapeSegment(
                 all, {.segment = ball, .operation = core::ShapeOperation::Grow, .mm = 2.0});
         })},
        {"between slices", editPlace<core::FillBetweenSlices>,
            act([](Workspace& all, Fixture&) { ui::fillBetweenSlices(all, {.segment = drawn}); })},
        {"mirror", editPlace<core::MirrorSegment>,
            act([](Workspace& all, Fixture&) { ui::mirrorSegment(all, {.segment = drawn}); })},
        {"invert", editPlace<core::InvertSegment>,
            act([](Workspace& all, Fixture&) { ui::invertSegment(all, ball); })},
        {"copy", editPlace<core::CopySegment>,
            act([](Workspace& all, Fixture&) { ui::duplicateSegment(all, ball); })},
        {"merge", editPlace<core::CombineSegments>, act([](Workspace& all, Fixture&) {
             ui::combineSegments(all, {.segment = shell, .with = ball});
         })},
        {"swap", editPlace<core::CombineSegments>, act([](Workspace& all, Fixture&) {
             ui::combineSegments(
                 all, {.segment = ball, .with = shell, .how = core::CombineSegments::How::Swap});
         })}};
}

/// The kinds of edits that have an editable range, with their names for the compiler.
template <class... Es> std::map<std::size_t, const char*> kindsWithRange(core::EditKinds<Es...>)
{
    std::map<std::size_t, const char*> kinds;
    const auto take = [&kinds]<class E>(const E*) {
        // What goes on with a growth becomes that growth (core::ResumeGrowth).
        if constexpr (
            requires(E edit) { edit.editable; } || requires(E edit) { edit.criteria.editable; })
            kinds.emplace(core::editPlace<E>, typeid(E).name());
    };
    (take(static_cast<const Es*>(nullptr)), ...);
    return kinds;
}

} // namespace

/// Which voxels may change at all is one choice, and whatever changes labels keeps to it.
class EditableEverywhereUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void whatIsDoneKeepsToIt_data()
    {
        QTest::addColumn<int>("number");
        int number = 0;
        for (const Way& way : ways())
            QTest::newRow(way.name) << number++;
    }
    void whatIsDoneKeepsToIt()
    {
        QFETCH(const int, number);
        const Way way = ways().at(std::size_t(number));
        Fixture fixture;
        const std::optional<core::EditableRange> range = fixture.workspace.editableRange();
        QVERIFY(range && range->lower && range->upper);
        const std::size_t rows = fixture.rows();
        way.make(fixture);
        if (QTest::currentTestFailed())
            return;
        fixture.settle();
        QVERIFY(fixture.rows() > rows);
        const core::HistoryRow& row = fixture.session().history().rows().back();
        QVERIFY2(row.edit.kind() == way.kind, qPrintable(row.name));
        const auto* const kept = core::editableRangeOf(row.edit);
        QVERIFY(kept);
        QVERIFY2(*kept == range, qPrintable(row.name));
    }

    /// Each dialog of segments says it and lets it be chosen, and still fits a small screen.
    void dialogsOfferIt_data()
    {
        QTest::addColumn<QString>("action");
        for (const char* action :
            {"segments.threshold", "segments.margin", "segments.hollow", "segments.smooth",
                "segments.fillBetween", "segments.mirrorBy", "segments.splitIslands"})
            QTest::newRow(action) << QString::fromLatin1(action);
    }
    void dialogsOfferIt()
    {
        QFETCH(const QString, action);
        Fixture fixture;
        fixture.window.actionTable()[action].trigger();
        QDialog* opened = nullptr;
        for (QDialog* each : fixture.window.findChildren<QDialog*>()) {
            if (each->isVisible())
                opened = each;
        }
        QVERIFY(opened);
        QDialog& dialog = *opened;
        const auto* button = dialog.findChild<ui::EditableButton*>();
        QVERIFY(button && button->isVisible());
        QTRY_VERIFY(button->text().startsWith(QStringLiteral("editable: only")));
        QVERIFY(dialog.height() < 720 - 40 && dialog.width() < 1280);
        // The tab key goes down the dialog: no button of the last row comes before it.
        const auto below = [&dialog, button](const QWidget& other) {
            return other.mapTo(&dialog, QPoint()).y() > button->mapTo(&dialog, QPoint()).y();
        };
        QList<const QWidget*> before;
        for (const QWidget* each = &dialog; each != button; each = each->nextInFocusChain()) {
            if (each->isVisible() && dialog.isAncestorOf(each)
                && (each->focusPolicy() & Qt::TabFocus) != 0)
                before += each;
        }
        for (const QWidget* each : before)
            QVERIFY2(!below(*each), qPrintable(each->objectName()));
        button->menu()->findChild<QCheckBox*>(QStringLiteral("editableOn"))->click();
        QVERIFY(!fixture.workspace.editableRange());
        QCOMPARE(button->text(), QStringLiteral("changes all voxels"));
    }

    /// A new kind of edit that has such a range is to be tried above.
    void everyKindIsTried()
    {
        std::map<std::size_t, const char*> kinds = kindsWithRange(core::AllEdits());
        QVERIFY(kinds.size() >= 20);
        for (const Way& way : ways())
            kinds.erase(way.kind);
        QString untried;
        for (const auto& [kind, name] : kinds)
            untried += QStringLiteral("%1 ").arg(QLatin1String(name));
        QVERIFY2(untried.isEmpty(), qPrintable(untried));
    }
};

BURIN_WINDOW_TEST(EditableEverywhereUiTest)

} // namespace editableEverywhereUiTest

#include "EditableEverywhereUiTest.moc"
