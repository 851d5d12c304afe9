// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/growth/GhostWalls.h"

#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/layers/ChangeLayer.h"
#include "core/session/EditSession.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/settings/growth/GrowSettings.h"
#include "ui/tasks/growth/GrowthGhost.h"
#include "ui/tasks/growth/GrowthTurns.h"
#include "ui/workspace/PendingSeeds.h"
#include "ui/workspace/SegmentActions.h"

#include <QtTest>

#include <cmath>
#include <utility>
#include <vector>

namespace ghostWallsUiTest {

namespace smallHead = test::smallHead;

namespace {

constexpr std::int64_t asManyAsVoxels = 64000;
constexpr int patience = 60000; ///< milliseconds, on a busy machine

/// The small head with a segment and its ghost, in an interval that holds all within the bone.
class Foreseen : public test::WorkspaceFixture {
public:
    explicit Foreseen(std::int64_t mostCells)
        : ghost(workspace, nullptr, mostCells)
        , isExact(mostCells == asManyAsVoxels)
    {
        if (!ui::addSegment(workspace))
            qFatal("no segment");
        ui::GrowSettings settings = workspace.growSettings();
        settings.lower = 0.0;
        settings.upper = 60.0;
        settings.guard.on = false;
        workspace.setGrowSettings(settings);
        ghost.prepare();
    }

    /// The voxels of the ghost when it has followed.
    [[nodiscard]] std::int64_t voxels()
    {
        const bool came = QTest::qWaitFor(
            [this] {
                settle();
                ghost.follow(true);
                return workspace.seeds().isUpToDate() && ghost.voxels() && ghost.upToDate();
            },
            patience);
        if (!came)
            qFatal("no ghost came");
        return *ghost.voxels();
    }
    /// What the active segment has after the growth, which is taken back again.
    [[nodiscard]] std::int64_t grown()
    {
        apply(core::Edit(ui::growthOf(ui::growthTurns(workspace).front(), workspace)));
        const std::int64_t count = session().document().segment(workspace.activeSegment())->voxels;
        if (!session().undo())
            qFatal("no undo");
        settle();
        return count;
    }
    /// Whether the ghost has so many voxels, as far as its cells tell.
    /// @param apart by which part it may differ where cells are no voxels
    [[nodiscard]] bool foresees(std::int64_t count, double apart = 0.15)
    {
        const std::int64_t found = voxels();
        const bool right =
            isExact ? found == count : std::abs(double(found) / double(count) - 1.0) < apart;
        if (!right)
            qInfo("%lld voxels foreseen of %lld", static_cast<long long>(found),
                static_cast<long long>(count));
        return right;
    }

    ui::GrowthGhost ghost;
    bool isExact;
};

/// Across all within the bone, one voxel thin.
core::Edit sheetAt(double x, bool erase = false)
{
    return core::BarrierStroke{.path = {.radiusMm = 20.0,
                                   .shape = core::BrushPath::Shape::Disc,
                                   .normalLps = glm::dvec3(1.0, 0.0, 0.0),
                                   .pointsLps = {{x, 0.0, 0.0}}},
        .erase = erase};
}

std::int64_t allInside()
{
    return smallHead::voxelsOf(smallHead::ventricleHu) + smallHead::voxelsOf(smallHead::brainHu);
}

void addCells()
{
    QTest::addColumn<std::int64_t>("mostCells");
    QTest::newRow("every voxel a cell") << asManyAsVoxels;
    QTest::newRow("cells of 2 x 2 x 2") << std::int64_t(9000);
}

} // namespace

class GhostWallsUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void barriersBoundTheGhost_data() { addCells(); }

    /// Also after they are drawn, opened, undone and redone while it is shown.
    void barriersBoundTheGhost()
    {
        QFETCH(std::int64_t, mostCells);
        Foreseen fixture(mostCells);
        fixture.apply(test::WorkspaceFixture::middleSeed(1));
        QVERIFY(fixture.foresees(allInside()));
        fixture.apply(sheetAt(3.0));
        const std::int64_t cut = fixture.grown();
        QVERIFY(double(cut) < 0.75 * double(allInside()));
        QVERIFY(fixture.foresees(cut));
        fixture.apply(sheetAt(-4.0));
        const std::int64_t between = fixture.grown();
        QVERIFY(double(between) < 0.7 * double(cut));
        QVERIFY(fixture.foresees(between));
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.foresees(cut));
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.foresees(allInside()));
        QVERIFY(fixture.session().redo());
        QVERIFY(fixture.foresees(cut));
        fixture.apply(sheetAt(3.0, true));
        QVERIFY(fixture.foresees(allInside()));
    }

    /// Also if the ghost of before is drawn anew, because labels have changed, after one is redone.
    void barriersAreThoseOfThePresent()
    {
        Foreseen fixture(asManyAsVoxels);
        QVERIFY(ui::addSegment(fixture.workspace));
        fixture.workspace.setActiveSegment(1);
        fixture.apply(test::paintAt(2, {{-9.0, 0.0, 0.0}}, 2.0));
        fixture.apply(test::WorkspaceFixture::middleSeed(1));
        fixture.apply(sheetAt(3.0));
        fixture.apply(sheetAt(-4.0));
        const std::int64_t between = fixture.grown();
        QVERIFY(fixture.session().undo());
        QVERIFY(fixture.voxels() > between);
        QVERIFY(fixture.session().redo());
        fixture.settle();
        fixture.apply(test::paintAt(2, {{-9.0, 3.0, 0.0}}, 2.0)); // not between them
        QVERIFY(QTest::qWaitFor(
            [&fixture] {
                fixture.settle();
                return fixture.ghost.upToDate();
            },
            patience));
        QVERIFY(fixture.foresees(between));
    }

    /// One that was there before the seeds, when only these were undone and sketched again.
    void seedsLeaveBarriersAsTheyAre()
    {
        Foreseen fixture(asManyAsVoxels);
        fixture.apply(sheetAt(3.0));
        fixture.apply(test::WorkspaceFixture::middleSeed(1));
        const std::int64_t cut = fixture.grown();
        QVERIFY(cut < allInside());
        QVERIFY(fixture.foresees(cut));
        fixture.apply(test::seedAt(1, {{8.0, 0.0, 0.0}})); // on the other side
        const std::int64_t both = fixture.grown();
        QVERIFY(both > cut);
        QVERIFY(fixture.foresees(both));
        fixture.apply(test::revertRows({fixture.session().history().position()}));
        QVERIFY(fixture.foresees(cut));
    }

    /// What is previewed in passing waits for it: it would be read along.
    void othersKnowThatItReads()
    {
        Foreseen fixture(asManyAsVoxels);
        QVERIFY(ui::addSegment(fixture.workspace));
        fixture.workspace.setActiveSegment(1);
        fixture.apply(test::paintAt(2, {{-9.0, 0.0, 0.0}}, 2.0));
        fixture.apply(sheetAt(3.0));
        fixture.apply(test::WorkspaceFixture::middleSeed(1));
        const core::VoxelQuestions& questions = fixture.session().questions();
        QVERIFY(!questions.isBeingRead());
        QVERIFY(QTest::qWaitFor(
            [&] {
                fixture.settle();
                fixture.ghost.follow(true);
                return questions.isBeingRead();
            },
            patience));
        QVERIFY(fixture.voxels() > 0);
        QVERIFY(!questions.isBeingRead());
    }

    void whatIsCarvedBoundsTheGhost_data() { addCells(); }

    void whatIsCarvedBoundsTheGhost()
    {
        QFETCH(std::int64_t, mostCells);
        Foreseen fixture(mostCells);
        fixture.apply(test::WorkspaceFixture::middleSeed(1));
        std::vector<glm::dvec3> wall;
        for (double z = -18.0; z <= 18.0; z += 3.0) {
            wall.emplace_back(6.0, -18.0, z);
            wall.emplace_back(6.0, 18.0, z);
        }
        fixture.apply(test::carveAt(wall, 3.0));
        QVERIFY(fixture.foresees(allInside()));
        ui::GrowSettings settings = fixture.workspace.growSettings();
        settings.onlyVisible = true;
        fixture.workspace.setGrowSettings(settings);
        const std::int64_t cut = fixture.grown();
        QVERIFY(double(cut) < 0.8 * double(allInside()));
        QVERIFY(fixture.foresees(cut));
        fixture.apply(core::ChangeLayer{.layer = 1, .muted = true});
        QVERIFY(fixture.foresees(allInside()));
        fixture.apply(core::ChangeLayer{.layer = 1, .muted = false});
        QVERIFY(fixture.foresees(cut));
        // More of it, while the ghost is shown.
        fixture.apply(test::carveAt({{-7.0, -18.0, 0.0}, {-7.0, 18.0, 0.0}}, 5.0));
        const std::int64_t less = fixture.grown();
        QVERIFY(less < cut);
        QVERIFY(fixture.foresees(less));
    }

    void whoGrowsTooTakesItsPart_data() { addCells(); }

    void whoGrowsTooTakesItsPart()
    {
        QFETCH(std::int64_t, mostCells);
        Foreseen fixture(mostCells);
        QVERIFY(ui::addSegment(fixture.workspace));
        fixture.apply(test::seedAt(1, {{-8.0, 0.0, 0.0}}));
        fixture.apply(test::seedAt(2, {{8.0, 0.0, 0.0}}));
        for (const int active : {1, 2}) {
            fixture.workspace.setActiveSegment(active);
            const std::int64_t part = fixture.grown();
            QVERIFY(double(part) < 0.6 * double(allInside()));
            // The border between the two, a ninth of a part for each voxel, lies between cells.
            QVERIFY(fixture.foresees(part, 0.25));
        }
        fixture.apply(test::lockSegment(1));
        QVERIFY(fixture.foresees(allInside()));
    }

    /// With "overwrite", what was painted is taken, and what has grown is not.
    void whatOthersHaveGrownStaysTheirs()
    {
        Foreseen fixture(asManyAsVoxels);
        QVERIFY(ui::addSegment(fixture.workspace));
        QVERIFY(ui::addSegment(fixture.workspace));
        fixture.apply(test::WorkspaceFixture::middleSeed(2));
        fixture.apply(test::growBy({.lower = 0.0, .upper = 20.0, .segments = std::vector<int>{2}}));
        fixture.workspace.seeds().intervals().setByHand(2, 0.0, 20.0);
        fixture.apply(test::paintAt(3, {{0.0, 9.0, 0.0}}, 3.0));
        fixture.apply(test::seedAt(1, {{8.0, 0.0, 0.0}}));
        fixture.workspace.setActiveSegment(1);
        const std::int64_t brain = smallHead::voxelsOf(smallHead::brainHu);
        const std::int64_t around = fixture.grown();
        QVERIFY(around < brain);
        QVERIFY(fixture.foresees(around));
        ui::GrowSettings settings = fixture.workspace.growSettings();
        settings.overwriteUnlocked = true;
        fixture.workspace.setGrowSettings(settings);
        QCOMPARE(fixture.grown(), brain);
        QVERIFY(fixture.foresees(brain));
    }

    void meansAroundSeedsBoundTheGhost_data() { addCells(); }

    /// Around the seed a quarter is brain, which lies beyond one deviation.
    void meansAroundSeedsBoundTheGhost()
    {
        QFETCH(std::int64_t, mostCells);
        Foreseen fixture(mostCells);
        fixture.apply(test::WorkspaceFixture::middleSeed(1));
        ui::GrowSettings settings = fixture.workspace.growSettings();
        settings.sigmas = {.on = true, .value = 1.0};
        fixture.workspace.setGrowSettings(settings);
        const std::int64_t ventricle = fixture.grown();
        QCOMPARE(ventricle, smallHead::voxelsOf(smallHead::ventricleHu));
        QVERIFY(double(fixture.voxels()) < 1.5 * double(ventricle));
        QVERIFY(!fixture.isExact || fixture.foresees(ventricle));
        settings.sigmas.on = false;
        fixture.workspace.setGrowSettings(settings);
        QVERIFY(fixture.foresees(allInside()));
    }

    /// A width that the cells tell is no criterion that was left out.
    void wordsTellWhatWasLeftOut_data() { addCells(); }

    void wordsTellWhatWasLeftOut()
    {
        QFETCH(std::int64_t, mostCells);
        Foreseen fixture(mostCells);
        fixture.apply(test::WorkspaceFixture::middleSeed(1));
        ui::GrowSettings settings = fixture.workspace.growSettings();
        settings.passage = {.on = true, .value = 4.0};
        settings.onlyVisible = true;
        fixture.workspace.setGrowSettings(settings);
        QVERIFY(fixture.foresees(fixture.grown()));
        QCOMPARE(
            fixture.ghost.words().endsWith(QStringLiteral(", without necks")), !fixture.isExact);
        settings.passage.on = false;
        fixture.workspace.setGrowSettings(settings);
        QVERIFY(fixture.foresees(allInside()));
        QVERIFY2(!fixture.ghost.words().contains(QStringLiteral("without")),
            qPrintable(fixture.ghost.words()));
        settings.smoothing = true;
        fixture.workspace.setGrowSettings(settings);
        QVERIFY2(fixture.ghost.words().endsWith(QStringLiteral(", without smoothing")),
            qPrintable(fixture.ghost.words()));
    }
};

BURIN_WINDOW_TEST(GhostWallsUiTest)

} // namespace ghostWallsUiTest

#include "GhostWallsUiTest.moc"
