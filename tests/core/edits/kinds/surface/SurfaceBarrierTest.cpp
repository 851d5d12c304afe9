// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/surface/SurfaceBarrier.h"
#include "core/edits/EditJson.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/growth/ResumeGrowth.h"
#include "core/edits/kinds/surface/DropSurface.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/SpherePush.h"
#include "core/refine/voxels/SurfaceVoxels.h"
#include "core/session/EditSession.h"
#include "core/session/SessionSurface.h"
#include "core/session/questions/VoxelQuestions.h"
#include "core/session/surface/SurfaceWriteBack.h"
#include "core/titles/TitleLanguage.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/SurfaceCases.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <algorithm>

namespace surfaceBarrierTest {

using namespace core;

namespace {

using Mask = std::vector<std::uint8_t>; // 1: in it; x fastest

const glm::ivec3 size = test::smallStudy().volume.geometry.size;

glm::dvec3 at(const glm::dvec3& voxel)
{
    return test::smallStudy().volume.geometry.toWorld(voxel);
}

Mask maskOf(const VoxelRuns& runs, const glm::ivec3& extent)
{
    Mask mask(std::size_t(extent.x) * std::size_t(extent.y) * std::size_t(extent.z));
    for (const VoxelRun& run : runs.runs())
        std::fill_n(mask.begin() + std::ptrdiff_t(run.first), run.count, std::uint8_t(1));
    return mask;
}

/// What is outside of a mask and has some of it among the 26 around.
Mask shellOf(const Mask& mask, const glm::ivec3& extent)
{
    const auto placeOf = [&extent](const glm::ivec3& voxel) {
        return std::size_t((voxel.z * extent.y + voxel.y) * extent.x + voxel.x);
    };
    Mask shell(mask.size());
    for (int z = 0; z < extent.z; ++z)
        for (int y = 0; y < extent.y; ++y)
            for (int x = 0; x < extent.x; ++x)
                for (int near = 0; near < 27; ++near) {
                    const glm::ivec3 other(
                        x + near % 3 - 1, y + near / 3 % 3 - 1, z + near / 9 - 1);
                    if (glm::any(glm::lessThan(other, glm::ivec3(0)))
                        || glm::any(glm::greaterThanEqual(other, extent)))
                        continue;
                    if (mask[placeOf(other)] != 0 && mask[placeOf({x, y, z})] == 0)
                        shell[placeOf({x, y, z})] = 1;
                }
    return shell;
}

/// Grows into every value, and takes from other segments.
Edit growth(int connectivity)
{
    return test::growBy(
        {.lower = -2000, .upper = 4000, .connectivity = connectivity, .overwriteUnlocked = true});
}

/// A session whose segment 1 is a ball with a bulge, inside a surface; 2 and 3 are empty.
struct Bench {
    explicit Bench()
        : session(*EditSession::create(engine, test::smallStudy(), {}))
    {
        const glm::dvec3 middle = (glm::dvec3(size) - 1.0) / 2.0;
        for (const Edit& edit : {Edit(test::ballMask(size, 9.0)), Edit(test::addSegment("Inside")),
                 Edit(test::addSegment("Outside")), Edit(LaySurface{.segment = 1, .vertices = 600}),
                 Edit(SpherePush{.path = {.radiusMm = 4.0,
                                         .pointsLps = {at(middle + glm::dvec3(7, 0, 0)),
                                             at(middle + glm::dvec3(9, 0, 0)),
                                             at(middle + glm::dvec3(11, 2, 0))}}}),
                 Edit(test::seedAt(2, {at(middle)})), Edit(test::seedAt(3, {at({0, 0, 0})}))})
            run(edit);
        inside = maskOf(
            *voxelsOf(*session->surface().mesh(), session->document().volumes.front().geometry, {}),
            size);
        shell = shellOf(inside, size);
    }
    void run(const Edit& edit)
    {
        const Result<void> applied = session->apply(edit);
        QVERIFY2(applied, qPrintable(applied ? QString() : applied.error().arguments.join(u' ')));
        const Result<void> done = session->settle();
        QVERIFY2(done, qPrintable(done ? QString() : done.error().arguments.join(u' ')));
    }
    [[nodiscard]] Mask heldBy(std::uint8_t label)
    {
        Mask held = *session->questions().labels(0);
        for (std::uint8_t& voxel : held)
            voxel = voxel == label ? 1 : 0;
        return held;
    }
    [[nodiscard]] const HistoryRow& lastRow() const
    {
        return session->history().row(session->history().position());
    }

    reference::ReferenceEngine engine;
    std::unique_ptr<EditSession> session;
    Mask inside;
    Mask shell;
};

std::int64_t count(const Mask& mask)
{
    return std::count(mask.begin(), mask.end(), std::uint8_t(1));
}

} // namespace

/// The surface that is being refined as a wall of growth.
class SurfaceBarrierTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void shellsAreOfTheirDefinition_data();
    void shellsAreOfTheirDefinition();
    void growthStaysOnItsSide_data();
    void growthStaysOnItsSide();
    void replaysGiveTheSame();
    void whatIsLockedStays();
    void withoutASurfaceItIsRefused();
};

void SurfaceBarrierTest::shellsAreOfTheirDefinition_data()
{
    QTest::addColumn<glm::ivec3>("extent");
    QTest::addColumn<int>("oneOf");
    int number = 0;
    for (const glm::ivec3& extent : {glm::ivec3(1), glm::ivec3(2, 1, 1), glm::ivec3(1, 7, 3),
             glm::ivec3(17, 16, 15), glm::ivec3(33, 5, 18), glm::ivec3(20, 33, 2)})
        for (const int oneOf : {1, 2, 5, 60, 100000})
            QTest::addRow("%d", ++number) << extent << oneOf;
}

void SurfaceBarrierTest::shellsAreOfTheirDefinition()
{
    QFETCH(glm::ivec3, extent);
    QFETCH(int, oneOf);
    test::Random random(std::uint32_t(extent.x * 100 + oneOf));
    VoxelRuns runs;
    const std::uint64_t voxels = std::uint64_t(extent.x) * std::uint64_t(extent.y * extent.z);
    for (std::uint64_t voxel = 0; voxel < voxels; ++voxel) {
        if (random() % unsigned(oneOf) == 0)
            runs.append(voxel, 1);
    }
    const VoxelRuns found = shellAround(runs, extent);
    const Mask shell = shellOf(maskOf(runs, extent), extent);
    QVERIFY(maskOf(found, extent) == shell);

    const BrickGrid grid{extent};
    const std::vector<BarrierListed::Brick> bricks = placesOf(found, extent);
    QVERIFY(isSound(BarrierListed{.bricks = bricks}, grid.brickCount()));
    std::size_t listed = 0;
    for (const BarrierListed::Brick& brick : bricks) {
        QVERIFY(brick.places.any());
        listed += brick.places.count();
    }
    QCOMPARE(listed, found.voxelCount());
    for (int z = 0; z < extent.z; ++z)
        for (int y = 0; y < extent.y; ++y)
            for (int x = 0; x < extent.x; ++x) {
                if (shell[std::size_t((z * extent.y + y) * extent.x + x)] == 0)
                    continue;
                const auto brick =
                    std::find_if(bricks.begin(), bricks.end(), [&](const auto& each) {
                        return int(each.brick) == grid.brickOf({x, y, z});
                    });
                QVERIFY(brick != bricks.end());
                QVERIFY(brick->places[std::size_t(BrickGrid::offsetInBrick({x, y, z}))]);
            }
}

void SurfaceBarrierTest::growthStaysOnItsSide_data()
{
    QTest::addColumn<int>("connectivity");
    for (const int connectivity : {6, 18, 26})
        QTest::addRow("%d neighbours", connectivity) << connectivity;
}

void SurfaceBarrierTest::growthStaysOnItsSide()
{
    QFETCH(int, connectivity);
    Bench bench;
    QVERIFY(count(bench.inside) > 2500);
    const Mask before = bench.heldBy(1);
    bench.run(SurfaceBarrier{});
    QCOMPARE(bench.lastRow().name,
        QStringLiteral("Barrier around surface, %1 voxels").arg(grouped(count(bench.shell))));
    QVERIFY(bench.heldBy(1) == before); // no voxel was taken from anybody
    bench.run(growth(connectivity));
    QVERIFY(bench.heldBy(2) == bench.inside);
    Mask outside = bench.inside;
    for (std::size_t voxel = 0; voxel < outside.size(); ++voxel)
        outside[voxel] = bench.inside[voxel] + bench.shell[voxel] == 0 ? 1 : 0;
    QVERIFY(bench.heldBy(3) == outside);

    bench.run(SurfaceBarrier{.erase = true});
    QVERIFY(bench.lastRow().name.startsWith(QStringLiteral("Open barrier around surface, ")));
    bench.run(ResumeGrowth{});
    QCOMPARE(count(bench.heldBy(2)) + count(bench.heldBy(3)), std::int64_t(bench.inside.size()));
    // Undone, it is shut again.
    for (int i = 0; i < 3; ++i)
        QVERIFY(bench.session->undo());
    QVERIFY(bench.session->settle());
    bench.run(growth(connectivity));
    QVERIFY(bench.heldBy(2) == bench.inside);
}

void SurfaceBarrierTest::replaysGiveTheSame()
{
    Bench bench;
    bench.run(growth(6));
    bench.run(SurfaceBarrier{}); // through what has grown
    bench.run(growth(18));
    bench.run(SurfaceBarrier{.erase = true});
    bench.run(ResumeGrowth{});
    reference::ReferenceEngine engine;
    auto again = *EditSession::create(engine, test::smallStudy(), {});
    const History& history = bench.session->history();
    for (const RowId row : history.pathTo(history.position())) {
        const Result<Edit> read = editFromJson(editToJson(history.row(row).edit));
        QVERIFY(read);
        QVERIFY(again->apply(*read));
        QVERIFY(again->settle());
    }
    QCOMPARE(again->stateHash(), bench.session->stateHash());
}

void SurfaceBarrierTest::whatIsLockedStays()
{
    Bench bench;
    bench.run(growth(26));
    const Mask inside = bench.heldBy(2);
    const Mask outside = bench.heldBy(3);
    bench.run(test::lockSegment(3));
    bench.run(SurfaceBarrier{});
    // Its members are walls themselves: none of them grows, and none is grown over.
    QVERIFY(bench.heldBy(3) == outside);
    const Mask left = bench.heldBy(2);
    for (std::size_t voxel = 0; voxel < left.size(); ++voxel)
        QCOMPARE(int(left[voxel]), int(inside[voxel] != 0 && bench.shell[voxel] == 0));
    QVERIFY(count(left) < count(inside));
}

void SurfaceBarrierTest::withoutASurfaceItIsRefused()
{
    Bench bench;
    bench.run(DropSurface{});
    for (const bool erase : {false, true}) {
        const Result<void> refused = bench.session->apply(SurfaceBarrier{.erase = erase});
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::InvalidField);
        QVERIFY(refused.error().arguments.join(u' ').contains(QStringLiteral("there is none")));
    }
}

BURIN_TEST(SurfaceBarrierTest)

} // namespace surfaceBarrierTest

#include "SurfaceBarrierTest.moc"
