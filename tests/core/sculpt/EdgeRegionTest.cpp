// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/EdgeRegion.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace edgeRegionTest {

using namespace core;
using test::Random;
using test::randomInt;

namespace {

using Voxel = std::array<int, 3>;
using Voxels = std::set<Voxel>;

constexpr int ball = -1;

/// Of voxels of 1 mm; flat across one axis, in the plane of this number.
CapsuleFrame frameAcross(int axis, int plane = 0)
{
    constexpr std::int64_t millimetre = std::int64_t(1) << 30;
    CapsuleFrame frame;
    frame.isFlat = axis != ball;
    frame.halfThickness = 1 << 15;
    frame.perI = {millimetre, 0, 0};
    frame.perJ = {0, millimetre, 0};
    frame.perK = {0, 0, millimetre};
    if (axis == 0)
        std::swap(frame.perI, frame.perK);
    else if (axis == 1)
        std::swap(frame.perJ, frame.perK);
    frame.origin = {0, 0, -plane * millimetre};
    return frame;
}

bool steps(const Voxel& a, const Voxel& b, int axis)
{
    int others = 0;
    for (int each = 0; each < 3; ++each) {
        const int apart = std::abs(a[std::size_t(each)] - b[std::size_t(each)]);
        if (each == axis) {
            if (apart > 1)
                return false;
        } else {
            others += apart;
        }
    }
    return others <= 1;
}

/// Every voxel against every other, until nothing is added.
Voxels membersOf(const Voxels& alike, const Voxels& under, int axis)
{
    Voxels members;
    std::set_intersection(alike.begin(), alike.end(), under.begin(), under.end(),
        std::inserter(members, members.end()));
    for (std::size_t before = members.size() + 1; before != members.size();) {
        before = members.size();
        for (const Voxel& voxel : alike) {
            if (!members.count(voxel)
                && std::any_of(members.begin(), members.end(),
                    [&](const Voxel& member) { return steps(voxel, member, axis); }))
                members.insert(voxel);
        }
    }
    return members;
}

std::map<std::uint32_t, EdgeRegion::Bits> bricksOf(const Voxels& voxels, const BrickGrid& grid)
{
    std::map<std::uint32_t, EdgeRegion::Bits> bricks;
    for (const Voxel& each : voxels) {
        const glm::ivec3 voxel(each[0], each[1], each[2]);
        const int offset = BrickGrid::offsetInBrick(voxel);
        bricks[std::uint32_t(grid.brickOf(voxel))][std::size_t(offset) / 32] |= 1u << (offset % 32);
    }
    return bricks;
}

} // namespace

class EdgeRegionTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void membersAreThoseOfEveryVoxelAgainstEveryOther_data()
    {
        QTest::addColumn<int>("axis");
        QTest::addColumn<int>("seed");
        for (int axis = ball; axis < 3; ++axis)
            for (int seed = 0; seed < 6; ++seed)
                QTest::addRow("axis %d, %d", axis, seed) << axis << seed;
    }
    /// However it is told: in which order, how often, what was under the pen before or after.
    void membersAreThoseOfEveryVoxelAgainstEveryOther()
    {
        QFETCH(int, axis);
        QFETCH(int, seed);
        Random random(std::uint32_t(100 * axis + seed + 700));
        const BrickGrid grid{{19, 18, 4}};
        const int percent = 25 + 10 * seed;
        Voxels alike;
        Voxels under;
        for (int z = 0; z < grid.volumeSize.z; ++z) {
            for (int y = 0; y < grid.volumeSize.y; ++y) {
                for (int x = 0; x < grid.volumeSize.x; ++x) {
                    if (randomInt(random, 0, 99) < percent)
                        alike.insert({x, y, z});
                    if (randomInt(random, 0, 99) < 2)
                        under.insert({x, y, z});
                }
            }
        }
        const Voxels expected = membersOf(alike, under, axis);
        QVERIFY(!expected.empty());
        QVERIFY(axis != ball || percent > 60 || expected.size() < alike.size());

        EdgeRegion region(frameAcross(axis), grid);
        constexpr std::size_t parts = 5;
        std::array<Voxels, parts> alikeParts;
        std::array<std::vector<glm::ivec3>, parts> underParts;
        for (const Voxel& voxel : alike) {
            alikeParts[std::size_t(randomInt(random, 0, parts - 1))].insert(voxel);
            if (randomInt(random, 0, 3) == 0) // twice
                alikeParts[std::size_t(randomInt(random, 0, parts - 1))].insert(voxel);
        }
        for (const Voxel& voxel : under)
            underParts[std::size_t(randomInt(random, 0, parts - 1))].emplace_back(
                voxel[0], voxel[1], voxel[2]);
        underParts[0].emplace_back(-1, 0, 0);
        underParts[1].push_back(grid.volumeSize);
        Voxels found;
        for (std::size_t part = 0; part < parts; ++part) {
            region.addUnder(underParts[part]);
            for (const auto& [brick, bits] : bricksOf(alikeParts[part], grid))
                region.addAlike(brick, bits);
            if (part % 2)
                continue; // the next one asks for both
            for (const auto& [brick, bits] : region.takeNew()) {
                const VoxelBox box = grid.boxOf(int(brick));
                for (int offset = 0; offset < BrickGrid::voxelsPerBrick; ++offset) {
                    if ((bits[std::size_t(offset) / 32] >> (offset % 32) & 1u) == 0)
                        continue;
                    const glm::ivec3 voxel =
                        box.minimum + glm::ivec3(offset % 16, offset / 16 % 16, offset / 256);
                    QVERIFY2(found.insert({voxel.x, voxel.y, voxel.z}).second, "told twice");
                }
            }
        }
        QVERIFY(found == expected);
        QVERIFY(region.takeNew().empty());
    }

    /// A wall of one voxel holds in a slice, also where it runs diagonally.
    void noStepLeadsThroughADiagonal()
    {
        const BrickGrid grid{{12, 12, 1}};
        for (const int axis : {ball, 2}) {
            Voxels alike;
            for (int y = 0; y < 12; ++y)
                for (int x = 0; x < 12; ++x)
                    if (x + y != 11)
                        alike.insert({x, y, 0});
            EdgeRegion region(frameAcross(axis), grid);
            for (const auto& [brick, bits] : bricksOf(alike, grid))
                region.addAlike(brick, bits);
            region.addUnder({{2, 2, 0}});
            std::size_t members = 0;
            for (const auto& [brick, bits] : region.takeNew())
                for (const std::uint32_t word : bits)
                    members += std::size_t(qPopulationCount(word));
            QCOMPARE(members, std::size_t(66)); // below the diagonal: 11 + 10 + … + 1
        }
    }

    void theValueIsTheLowerMedian()
    {
        const BrickGrid grid{{20, 20, 20}};
        // Of 27 voxels the fourteenth.
        std::vector<std::uint16_t> codes;
        for (int i = 0; i < 27; ++i)
            codes.push_back(std::uint16_t((i * 10) % 27)); // each of 0 … 26 once
        EdgeRule rule{.start = {16, 5, 8}, .tolerance = 3};
        QCOMPARE(edgeValueBox(rule, grid).maximum, glm::ivec3(18, 7, 10));
        QCOMPARE(edgeValue(rule, frameAcross(ball), grid, codes), 13);
        // In a corner eight, of which the fourth.
        rule.start = {19, 0, 19};
        QCOMPARE(edgeValueBox(rule, grid).minimum, glm::ivec3(18, 0, 18));
        QCOMPARE(edgeValueBox(rule, grid).maximum, glm::ivec3(20, 2, 20));
        QCOMPARE(edgeValue(rule, frameAcross(ball), grid,
                     std::vector<std::uint16_t>{80, 10, 70, 20, 60, 30, 50, 40}),
            40);
        // Flat, only those of its plane: nine of them, along each axis.
        rule.start = {16, 15, 9};
        for (int axis = 0; axis < 3; ++axis) {
            std::vector<std::uint16_t> apart;
            for (int i = 0; i < 27; ++i) {
                const std::array<int, 3> local{i % 3, i / 3 % 3, i / 9};
                apart.push_back(
                    local[std::size_t(axis)] == 1 ? std::uint16_t(100 + i) : std::uint16_t(9));
            }
            // The middle one of those in the plane is the start itself: 13 of 27.
            QCOMPARE(edgeValue(rule, frameAcross(axis, rule.start[axis]), grid, apart), 113);
            // In a plane far off the start alone counts.
            QCOMPARE(edgeValue(rule, frameAcross(axis, 3), grid, apart), 113);
            apart[13] = 7;
            QCOMPARE(edgeValue(rule, frameAcross(axis, 3), grid, apart), 7);
        }
    }

    void rulesInRangeAreSound()
    {
        const BrickGrid grid{{20, 10, 5}};
        QVERIFY(isSound(EdgeRule{.start = {19, 9, 4}, .tolerance = 65535}, grid));
        QVERIFY(isSound(EdgeRule{}, grid));
        QVERIFY(!isSound(EdgeRule{.start = {20, 9, 4}}, grid));
        QVERIFY(!isSound(EdgeRule{.start = {0, -1, 0}}, grid));
        QVERIFY(!isSound(EdgeRule{.tolerance = -1}, grid));
        QVERIFY(!isSound(EdgeRule{.tolerance = 65536}, grid));
    }
};

BURIN_PLAIN_TEST(EdgeRegionTest)

} // namespace edgeRegionTest

#include "EdgeRegionTest.moc"
