// SPDX-License-Identifier: Apache-2.0
#include "core/growth/front/BrickFront.h"
#include "core/growth/SeedWord.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <glm/glm.hpp>

#include <memory>
#include <vector>

namespace brickFrontTest {

using namespace core;

namespace {

constexpr int side = BrickGrid::side;

struct Claims {
    std::vector<std::uint32_t> words;
    std::vector<std::uint8_t> labels;
    std::vector<std::uint8_t> overwritten;
    VoxelBits open{};
    VoxelBits next{};
    int count = 0;
    bool operator==(const Claims&) const = default;
};

bool holds(const VoxelBits& bits, const glm::ivec3& voxel)
{
    return (bits[std::size_t(voxel.y + side * voxel.z)] >> voxel.x & 1) != 0;
}

void set(VoxelBits& bits, const glm::ivec3& voxel, bool isSet)
{
    std::uint16_t& row = bits[std::size_t(voxel.y + side * voxel.z)];
    const unsigned bit = 1u << voxel.x;
    row = std::uint16_t(isSet ? row | bit : row & ~bit);
}

/// Whether a voxel is in the front; it may lie up to one voxel outside of the brick.
bool isInFront(const FrontsAround& fronts, const glm::ivec3& voxel)
{
    glm::ivec3 brick(0);
    for (int axis = 0; axis < 3; ++axis)
        brick[axis] = voxel[axis] < 0 ? -1 : voxel[axis] >= side ? 1 : 0;
    const VoxelBits* const bits =
        fronts[std::size_t(brick.x + 1 + 3 * (brick.y + 1) + 9 * (brick.z + 1))];
    return bits && holds(*bits, voxel - side * brick);
}

/// Voxel by voxel, as seedWord.h and growth.glsl say it.
Claims expected(const ClaimRule& rule, int connectivity, const FrontsAround& fronts, Claims claims)
{
    const VoxelBits open = claims.open;
    claims.next = {};
    for (int z = 0; z < side; ++z)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const glm::ivec3 voxel(x, y, z);
                if (!holds(open, voxel))
                    continue;
                for (std::uint32_t d = 0; d < std::uint32_t(connectivity); ++d) {
                    const std::array<int, 3>& step = seedWord::offsets[d];
                    if (!isInFront(fronts, voxel - glm::ivec3(step[0], step[1], step[2])))
                        continue;
                    const auto at = std::size_t(x + side * (y + side * z));
                    const std::uint8_t there = claims.labels[at];
                    const bool held = rule.tellsHeld && there == rule.label;
                    claims.words[at] = seedWord::member(
                        rule.generation + 3, rule.label, held ? seedWord::heldDirection : d);
                    if (!claims.overwritten.empty() && (there != rule.label || !rule.tellsHeld))
                        claims.overwritten[at] = rule.tellsHeld ? there : 0;
                    claims.labels[at] = rule.label;
                    set(claims.open, voxel, false);
                    set(claims.next, voxel, true);
                    ++claims.count;
                    break;
                }
            }
    return claims;
}

VoxelBits randomBits(test::Random& random, int ofThousand)
{
    VoxelBits bits{};
    for (int i = 0; i < BrickGrid::voxelsPerBrick; ++i)
        set(bits, {i % side, i / side % side, i / (side * side)},
            test::randomInt(random, 0, 999) < ofThousand);
    return bits;
}

} // namespace

class BrickFrontTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void claimsAsVoxelByVoxel_data();
    void claimsAsVoxelByVoxel();
    void oneVoxelReachesItsNeighbours_data();
    void oneVoxelReachesItsNeighbours();
    void sidesAreThoseOfTheVoxels();
    void thoseBesideOpenVoxelsHaveAnOpenNeighbour_data();
    void thoseBesideOpenVoxelsHaveAnOpenNeighbour();
    void voxelsAreListedByOffset();
};

void BrickFrontTest::claimsAsVoxelByVoxel_data()
{
    QTest::addColumn<int>("connectivity");
    QTest::addColumn<int>("front"); // of a thousand voxels
    QTest::addColumn<int>("open");
    for (const int connectivity : {6, 18, 26}) {
        QTest::addRow("%d neighbours, thin front", connectivity) << connectivity << 5 << 900;
        QTest::addRow("%d neighbours, dense front", connectivity) << connectivity << 400 << 500;
        QTest::addRow("%d neighbours, few open", connectivity) << connectivity << 300 << 20;
        QTest::addRow("%d neighbours, all", connectivity) << connectivity << 1000 << 1000;
    }
}

void BrickFrontTest::claimsAsVoxelByVoxel()
{
    QFETCH(int, connectivity);
    QFETCH(int, front);
    QFETCH(int, open);
    test::Random random(std::uint32_t(100 * connectivity + front));
    for (int round = 0; round < (test::longRun() ? 400 : 12); ++round) {
        const ClaimRule rule{.label = std::uint8_t(test::randomInt(random, 1, 255)),
            .tellsHeld = round % 2 == 0,
            .generation =
                std::uint32_t(test::randomInt(random, 0, int(seedWord::maxGeneration) - 3))};
        std::vector<VoxelBits> bits(27);
        FrontsAround fronts{};
        for (std::size_t i = 0; i < bits.size(); ++i) {
            bits[i] = randomBits(random, front);
            // Some neighbours have no front, or lie outside of the volume.
            fronts[i] = round % 3 != 0 || test::randomInt(random, 0, 2) != 0 ? &bits[i] : nullptr;
        }
        Claims before;
        before.words.assign(BrickGrid::voxelsPerBrick, seedWord::unvisited);
        before.open = randomBits(random, open);
        for (int i = 0; i < BrickGrid::voxelsPerBrick; ++i) {
            const int there = test::randomInt(random, 0, 3);
            before.labels.push_back(there == 0 ? rule.label : std::uint8_t(there == 1 ? 7 : 0));
        }
        if (round % 4 < 2)
            before.overwritten.assign(BrickGrid::voxelsPerBrick, 9);
        before.next = randomBits(random, 500); // of a generation that is forgotten

        Claims actual = before;
        const auto claims = std::make_unique<BrickClaims>();
        const Claimed claimed =
            claimVoxels(connectivity, 3, fronts, actual.open, actual.next, *claims);
        actual.count = claimed.voxels;
        QCOMPARE(claimed.sides, sidesReached(actual.next));
        writeClaims(rule, *claims,
            {.words = actual.words.data(),
                .labels = actual.labels.data(),
                .overwritten = actual.overwritten.empty() ? nullptr : actual.overwritten.data()});
        const Claims wanted = expected(rule, connectivity, fronts, before);
        QCOMPARE(actual.count, wanted.count);
        QVERIFY(actual == wanted);
        QVERIFY(wanted.count > 0);
    }
}

void BrickFrontTest::oneVoxelReachesItsNeighbours_data()
{
    QTest::addColumn<int>("connectivity");
    for (const int connectivity : {6, 18, 26})
        QTest::addRow("%d", connectivity) << connectivity;
}

/// From each voxel of the brick and from each that touches it outside.
void BrickFrontTest::oneVoxelReachesItsNeighbours()
{
    QFETCH(int, connectivity);
    std::vector<int> directions(BrickGrid::voxelsPerBrick, -1);
    const auto claims = std::make_unique<BrickClaims>();
    for (int z = -1; z <= side; ++z)
        for (int y = -1; y <= side; ++y)
            for (int x = -1; x <= side; ++x) {
                const glm::ivec3 voxel(x, y, z);
                glm::ivec3 brick(0);
                for (int axis = 0; axis < 3; ++axis)
                    brick[axis] = voxel[axis] < 0 ? -1 : voxel[axis] >= side ? 1 : 0;
                VoxelBits front{};
                set(front, voxel - side * brick, true);
                FrontsAround fronts{};
                fronts[std::size_t(brick.x + 1 + 3 * (brick.y + 1) + 9 * (brick.z + 1))] = &front;
                VoxelBits open;
                open.fill(0xFFFF);
                VoxelBits next{};
                claims->clear();
                const Claimed claimed = claimVoxels(connectivity, 16, fronts, open, next, *claims);
                claims->forEach([&](std::uint32_t ring, std::size_t offset, std::uint32_t d) {
                    directions[offset] = ring == 16 ? int(d) : -1;
                });
                int wanted = 0;
                for (int d = 0; d < connectivity; ++d) {
                    const std::array<int, 3>& step = seedWord::offsets[std::size_t(d)];
                    const glm::ivec3 child = voxel + glm::ivec3(step[0], step[1], step[2]);
                    if (glm::any(glm::lessThan(child, glm::ivec3(0)))
                        || glm::any(glm::greaterThanEqual(child, glm::ivec3(side))))
                        continue;
                    ++wanted;
                    QVERIFY(holds(next, child));
                    const auto at = std::size_t(child.x + side * (child.y + side * child.z));
                    QCOMPARE(directions[at], d);
                }
                QCOMPARE(claimed.voxels, wanted);
            }
}

void BrickFrontTest::sidesAreThoseOfTheVoxels()
{
    QCOMPARE(sidesReached({}), 0u);
    for (int i = 0; i < BrickGrid::voxelsPerBrick; ++i) {
        const glm::ivec3 voxel(i % side, i / side % side, i / (side * side));
        VoxelBits bits{};
        set(bits, voxel, true);
        unsigned wanted = 0;
        for (int axis = 0; axis < 3; ++axis) {
            wanted |= voxel[axis] == 0 ? 1u << (2 * axis) : 0u;
            wanted |= voxel[axis] == side - 1 ? 2u << (2 * axis) : 0u;
        }
        QCOMPARE(sidesReached(bits), wanted);
    }
}

void BrickFrontTest::thoseBesideOpenVoxelsHaveAnOpenNeighbour_data()
{
    QTest::addColumn<int>("connectivity");
    for (const int connectivity : {6, 18, 26})
        QTest::addRow("%d", connectivity) << connectivity;
}

void BrickFrontTest::thoseBesideOpenVoxelsHaveAnOpenNeighbour()
{
    QFETCH(int, connectivity);
    test::Random random(std::uint32_t(connectivity) + 77);
    int beside = 0;
    for (int round = 0; round < (test::longRun() ? 400 : 12); ++round) {
        std::vector<VoxelBits> bits(27);
        FrontsAround open{};
        for (std::size_t i = 0; i < bits.size(); ++i) {
            bits[i] = randomBits(random, round % 2 == 0 ? 30 : 3);
            open[i] = test::randomInt(random, 0, 3) != 0 ? &bits[i] : nullptr;
        }
        const VoxelBits voxels = randomBits(random, 400);
        const VoxelBits found = besideOpen(connectivity, open, voxels);
        for (int i = 0; i < BrickGrid::voxelsPerBrick; ++i) {
            const glm::ivec3 voxel(i % side, i / side % side, i / (side * side));
            bool wanted = false;
            for (int d = 0; d < connectivity && holds(voxels, voxel); ++d) {
                const std::array<int, 3>& step = seedWord::offsets[std::size_t(d)];
                wanted = wanted || isInFront(open, voxel + glm::ivec3(step[0], step[1], step[2]));
            }
            QCOMPARE(holds(found, voxel), wanted);
            beside += wanted ? 1 : 0;
        }
    }
    QVERIFY(beside > 100);
}

void BrickFrontTest::voxelsAreListedByOffset()
{
    VoxelBits bits{};
    set(bits, {15, 15, 15}, true);
    set(bits, {3, 0, 0}, true);
    set(bits, {0, 2, 1}, true);
    std::vector<BrickVoxel> voxels{{0, 7}};
    appendVoxels(bits, 5, voxels);
    QCOMPARE(voxels, (std::vector<BrickVoxel>{{0, 7}, {5, 3}, {5, 288}, {5, 4095}}));
}

BURIN_TEST(BrickFrontTest)

} // namespace brickFrontTest

#include "BrickFrontTest.moc"
