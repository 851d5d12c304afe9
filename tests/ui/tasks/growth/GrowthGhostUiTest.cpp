// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/growth/GrowthGhost.h"

#include "core/engine/EngineCommands.h"
#include "core/engine/EngineResult.h"
#include "core/session/EditSession.h"
#include "core/session/SessionDisplay.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/reference/PassingEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/panels/growth/GrowthPanel.h"
#include "ui/tools/growth/SeedTool.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/SegmentActions.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QtTest>

#include <algorithm>
#include <memory>
#include <set>
#include <utility>
#include <variant>
#include <vector>

namespace growthGhostUiTest {

using test::WorkspaceFixture;
namespace smallHead = test::smallHead;

namespace {

constexpr int patience = 60000; ///< milliseconds, on a busy machine

using Voxels = std::vector<bool>;

/// What slices draw of a ghost of the small head.
Voxels drawn(const gpu::SceneChunks& areas)
{
    const std::vector<std::uint16_t> codes = smallHead::volume().codes;
    Voxels voxels(codes.size());
    const glm::ivec3 cells = areas.cells();
    constexpr int side = smallHead::side;
    for (std::size_t i = 0; i < codes.size(); ++i) {
        const glm::ivec3 voxel(int(i) % side, int(i) / side % side, int(i) / (side * side));
        if (glm::any(glm::lessThan(voxel, areas.box.minimum))
            || glm::any(glm::greaterThanEqual(voxel, areas.box.maximum)))
            continue;
        const glm::ivec3 cell = (voxel - areas.box.minimum) / areas.cell;
        const std::uint16_t leaf =
            areas.leaves->at(std::size_t((cell.z * cells.y + cell.y) * cells.x + cell.x));
        voxels[i] = leaf != 0 && areas.argb.at(leaf - 1U) >> 24 != 0 && areas.codes
            && codes[i] >= areas.codes->lowest && codes[i] <= areas.codes->highest;
    }
    return voxels;
}

std::int64_t countOf(const Voxels& voxels)
{
    return std::count(voxels.begin(), voxels.end(), true);
}

double dice(const Voxels& a, const Voxels& b)
{
    std::int64_t both = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        both += a[i] && b[i] ? 1 : 0;
    return 2.0 * double(both) / double(countOf(a) + countOf(b));
}

/// The small head with a segment, the panel, and the seed tool in hand.
class Sketching : public WorkspaceFixture {
public:
    Sketching()
        : panel(workspace)
        , tool(workspace)
        , ghost(*panel.findChild<ui::GrowthGhost*>())
    {
        panel.show();
        shown().setChecked(true);
        if (!ui::addSegment(workspace))
            qFatal("no segment");
        ui::GrowSettings settings = workspace.growSettings();
        settings.guard.on = false;
        workspace.setGrowSettings(settings);
        workspace.setActiveTool(&tool);
    }
    ~Sketching() { workspace.setActiveTool(nullptr); }

    template <class Condition> [[nodiscard]] bool waitFor(Condition condition)
    {
        return QTest::qWaitFor(
            [&] {
                settle();
                return condition();
            },
            patience);
    }
    /// In the ventricle; waits for the ghost.
    void sketch()
    {
        apply(middleSeed(1));
        if (!waitFor([this] { return areas() && ghost.upToDate(); }))
            qFatal("no ghost came");
    }
    void setInterval(double lower, double upper)
    {
        ui::GrowSettings settings = workspace.growSettings();
        settings.lower = lower;
        settings.upper = upper;
        workspace.setGrowSettings(settings);
    }
    /// Grows to closure; returns the voxels of the first segment.
    [[nodiscard]] Voxels grown()
    {
        QTest::mouseClick(
            panel.findChild<QPushButton*>(QStringLiteral("growToClosure")), Qt::LeftButton);
        const bool over = QTest::qWaitFor([this] {
            session().poll();
            return !panel.running();
        });
        if (!over)
            qFatal("it grows on");
        settle();
        const auto labels = session().questions().labels(0);
        if (!labels)
            qFatal("no labels");
        Voxels voxels;
        for (const std::uint8_t label : *labels)
            voxels.push_back(label == 1);
        return voxels;
    }
    [[nodiscard]] std::shared_ptr<const gpu::SceneChunks> areas() const
    {
        return workspace.seeds().ghost().areas;
    }
    [[nodiscard]] QString text() const
    {
        return panel.findChild<QLabel*>(QStringLiteral("growthGhost"))->text();
    }
    [[nodiscard]] QCheckBox& shown() const
    {
        return *panel.findChild<QCheckBox*>(QStringLiteral("growthPreview"));
    }

    ui::GrowthPanel panel;
    ui::SeedTool tool;
    ui::GrowthGhost& ghost;
};

/// The oracle, which refuses to read codes when it is told to.
class RefusingCodes final : public reference::PassingEngine {
public:
    core::Ticket submit(core::EngineCommand command) override
    {
        const bool isRefused = refuses && std::holds_alternative<core::ReadCodes>(command);
        const core::Ticket ticket = PassingEngine::submit(std::move(command));
        if (isRefused)
            m_refused.insert(ticket);
        return ticket;
    }
    [[nodiscard]] std::vector<core::EngineResult> collect() override
    {
        std::vector<core::EngineResult> results = PassingEngine::collect();
        for (core::EngineResult& result : results) {
            if (m_refused.erase(result.ticket) == 0)
                continue;
            result.error =
                core::Error{core::ErrorCode::Internal, {QStringLiteral("codes"), QString()}};
            ++refusals;
        }
        return results;
    }

    bool refuses = false;
    int refusals = 0; ///< so far

private:
    std::set<core::Ticket> m_refused;
};

} // namespace

class GrowthGhostUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// After a sketch, in the interval that is offered; gone with the growth.
    void aSketchShowsWhatAGrowthTakes()
    {
        Sketching fixture;
        fixture.settle();
        QVERIFY(!fixture.areas() && fixture.text().isEmpty());
        fixture.sketch();
        const ui::PendingSeeds::Ghost ghost = fixture.workspace.seeds().ghost();
        const Voxels seen = drawn(*ghost.areas);
        QVERIFY(ghost.bodies && ghost.bodies->leaves == ghost.areas->leaves);
        QCOMPARE(fixture.ghost.voxels().value_or(-1), countOf(seen));
        QVERIFY2(fixture.text().startsWith(QStringLiteral("about ")), qPrintable(fixture.text()));
        QCOMPARE(fixture.session().document().segment(1)->voxels, std::int64_t(0));
        const Voxels grown = fixture.grown();
        QCOMPARE(countOf(grown), smallHead::voxelsOf(smallHead::ventricleHu));
        // Every voxel of so small a volume is a cell.
        QVERIFY(dice(seen, grown) >= 0.9);
        QVERIFY(seen == grown);
        QVERIFY(fixture.waitFor([&] { return fixture.workspace.seeds().seeds().empty(); }));
        QTest::qWait(60);
        QVERIFY(!fixture.areas() && fixture.text().isEmpty());
    }

    /// A line with the mouse in a slice; the first sketch makes its segment.
    void aSketchInTheWindowIsSeenInItsViews()
    {
        test::WindowFixture fixture(smallHead::volume());
        ui::GrowthPanel panel(fixture.workspace);
        panel.findChild<QCheckBox*>(QStringLiteral("growthPreview"))->setChecked(true);
        ui::SeedTool tool(fixture.workspace);
        fixture.workspace.setActiveTool(&tool);
        ui::SliceView& axial = fixture.window.views().axial();
        const QPointF middle = fixture.pixel(axial, glm::dvec3(20.0));
        fixture.mouse(axial, QEvent::MouseButtonPress, middle - QPointF(6.0, 0.0));
        fixture.mouse(axial, QEvent::MouseMove, middle);
        fixture.mouse(axial, QEvent::MouseMove, middle + QPointF(6.0, 2.0));
        fixture.mouse(axial, QEvent::MouseButtonRelease, middle + QPointF(6.0, 2.0));
        const auto inSlice = [&] {
            return std::get<gpu::SliceScene>(axial.context().scene).chunks;
        };
        const auto inVolume = [&] {
            const ui::VolumeView& view = fixture.window.views().volume();
            return std::get<gpu::VolumeScene>(view.context().scene).chunks;
        };
        QVERIFY(QTest::qWaitFor(
            [&] { return fixture.session().settle().has_value() && inSlice() != nullptr; }));
        const ui::PendingSeeds::Ghost ghost = fixture.workspace.seeds().ghost();
        QCOMPARE(inSlice(), ghost.areas);
        QCOMPARE(inVolume(), ghost.bodies);
        QCOMPARE(countOf(drawn(*ghost.areas)), smallHead::voxelsOf(smallHead::ventricleHu));
        // Who looks under the segments looks under what one would take, too.
        ui::Workspace::ViewOptions options = fixture.workspace.viewOptions();
        options.showSegments = false;
        fixture.workspace.setViewOptions(options);
        QVERIFY(!inSlice() && !inVolume());
        options.showSegments = true;
        fixture.workspace.setViewOptions(options);
        QVERIFY(inSlice() && inVolume());
        fixture.workspace.setActiveTool(nullptr);
        QVERIFY(!inSlice() && !inVolume());
    }

    void followsTheInterval()
    {
        Sketching fixture;
        fixture.sketch();
        const std::int64_t ventricle = smallHead::voxelsOf(smallHead::ventricleHu);
        QCOMPARE(fixture.ghost.voxels().value_or(-1), ventricle);
        fixture.setInterval(0.0, 60.0);
        const std::int64_t both = ventricle + smallHead::voxelsOf(smallHead::brainHu);
        QVERIFY(fixture.waitFor([&] { return fixture.ghost.voxels() == both; }));
        QCOMPARE(countOf(drawn(*fixture.areas())), both);
        // No seed lies in this one.
        fixture.setInterval(20.0, 60.0);
        QVERIFY(fixture.waitFor([&] { return fixture.ghost.voxels() == 0; }));
        QVERIFY(!fixture.areas());
        QCOMPARE(fixture.text(), QStringLiteral("nothing"));
        // The slider takes the interval back to what was sketched.
        auto* slider = fixture.panel.findChild<QSlider*>(QStringLiteral("growTolerance"));
        slider->setSliderDown(true);
        slider->setSliderPosition(slider->minimum());
        QVERIFY(fixture.waitFor([&] { return fixture.ghost.voxels() == ventricle; }));
        slider->setSliderDown(false);
        // A limit is not reckoned with, and the text says so.
        ui::GrowSettings settings = fixture.workspace.growSettings();
        settings.majority.on = true;
        fixture.workspace.setGrowSettings(settings);
        QVERIFY2(fixture.text().endsWith(QStringLiteral(", without smoothing")),
            qPrintable(fixture.text()));
        settings.difference.on = true;
        fixture.workspace.setGrowSettings(settings);
        QVERIFY2(fixture.text().endsWith(QStringLiteral(", without some criteria")),
            qPrintable(fixture.text()));
    }

    /// Other segments and the editable range bound it as they bound a growth.
    void staysOutOfOtherSegments()
    {
        Sketching fixture;
        if (!ui::addSegment(fixture.workspace))
            qFatal("no segment");
        fixture.apply(test::paintAt(2, {{7.0, 0.0, 0.0}, {7.0, 8.0, 0.0}}, 4.0));
        fixture.apply(test::lockSegment(2));
        fixture.workspace.setActiveSegment(1);
        fixture.setInterval(0.0, 60.0);
        fixture.sketch();
        const std::int64_t all =
            smallHead::voxelsOf(smallHead::ventricleHu) + smallHead::voxelsOf(smallHead::brainHu);
        QVERIFY(fixture.waitFor([&] {
            return fixture.ghost.upToDate() && fixture.ghost.voxels().value_or(0) > all / 2;
        }));
        const Voxels seen = drawn(*fixture.areas());
        QVERIFY(countOf(seen) < all);
        ui::EditableSettings editable;
        editable.on = editable.byValue = true;
        editable.upper = 20.0;
        fixture.workspace.setEditableSettings(editable);
        QVERIFY(fixture.waitFor([&] {
            return fixture.ghost.voxels().value_or(0)
                <= smallHead::voxelsOf(smallHead::ventricleHu);
        }));
        QVERIFY(fixture.areas());
        fixture.workspace.setEditableSettings({});
        QVERIFY(fixture.waitFor([&] { return fixture.ghost.voxels() == countOf(seen); }));
        const Voxels grown = fixture.grown();
        QVERIFY(seen == grown);
    }

    void goesWhenThereIsNothingToForesee_data()
    {
        QTest::addColumn<int>("what");
        QTest::newRow("undo") << 0;
        QTest::newRow("another tool") << 1;
        QTest::newRow("another segment") << 2;
        QTest::newRow("the study is closed") << 3;
        QTest::newRow("the switch") << 4;
        QTest::newRow("a step of growth") << 5;
        QTest::newRow("a segment at a tolerance") << 6;
        QTest::newRow("a lock") << 7;
        QTest::newRow("hidden") << 8;
    }

    void goesWhenThereIsNothingToForesee()
    {
        QFETCH(int, what);
        Sketching fixture;
        fixture.sketch();
        bool comesBack = false;
        switch (what) {
        case 0:
            QVERIFY(fixture.session().undo());
            break;
        case 1:
            fixture.workspace.setActiveTool(nullptr);
            comesBack = true;
            break;
        case 2:
            QVERIFY(ui::addSegment(fixture.workspace));
            comesBack = true;
            break;
        case 3:
            fixture.workspace.setSession(nullptr);
            QVERIFY(!fixture.areas());
            return;
        case 4:
            fixture.shown().setChecked(false);
            QVERIFY(!fixture.areas());
            comesBack = true;
            break;
        case 6:
            fixture.workspace.setAtTolerance(gpu::ToleranceDisplay{.label = 1, .tolerance = 3});
            QVERIFY(!fixture.areas());
            fixture.workspace.setAtTolerance({});
            QVERIFY(fixture.waitFor([&] { return fixture.areas() != nullptr; }));
            return;
        case 7:
            fixture.apply(test::lockSegment(1));
            break;
        case 8:
            fixture.session().display().setSegmentVisible(1, false);
            break;
        default:
            QTest::mouseClick(
                fixture.panel.findChild<QPushButton*>(QStringLiteral("growStep")), Qt::LeftButton);
        }
        QVERIFY(fixture.waitFor([&] { return !fixture.areas() && fixture.text().isEmpty(); }));
        QTest::qWait(60);
        fixture.settle();
        QVERIFY(!fixture.areas());
        fixture.shown().setChecked(true);
        fixture.workspace.setActiveTool(&fixture.tool);
        fixture.workspace.setActiveSegment(1);
        QTest::qWait(60);
        QCOMPARE(fixture.waitFor([&] { return fixture.areas() != nullptr || !comesBack; })
                && fixture.areas() != nullptr,
            comesBack);
    }

    /// Also where it is being worked out as the study is closed.
    void theNextStudyHasNoneOfIt()
    {
        reference::ReferenceEngine engine;
        Sketching fixture;
        fixture.sketch();
        auto next = core::EditSession::create(engine, smallHead::volume(), {});
        QVERIFY(next);
        fixture.setInterval(0.0, 60.0);
        QVERIFY(!fixture.ghost.upToDate());
        fixture.workspace.setSession(std::move(*next));
        QVERIFY(!fixture.areas() && fixture.text().isEmpty());
        QVERIFY(ui::addSegment(fixture.workspace));
        QTest::qWait(100);
        fixture.settle();
        QVERIFY(!fixture.areas() && fixture.text().isEmpty());
        fixture.sketch();
        QVERIFY(!fixture.text().isEmpty());
    }

    void codesAreAskedForAgainWithTheToolTakenAnew()
    {
        RefusingCodes engine;
        Sketching fixture;
        auto session = core::EditSession::create(engine, smallHead::volume(), {});
        QVERIFY(session);
        engine.refuses = true;
        fixture.workspace.setSession(std::move(*session));
        QVERIFY(ui::addSegment(fixture.workspace));
        fixture.apply(WorkspaceFixture::middleSeed(1));
        QVERIFY(fixture.waitFor([&] { return engine.refusals > 0; }));
        engine.refuses = false;
        QTest::qWait(60);
        fixture.settle();
        QVERIFY(!fixture.areas());
        fixture.workspace.setActiveTool(nullptr);
        fixture.workspace.setActiveTool(&fixture.tool);
        QVERIFY(fixture.waitFor([&] { return fixture.areas() != nullptr; }));
    }

    /// A volume that is looked at in cells of 2³ voxels.
    void coversAboutTheSameInCells()
    {
        WorkspaceFixture fixture;
        QVERIFY(ui::addSegment(fixture.workspace));
        fixture.apply(WorkspaceFixture::middleSeed(1));
        ui::GrowSettings settings = fixture.workspace.growSettings();
        settings.lower = 0.0;
        settings.upper = 60.0;
        fixture.workspace.setGrowSettings(settings);
        ui::GrowthGhost ghost(fixture.workspace, nullptr, 9000);
        ghost.prepare();
        QVERIFY(QTest::qWaitFor([&] {
            fixture.settle();
            ghost.follow(true);
            return ghost.voxels().has_value();
        }));
        const auto areas = fixture.workspace.seeds().ghost().areas;
        QVERIFY(areas);
        QCOMPARE(areas->cell, glm::ivec3(2));
        fixture.apply(test::growBetween(0.0, 60.0));
        const auto labels = fixture.session().questions().labels(0);
        QVERIFY(labels);
        Voxels grown;
        for (const std::uint8_t label : *labels)
            grown.push_back(label == 1);
        const double alike = dice(drawn(*areas), grown);
        QVERIFY2(alike >= 0.98, qPrintable(QString::number(alike)));
        const double share = double(*ghost.voxels()) / double(countOf(grown));
        QVERIFY2(share > 0.85 && share < 1.15, qPrintable(QString::number(share)));
    }
};

BURIN_WINDOW_TEST(GrowthGhostUiTest)

} // namespace growthGhostUiTest

#include "GrowthGhostUiTest.moc"
