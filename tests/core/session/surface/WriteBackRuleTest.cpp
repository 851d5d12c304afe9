// SPDX-License-Identifier: Apache-2.0
#include "core/brick/LabelRuns.h"
#include "core/refine/mesh/SimplexMeshEdit.h"
#include "core/refine/mesh/SurfaceDelta.h"
#include "core/session/surface/FollowedVoxels.h"
#include "core/session/surface/SurfaceWriteBack.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SimplexShapes.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

namespace writeBackRuleTest {

using namespace core;

namespace {

using Mask = std::vector<std::uint8_t>; // 1: in it; x fastest

glm::ivec3 voxelOf(std::size_t place, const glm::ivec3& extent)
{
    const int at = int(place);
    return {at % extent.x, at / extent.x % extent.y, at / extent.x / extent.y};
}

VoxelRuns runsOf(const Mask& mask)
{
    return labelRuns(mask, 1);
}

/// What the header says, voxel by voxel and over all of them in every step.
Mask writtenByDefinition(
    const Mask& mask, const Mask& now, const Mask& agreed, const glm::ivec3& extent)
{
    const auto placeOf = [&extent](const glm::ivec3& voxel) {
        return std::size_t((voxel.z * extent.y + voxel.y) * extent.x + voxel.x);
    };
    Mask taken(mask.size());
    for (std::size_t i = 0; i < mask.size(); ++i)
        taken[i] = now[i] != agreed[i] ? 1 : 0;
    for (int step = 0; step < writeBackRimVoxels; ++step) {
        const Mask before = taken;
        for (std::size_t i = 0; i < mask.size(); ++i) {
            const glm::ivec3 voxel = voxelOf(i, extent);
            for (int near = 0; near < 27 && mask[i] != now[i]; ++near) {
                const glm::ivec3 other =
                    voxel + glm::ivec3(near % 3 - 1, near / 3 % 3 - 1, near / 9 - 1);
                if (glm::any(glm::lessThan(other, glm::ivec3(0)))
                    || glm::any(glm::greaterThanEqual(other, extent)))
                    continue;
                if (before[placeOf(other)] == 1 && now[placeOf(other)] == now[i])
                    taken[i] = 1;
            }
        }
    }
    Mask written = mask;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        if (taken[i] == 1)
            written[i] = now[i];
    }
    return written;
}

/// What is asked of each voxel.
Mask askedIn(const RelabelListed& edit, const glm::ivec3& extent)
{
    const BrickGrid grid{extent};
    Mask asked(std::size_t(extent.x) * std::size_t(extent.y) * std::size_t(extent.z));
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const glm::ivec3 voxel = voxelOf(i, extent);
        for (const RelabelListed::Brick& brick : edit.bricks) {
            if (int(brick.brick) == grid.brickOf(voxel))
                asked[i] = brick.asked[std::size_t(BrickGrid::offsetInBrick(voxel))];
        }
    }
    return asked;
}

} // namespace

/// The rule by which voxels follow a surface, on sets of voxels that no surface need enclose.
class WriteBackRuleTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void asDefined();
    void whatYellowWasMovedOver();
};

void WriteBackRuleTest::asDefined()
{
    test::Random random(7);
    for (int round = 0; round < (test::longRun() ? 400 : 60); ++round) {
        const glm::ivec3 extent(test::randomInt(random, 1, 20), test::randomInt(random, 1, 19),
            test::randomInt(random, 1, 18));
        const std::size_t voxels = std::size_t(extent.x * extent.y * extent.z);
        const auto noise = [&](int oneOf) {
            Mask mask(voxels);
            for (std::uint8_t& voxel : mask)
                voxel = test::randomInt(random, 1, oneOf) == 1 ? 1 : 0;
            return mask;
        };
        const auto flipped = [&](Mask mask, int oneOf) {
            const Mask flips = noise(oneOf);
            for (std::size_t i = 0; i < voxels; ++i)
                mask[i] ^= flips[i];
            return mask;
        };
        const Mask agreed = noise(2);
        const Mask now = flipped(agreed, round % 3 == 0 ? 3 : 300);
        const Mask laid = flipped(agreed, 20);
        const Mask held = flipped(agreed, round % 2 == 0 ? 3 : 12);
        std::vector<std::uint8_t> labels(voxels);
        for (std::size_t i = 0; i < voxels; ++i)
            labels[i] = held[i] == 1 ? std::uint8_t(4) : std::uint8_t(3 * (i % 2));
        const EnclosedVoxels enclosed{
            .now = runsOf(now), .agreed = runsOf(agreed), .laid = runsOf(laid)};
        LabelTarget target{.plane = 0, .label = 4};
        const Mask written = writtenByDefinition(held, now, agreed, extent);
        for (const bool overwrites : {false, true}) {
            target.overwritable[3] = overwrites;
            const RelabelListed edit = writeBackOf(enclosed, labels, extent, target);
            QVERIFY(checkSound(edit, BrickGrid{extent}));
            const Mask asked = askedIn(edit, extent);
            for (std::size_t i = 0; i < voxels; ++i) {
                const bool again = overwrites && now[i] == 1 && laid[i] == 0 && labels[i] == 3;
                const int expected = again  ? RelabelListed::give
                    : written[i] == held[i] ? 0
                    : written[i] == 1       ? RelabelListed::give
                                            : RelabelListed::take;
                QCOMPARE(int(asked[i]), expected);
            }
        }
    }
}

/// A ball around the corner of a volume, red where it is outside at the left and at the top.
void WriteBackRuleTest::whatYellowWasMovedOver()
{
    VolumeGeometry geometry;
    geometry.size = {20, 20, 20};
    SimplexMesh mesh = test::simplexSphere(3.0, 4);
    SimplexMeshEdit edit(mesh);
    for (const VertexId id : mesh.vertexIds()) {
        if (mesh.position(id).x < -2.2 || mesh.position(id).z > 2.6)
            edit.setMark(id, SurfaceMark::Red);
    }
    edit.commit();
    const SimplexMeshDelta change = deltaFromNothing(mesh);
    QVERIFY(movesYellow(change));
    const auto placeOf = [](int x, int y, int z) { return std::uint64_t((z * 20 + y) * 20 + x); };
    VoxelRuns moved;
    moved.append(placeOf(3, 0, 0), 1); // beside faces that are all yellow
    moved.append(placeOf(0, 0, 3), 1); // beside red ones
    moved.append(placeOf(0, 1, 4), 1); // hangs together with that
    moved.append(placeOf(1, 1, 5), 3);
    moved.append(placeOf(15, 15, 15), 2); // far from all
    VoxelRuns followed;
    followed.append(placeOf(3, 0, 0), 1);
    followed.append(placeOf(15, 15, 15), 2);
    QCOMPARE(followedVoxels(moved, mesh, change, geometry), followed);

    for (const VertexId id : mesh.vertexIds()) {
        SimplexMeshEdit red(mesh);
        red.setMark(id, SurfaceMark::Red);
        red.commit();
    }
    QVERIFY(!movesYellow(deltaFromNothing(mesh)));
}

BURIN_TEST(WriteBackRuleTest)

} // namespace writeBackRuleTest

#include "WriteBackRuleTest.moc"
