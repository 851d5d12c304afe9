// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/growth/GrowthPanel.h"

#include "core/edits/kinds/growth/GrowSteps.h"
#include "tests/support/cases/BoxedMasks.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/base/Actions.h"
#include "ui/panels/growth/GenerationBar.h"
#include "ui/panels/growth/GrowthActions.h"
#include "ui/widgets/HistogramRange.h"
#include "ui/workspace/SegmentActions.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QtTest>

#include <numeric>

namespace growthPanelUiTest {

using test::WorkspaceFixture;
using ui::GrowthPanel;

namespace {

QAbstractButton& button(const GrowthPanel& panel, const char* name)
{
    auto* found = panel.findChild<QAbstractButton*>(QLatin1String(name));
    if (!found)
        qFatal("no button %s", name);
    return *found;
}

void click(QAbstractButton& target)
{
    QTest::mouseClick(&target, Qt::LeftButton);
}

ui::Workspace::GrowSettings ventricleInterval()
{
    ui::Workspace::GrowSettings settings;
    settings.lower = 0.0;
    settings.upper = 20.0;
    return settings;
}

/// A panel on screen with one seed in the ventricle of the small head.
class SeededPanel : public WorkspaceFixture {
public:
    SeededPanel()
        : panel(workspace)
    {
        panel.show();
        if (!QTest::qWaitForWindowExposed(&panel) || !ui::addSegment(workspace))
            qFatal("no panel");
        apply(middleSeed(1));
        workspace.setGrowSettings(ventricleInterval());
    }
    [[nodiscard]] const core::GrowSteps* lastGrowth()
    {
        const core::History& history = session().history();
        return history.position() == 0 ? nullptr
                                       : history.row(history.position()).edit.as<core::GrowSteps>();
    }
    GrowthPanel panel;
};

} // namespace

class GrowthPanelUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void asksForSeeds()
    {
        WorkspaceFixture fixture;
        GrowthPanel panel(fixture.workspace);
        QVERIFY(!button(panel, "growStep").isEnabled());
        QVERIFY(!button(panel, "growPlay").isEnabled());
        QVERIFY(!button(panel, "growToClosure").isEnabled());
        const auto* advice = panel.findChild<QLabel*>(QStringLiteral("growAdvice"));
        QVERIFY(advice->text().contains(QStringLiteral("seeds")));
        QVERIFY(ui::addSegment(fixture.workspace));
        QVERIFY(!button(panel, "growPlay").isEnabled());
        fixture.apply(WorkspaceFixture::middleSeed(1));
        QVERIFY(button(panel, "growPlay").isEnabled());
        QCOMPARE(panel.summary(), QStringLiteral("Segment 1"));
    }

    /// A session that a recipe has made has no settings of a window in it.
    void showsWhatARecipeHasGrownBy()
    {
        WorkspaceFixture fixture;
        QVERIFY(ui::addSegment(fixture.workspace));
        fixture.apply(WorkspaceFixture::middleSeed(1));
        fixture.apply(core::GrowSteps{.criteria = {.lower = -7.0,
                                          .upper = 33.0,
                                          .connectivity = 18,
                                          .majority = 9,
                                          .smoothing = true,
                                          .overwriteUnlocked = true}});
        GrowthPanel panel(fixture.workspace);
        const ui::GrowSettings& shown = fixture.workspace.growSettings();
        QCOMPARE(shown.lower, -7.0);
        QCOMPARE(shown.upper, 33.0);
        QCOMPARE(shown.connectivity, 18);
        QVERIFY(shown.majority.on && shown.smoothing && !shown.gradient.on);
        QCOMPARE(shown.majority.value, 9.0);
        QVERIFY(shown.overwriteUnlocked);
        const auto* range = panel.findChild<ui::HistogramRange*>(QStringLiteral("growthInterval"));
        QCOMPARE(range->lower(), -7.0);
        QCOMPARE(range->upper(), 33.0);
    }

    void aStepIsOneGenerationAndOneRow()
    {
        SeededPanel fixture;
        for (int step = 1; step <= 3; ++step) {
            const auto before = fixture.session().history().position();
            click(button(fixture.panel, "growStep"));
            fixture.settle();
            QCOMPARE(fixture.session().history().position(), before + 1);
            QVERIFY(fixture.lastGrowth());
            QCOMPARE(fixture.lastGrowth()->steps.value_or(-1), 1);
        }
        // The burst's opening admits the seed, then each step adds a shell of the 6-neighbourhood:
        // the octahedra of radius 0 or 1, 2, 3 minus what the coarser slices leave out of reach.
        QVERIFY(fixture.session().document().segments[0].voxels > 7);
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QVERIFY(fixture.session().document().segments[0].voxels > 0);
    }

    void shrinkingTakesBackWhatGrew()
    {
        SeededPanel fixture;
        QVERIFY(!button(fixture.panel, "growShrink").isEnabled());
        std::vector<std::int64_t> voxels;
        for (int step = 0; step < 4; ++step) {
            click(button(fixture.panel, "growStep"));
            fixture.settle();
            voxels.push_back(fixture.session().document().segments[0].voxels);
        }
        for (int step = 2; step >= 0; --step) {
            click(button(fixture.panel, "growShrink"));
            fixture.settle();
            QCOMPARE(fixture.session().document().segments[0].voxels, voxels[std::size_t(step)]);
        }
        click(button(fixture.panel, "growToSeeds"));
        fixture.settle();
        QCOMPARE(fixture.session().document().segments[0].voxels, std::int64_t(1));
        QVERIFY(!button(fixture.panel, "growToSeeds").isEnabled());
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QCOMPARE(fixture.session().document().segments[0].voxels, voxels[0]);
    }

    /// Of segments that overlap, each has a growth of its own: that of the active one is meant.
    void theActiveSegmentsPlaneGrows()
    {
        SeededPanel fixture;
        const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
        const glm::ivec3 middle = geometry.size / 2;
        core::ImportMask mask =
            test::importOfBoxes({{middle - 1, middle + 1}, {middle, middle + 1}}, geometry.size);
        mask.planes = std::vector<int>{1, 2};
        fixture.apply(mask);
        const auto voxels = [&](int label) {
            return fixture.session().document().segment(label)->voxels;
        };
        click(button(fixture.panel, "growStep"));
        fixture.settle();
        const std::int64_t first = voxels(1);
        QVERIFY(first > 1 && button(fixture.panel, "growShrink").isEnabled());

        fixture.workspace.setActiveSegment(3);
        QCOMPARE(int(fixture.workspace.growthPlane()), 2);
        QVERIFY(!button(fixture.panel, "growStep").isEnabled());
        QVERIFY(!button(fixture.panel, "growShrink").isEnabled());
        QVERIFY(!button(fixture.panel, "growResume").isEnabled());
        const auto* advice = fixture.panel.findChild<QLabel*>(QStringLiteral("growAdvice"));
        QVERIFY(advice->text().contains(QStringLiteral("No seeds yet")));
        fixture.apply(test::seedAt(3, {geometry.toWorld(glm::dvec3(middle))}));
        fixture.workspace.setGrowSettings(ventricleInterval());
        for (int step = 0; step < 3; ++step) {
            click(button(fixture.panel, "growStep"));
            fixture.settle();
            QVERIFY(fixture.lastGrowth());
            QCOMPARE(fixture.lastGrowth()->criteria.plane, std::optional<int>(2));
        }
        QCOMPARE(voxels(1), first);
        QCOMPARE(voxels(2), std::int64_t(8));
        const std::int64_t third = voxels(3);
        QVERIFY(third > first);
        auto* bar = fixture.panel.findChild<ui::GenerationBar*>();
        const auto counted = [&](std::size_t generations) {
            return QTest::qWaitFor([&] {
                fixture.settle();
                return bar->sizes().size() == generations;
            });
        };
        QVERIFY(counted(4));
        const auto* told = fixture.panel.findChild<QLabel*>(QStringLiteral("growProgress"));
        QVERIFY(told->text().startsWith(QStringLiteral("Generation 4 · added")));
        click(button(fixture.panel, "growShrink"));
        fixture.settle();
        QVERIFY(voxels(3) < third);
        QCOMPARE(voxels(1), first);

        fixture.workspace.setActiveSegment(1);
        QVERIFY(counted(2));
        // What was done last was not done to this growth.
        QCOMPARE(told->text(), QStringLiteral("Generation 2"));
        click(button(fixture.panel, "growResume"));
        fixture.settle();
        QVERIFY(voxels(1) > first);
        QVERIFY(!fixture.lastGrowth() || !fixture.lastGrowth()->criteria.plane);
    }

    void theGenerationBarScrubs()
    {
        SeededPanel fixture;
        std::vector<std::int64_t> voxels;
        for (int step = 0; step < 5; ++step) {
            click(button(fixture.panel, "growStep"));
            fixture.settle();
            voxels.push_back(fixture.session().document().segments[0].voxels);
        }
        auto* bar = fixture.panel.findChild<ui::GenerationBar*>();
        QVERIFY(bar);
        const auto counted = [&](std::size_t generations) {
            return QTest::qWaitFor([&] {
                fixture.settle();
                return bar->sizes().size() == generations;
            });
        };
        // The first step admitted the seed and added a generation.
        QVERIFY(counted(6));
        QCOMPARE(std::int64_t(std::accumulate(bar->sizes().begin(), bar->sizes().end(), 0u)),
            voxels.back());
        QCOMPARE(bar->shown(), 6);
        const auto rows = fixture.session().history().rows().size();
        const QByteArray grown = fixture.session().stateHash();
        const auto at = [bar](int generation) {
            return QPoint(6 + (bar->width() - 12) * (generation - 1) / 5, bar->height() / 2);
        };
        QTest::mousePress(bar, Qt::LeftButton, {}, at(4));
        QCOMPARE(bar->shown(), 4);
        const auto* told = fixture.panel.findChild<QLabel*>(QStringLiteral("growProgress"));
        QVERIFY2(told->text().startsWith(QStringLiteral("Generation 4 of 6 · ")),
            qPrintable(told->text()));
        QTest::mouseMove(bar, at(1));
        QTest::mouseMove(bar, at(3));
        QVERIFY(told->text().startsWith(QStringLiteral("Generation 3 of 6 · ")));
        QTest::mouseRelease(bar, Qt::LeftButton, {}, at(3));
        fixture.settle();
        QCOMPARE(fixture.session().document().segments[0].voxels, voxels[1]);
        QCOMPARE(fixture.session().history().rows().size(), rows + 1);
        QVERIFY(counted(3));
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QCOMPARE(fixture.session().stateHash(), grown);

        // Escape takes the drag back.
        QVERIFY(counted(6));
        QTest::mousePress(bar, Qt::LeftButton, {}, at(2));
        QTest::keyClick(bar, Qt::Key_Escape);
        fixture.settle();
        QCOMPARE(bar->shown(), 6);
        QVERIFY(!told->text().contains(QStringLiteral(" of 6")));
        QCOMPARE(fixture.session().stateHash(), grown);
        QTest::mouseRelease(bar, Qt::LeftButton, {}, at(2));
    }

    void connectivityIsPartOfTheEdit()
    {
        SeededPanel fixture;
        auto* choice = fixture.panel.findChild<QComboBox*>(QStringLiteral("growConnectivity"));
        QVERIFY(choice);
        QCOMPARE(fixture.panel.growEdit().criteria.connectivity, 6);
        QTest::keyClick(choice, Qt::Key_End);
        QCOMPARE(fixture.panel.growEdit().criteria.connectivity, 26);
        click(button(fixture.panel, "growStep"));
        fixture.settle();
        QCOMPARE(fixture.lastGrowth()->criteria.connectivity, 26);
    }

    void playRunsToClosureAsOneStepOfUndo_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::newRow("grow") << QByteArray("growPlay");
        QTest::newRow("all") << QByteArray("growToClosure");
    }
    void playRunsToClosureAsOneStepOfUndo()
    {
        QFETCH(QByteArray, name);
        SeededPanel fixture;
        const auto before = fixture.session().history().position();
        click(button(fixture.panel, name.constData()));
        QVERIFY(fixture.panel.running());
        QCOMPARE(button(fixture.panel, "growPlay").text(), QStringLiteral("Pause"));
        QTRY_VERIFY(!fixture.panel.running());
        fixture.settle();
        QCOMPARE(fixture.session().history().position(), before + 1);
        QVERIFY(fixture.lastGrowth());
        QCOMPARE(fixture.lastGrowth()->criteria.lower, 0.0);
        QCOMPARE(fixture.lastGrowth()->criteria.upper, 20.0);
        QCOMPARE(fixture.session().document().segments[0].voxels,
            test::smallHead::voxelsOf(test::smallHead::ventricleHu));
        QVERIFY(fixture.session().undo());
        fixture.settle();
        QCOMPARE(fixture.session().document().segments[0].voxels, 0);
    }

    void theMenuPressesTheButtons()
    {
        SeededPanel fixture;
        QWidget window;
        ui::Actions actions(window);
        const QStringList ids = ui::addGrowthActions(actions, fixture.panel, fixture.workspace);
        QVERIFY(ids.contains(QStringLiteral("grow.play")));
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        const auto before = fixture.session().history().position();
        actions[QStringLiteral("grow.shrink")].trigger();
        QCOMPARE(said.count(), 1);
        QVERIFY(said[0][0].toString().startsWith(QStringLiteral("Nothing has grown")));
        actions[QStringLiteral("grow.step")].trigger();
        fixture.settle();
        QCOMPARE(fixture.session().history().position(), before + 1);
        QCOMPARE(fixture.lastGrowth()->steps.value_or(-1), 1);
        actions[QStringLiteral("grow.play")].trigger();
        QVERIFY(fixture.panel.running());
        QTRY_VERIFY(!fixture.panel.running());
        fixture.settle();
        actions[QStringLiteral("grow.toSeeds")].trigger();
        fixture.settle();
        QCOMPARE(fixture.session().document().segments[0].voxels, std::int64_t(1));
        // Without a seed it says what is missing.
        for (int step = 0; step < 4; ++step)
            QVERIFY(fixture.session().undo());
        fixture.settle();
        said.clear();
        actions[QStringLiteral("grow.toClosure")].trigger();
        QCOMPARE(said.count(), 1);
        QVERIFY(said[0][0].toString().startsWith(QStringLiteral("No seeds yet")));
    }

    void anotherEditClosesARunningBurst()
    {
        SeededPanel fixture;
        click(button(fixture.panel, "growPlay"));
        QVERIFY(ui::addSegment(fixture.workspace));
        fixture.settle();
        QTRY_VERIFY(!fixture.panel.running());
        QCOMPARE(button(fixture.panel, "growPlay").text(), QStringLiteral("Grow"));
        QVERIFY(!fixture.session().transactionOpen());
    }

    void theIntervalComesFromTheSeeds()
    {
        SeededPanel fixture;
        // Two more seeds, in brain: the mean lies between, the spread reaches both.
        fixture.apply(test::seedAt(1, {{8.0, 0.0, 0.0}, {-8.0, 0.0, 0.0}}));
        QVERIFY(QTest::qWaitFor([&fixture] {
            fixture.settle();
            return button(fixture.panel, "intervalFromSeeds").isEnabled();
        }));
        const auto& settings = fixture.workspace.growSettings();
        QCOMPARE(settings.upper, 20.0); // set by hand, and left
        click(button(fixture.panel, "intervalFromSeeds"));
        // Most of what was sketched, and what is around it, is brain.
        QVERIFY(settings.lower <= 40.0 && settings.upper >= 40.0);
        QVERIFY(settings.lower > -500.0 && settings.upper < 600.0);
        QCOMPARE(settings.lower * 10.0, std::round(settings.lower * 10.0)); // few digits
        const auto* range =
            fixture.panel.findChild<ui::HistogramRange*>(QStringLiteral("growthInterval"));
        QVERIFY(std::abs(range->lower() - settings.lower) < 0.1);
    }

    /// After a sketch the interval is that of what was sketched; each segment has its own.
    void eachSketchSetsTheIntervalOfItsSegment()
    {
        WorkspaceFixture fixture;
        GrowthPanel panel(fixture.workspace);
        panel.show();
        const auto holds = [&](double value) {
            const auto& settings = fixture.workspace.growSettings();
            return settings.lower <= value && value <= settings.upper;
        };
        const auto waitsFor = [&](auto condition) {
            return QTest::qWaitFor([&] {
                fixture.settle();
                return condition();
            });
        };
        QVERIFY(ui::addSegment(fixture.workspace));
        fixture.apply(WorkspaceFixture::middleSeed(1));
        QVERIFY(waitsFor([&] { return holds(8.0) && !holds(40.0); }));
        const ui::GrowSettings first = fixture.workspace.growSettings();
        QVERIFY(ui::addSegment(fixture.workspace));
        fixture.apply(test::seedAt(2, {{8.0, 0.0, 0.0}}));
        QVERIFY(waitsFor([&] { return holds(40.0) && !holds(8.0) && !holds(900.0); }));
        fixture.workspace.setActiveSegment(1);
        QCOMPARE(fixture.workspace.growSettings(), first);

        // Set by hand: it stays, and tells that nothing would grow.
        ui::GrowSettings byHand = first;
        byHand.lower = 500.0;
        byHand.upper = 1500.0;
        fixture.workspace.setGrowSettings(byHand);
        auto* outside = panel.findChild<QLabel*>(QStringLiteral("growOutside"));
        QVERIFY(waitsFor([&] { return outside->isVisible(); }));
        fixture.apply(test::seedAt(1, {{0.0, 0.0, 1.5}}));
        QVERIFY(waitsFor([&] { return button(panel, "intervalFromSeeds").isEnabled(); }));
        QCOMPARE(fixture.workspace.growSettings().lower, 500.0);
        Q_EMIT outside->linkActivated(QStringLiteral("use"));
        QVERIFY(holds(8.0) && !holds(40.0));
        QVERIFY(!outside->isVisible());
    }

    /// What is told of seeds is told of those that the interval would be set by.
    void seedsOfTheActiveSegmentAreTold()
    {
        SeededPanel fixture;
        const auto* advice = fixture.panel.findChild<QLabel*>(QStringLiteral("growAdvice"));
        const auto tells = [&](const char* text) {
            return QTest::qWaitFor([&] {
                fixture.settle();
                return advice->text() == QString::fromUtf8(text);
            });
        };
        QVERIFY2(tells("1 seed voxel · 8.0 ± 0.0 HU"), qPrintable(advice->text()));
        QVERIFY(ui::addSegment(fixture.workspace));
        QVERIFY2(tells("1 seed voxel, of another segment"), qPrintable(advice->text()));
        fixture.apply(test::seedAt(2, {{8.0, 0.0, 0.0}, {0.0, 0.0, 28.0}}));
        QVERIFY2(tells("2 seed voxels · −480.0 ± 735.4 HU"), qPrintable(advice->text()));
        // As many elsewhere are others.
        QVERIFY(fixture.session().undo());
        fixture.apply(test::seedAt(2, {{8.0, 0.0, 0.0}, {0.0, 8.0, 0.0}}));
        QVERIFY2(tells("2 seed voxels · 40.0 ± 0.0 HU"), qPrintable(advice->text()));
    }

    void startsWithAnIntervalOfTheVolume()
    {
        WorkspaceFixture fixture;
        GrowthPanel panel(fixture.workspace);
        const auto& settings = fixture.workspace.growSettings();
        QVERIFY(settings.lower < settings.upper);
        QVERIFY(settings.lower >= fixture.workspace.volume()->minimum);
        QVERIFY(settings.upper <= fixture.workspace.volume()->maximum);
    }
};

BURIN_WINDOW_TEST(GrowthPanelUiTest)

} // namespace growthPanelUiTest

#include "GrowthPanelUiTest.moc"
