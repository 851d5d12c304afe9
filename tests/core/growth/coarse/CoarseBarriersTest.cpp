// SPDX-License-Identifier: Apache-2.0
#include "core/growth/coarse/CoarseBarriers.h"

#include "core/growth/SeedWord.h"
#include "core/growth/coarse/CoarseFlood.h"
#include "core/growth/coarse/CoarsePassage.h"
#include "tests/reference/growth/Growth.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <functional>
#include <map>
#include <span>
#include <vector>

namespace coarseBarriersTest {

using namespace core;
using test::Bytes;
using test::Codes;

namespace {

using Of = CoarseSeed::Of;
constexpr std::uint8_t own = 2;

template <class Does> void forEachVoxel(const glm::ivec3& size, Does does)
{
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                does(glm::ivec3(x, y, z));
}

/// A volume, what is in its label plane, and a growth in it, which the oracle carries out and a
/// flood of cells foresees.
class Scene {
public:
    explicit Scene(Codes volume)
        : codes(std::move(volume))
        , fields(codes.size)
        , coverage{codes.size, std::vector<std::uint8_t>(codes.values.size())}
    {
        burst.lowCode = test::tissueCode - 10;
        burst.highCode = test::tissueCode + 10;
    }

    /// Makes barriers where it is true.
    void shut(const std::function<bool(const glm::ivec3&)>& where)
    {
        forEachVoxel(codes.size, [&](const glm::ivec3& voxel) {
            if (where(voxel))
                fields.seedWords(0).at(voxel) = seedWord::barrier;
        });
    }
    void sketch(std::uint8_t label, const std::vector<glm::ivec3>& voxels)
    {
        reference::placeSeeds(fields, {.label = label, .voxels = voxels});
        for (const glm::ivec3& voxel : voxels)
            m_sketched.push_back({label, voxel});
    }
    /// What the flood reaches in cells.
    [[nodiscard]] CoarseReach foreseen(const CoarseGrid& grid) const
    {
        CoarseCodes coarse(grid);
        const auto slice = std::size_t(codes.size.x) * std::size_t(codes.size.y);
        std::vector<std::uint8_t> labels;
        std::vector<std::uint8_t> carved;
        reference::DenseFields held = fields;
        for (int layer = 0; layer < grid.size().z; ++layer) {
            const auto z = std::size_t(grid.sampleOf({0, 0, layer}).z);
            coarse.takeSlice(layer, std::span(codes.values).subspan(z * slice, slice));
        }
        forEachVoxel(grid.size(), [&](const glm::ivec3& cell) {
            labels.push_back(held.labels(0).at(grid.sampleOf(cell)));
            carved.push_back(burst.limits.onlyVisible ? coverage.at(grid.sampleOf(cell)) : 0);
        });
        const CoarseBarriers barriers(grid, barriersIn(wordBricks()));
        std::vector<CoarseSeed> seeds;
        for (const auto& [label, voxel] : m_sketched) {
            if (held.seedWords(0).at(voxel) == seedWord::pendingSeed(label))
                seeds.push_back({.voxel = voxel,
                    .code = codes.at(voxel),
                    .of = label < own  ? Of::RivalBefore
                        : label == own ? Of::Own
                                       : Of::RivalAfter});
        }
        return coarseFlood(
            coarse, {.labels = labels, .coverage = carved, .barriers = &barriers}, seeds, rule())
            .value();
    }
    /// Where the growth has come to: 1.
    [[nodiscard]] Bytes grown() const
    {
        reference::DenseFields after = fields;
        reference::Growth growth(codes, coverage, after, burst);
        growth.advance(-1);
        Bytes mask{codes.size, {}};
        for (const std::uint32_t word : after.seedWords(0).values)
            mask.values.push_back(seedWord::isMember(word) && seedWord::label(word) == own ? 1 : 0);
        return mask;
    }
    [[nodiscard]] CoarseRule rule() const
    {
        const GrowthRange range = burst.range.value_or(GrowthRange());
        CoarseRule rule{.lowCode = std::max(burst.lowCode, range.lowCode),
            .highCode = std::min(burst.highCode, range.highCode)};
        rule.connectivity = burst.connectivity;
        rule.passage = burst.limits.passage;
        if (burst.limits.boxed) {
            rule.boxFrom = burst.limits.boxFrom;
            rule.boxTo = burst.limits.boxTo;
        }
        rule.closed = rule.closedToRivals = ~burst.overwritable;
        rule.closed.reset(0).reset(own);
        rule.closedToRivals.reset(0);
        for (const auto& [label, voxel] : m_sketched) {
            if (label != own)
                rule.closedToRivals.reset(label);
        }
        rule.closed |= range.closed;
        rule.closedToRivals |= range.closed;
        return rule;
    }

    Codes codes;
    reference::DenseFields fields;
    Bytes coverage;
    GrowBurst burst;

private:
    [[nodiscard]] std::vector<BrickImage> wordBricks() const
    {
        std::vector<BrickImage> bricks;
        for (const BrickKey& key : fields.occupiedBricks()) {
            if (key.field == Field::SeedWords)
                bricks.push_back({.key = key, .bytes = BrickBytes(fields.readBrick(key))});
        }
        return bricks;
    }

    std::vector<std::pair<std::uint8_t, glm::ivec3>> m_sketched;
};

CoarseGrid cellsOf(const Scene& scene, int side)
{
    return {.volumeSize = scene.codes.size, .cell = glm::ivec3(side)};
}

/// A vessel of 12 × 12 voxels along x, in nothing.
Codes vessel()
{
    Codes codes = test::constantVolume({84, 30, 30}, 0);
    forEachVoxel(codes.size, [&codes](const glm::ivec3& voxel) {
        if (voxel.y >= 8 && voxel.y < 20 && voxel.z >= 8 && voxel.z < 20)
            codes.at(voxel) = test::tissueCode;
    });
    return codes;
}

/// Two rooms of 28 × 28 × 28 voxels, which a neck of 6 × 6 voxels joins.
Codes rooms()
{
    Codes codes = test::constantVolume({76, 40, 40}, 0);
    forEachVoxel(codes.size, [&codes](const glm::ivec3& voxel) {
        const bool isNeck = voxel.x >= 32 && voxel.x < 44;
        const int from = isNeck ? 16 : 6;
        const int end = isNeck ? 22 : 34;
        if (voxel.x >= 4 && voxel.x < 72 && voxel.y >= from && voxel.y < end && voxel.z >= from
            && voxel.z < end)
            codes.at(voxel) = test::tissueCode;
    });
    return codes;
}

std::int64_t countOf(const Bytes& mask)
{
    return std::count(mask.values.begin(), mask.values.end(), std::uint8_t(1));
}

/// By how much the foreseen volume differs from the grown one.
double error(const CoarseReach& foreseen, const Bytes& grown)
{
    return std::abs(double(foreseen.voxels) / double(countOf(grown)) - 1.0);
}

CoarseReach::State stateAt(
    const CoarseReach& reach, const CoarseGrid& grid, const glm::ivec3& voxel)
{
    const glm::ivec3 at = voxel / grid.cell - reach.cells.minimum;
    const glm::ivec3 size = reach.cells.maximum - reach.cells.minimum;
    if (glm::any(glm::lessThan(at, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(at, size)))
        return CoarseReach::Beyond;
    return CoarseReach::State(reach.states[std::size_t((at.z * size.y + at.y) * size.x + at.x)]);
}

/// Whether nothing is drawn in cells from a place along x on.
bool endsBefore(const CoarseReach& reach, const CoarseGrid& grid, int x)
{
    bool ends = true;
    forEachVoxel(grid.volumeSize, [&](const glm::ivec3& voxel) {
        if (voxel.x >= x)
            ends = ends && stateAt(reach, grid, voxel) == CoarseReach::Beyond;
    });
    return ends;
}

void addSides()
{
    QTest::addColumn<int>("side");
    for (const int side : {1, 2, 3, 4})
        QTest::addRow("%d", side) << side;
}

} // namespace

class CoarseBarriersTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Cells reach over the borders of bricks, and the last ones are cut off.
    void cellsKnowTheirBarriers()
    {
        Scene scene(test::constantVolume({35, 18, 17}, 0));
        scene.shut([](const glm::ivec3& voxel) { return voxel.x == 16 || voxel.z == 16; });
        std::vector<BrickImage> bricks;
        for (const BrickKey& key : scene.fields.occupiedBricks())
            bricks.push_back({.key = key, .bytes = BrickBytes(scene.fields.readBrick(key))});
        const CoarseGrid grid{.volumeSize = scene.codes.size, .cell = {3, 4, 2}};
        const CoarseBarriers barriers(grid, barriersIn(bricks));
        std::map<std::size_t, std::size_t> numbers;
        for (std::size_t n = 0; n < barriers.cells().size(); ++n)
            numbers[grid.numberOf(barriers.cells()[n])] = n;
        QCOMPARE(numbers.size(), barriers.cells().size());
        forEachVoxel(grid.size(), [&](const glm::ivec3& cell) {
            bool isAny = false;
            std::vector<std::uint8_t> wanted;
            forEachVoxel(grid.cell, [&](const glm::ivec3& local) {
                const glm::ivec3 voxel = cell * grid.cell + local;
                const bool isIn = scene.codes.contains(voxel);
                const bool isShut = isIn && (voxel.x == 16 || voxel.z == 16);
                isAny = isAny || isShut;
                wanted.push_back(isIn && !isShut ? 1 : 0);
            });
            const auto found = numbers.find(grid.numberOf(cell));
            QCOMPARE(found != numbers.end(), isAny);
            if (isAny)
                QVERIFY(std::ranges::equal(barriers.passable(found->second), wanted));
        });
        QVERIFY(CoarseBarriers(grid, {}).cells().empty());
    }

    void equalsAGrowthWhereEveryVoxelIsACell_data()
    {
        QTest::addColumn<int>("number");
        for (int number = 0; number < 40; ++number)
            QTest::addRow("volume %d", number) << number;
    }

    /// With barriers, locked labels, what is carved, a box, a range, and others that grow as well.
    void equalsAGrowthWhereEveryVoxelIsACell()
    {
        QFETCH(int, number);
        test::Random random(std::uint32_t(7100 + number));
        const glm::ivec3 size{test::randomInt(random, 6, 24), test::randomInt(random, 6, 20),
            test::randomInt(random, 6, 18)};
        Scene scene(test::noiseVolume(size, 100, random));
        scene.burst.lowCode = 15;
        scene.burst.highCode = test::randomInt(random, 60, 95);
        scene.burst.connectivity =
            std::array{6, 18, 26}[std::size_t(test::randomInt(random, 0, 2))];
        scene.fields.labels(0) = test::labelBoxes(size, 3, random);
        scene.burst.overwritable.set(4);
        if (number % 2 == 0)
            scene.shut([&](const glm::ivec3&) { return test::randomInt(random, 0, 5) == 0; });
        if (number % 3 == 0) {
            scene.burst.limits.onlyVisible = true;
            for (std::uint8_t& covered : scene.coverage.values)
                covered = std::uint8_t(test::randomInt(random, 0, 150));
        }
        if (number % 4 == 0) {
            scene.burst.limits.boxed = true;
            scene.burst.limits.boxFrom = size / 6;
            scene.burst.limits.boxTo = size - 1 - size / 7;
        }
        if (number % 5 == 0) {
            scene.burst.range = GrowthRange{.lowCode = 22, .highCode = 88};
            scene.burst.range->closed.set(4);
        }
        for (const std::uint8_t label : {std::uint8_t(own - 1), own, std::uint8_t(own + 1)}) {
            if (label == own || number % 4 == int(label)) // one rival at most
                scene.sketch(label,
                    {test::randomVoxel(random, size), test::randomVoxel(random, size),
                        test::randomVoxel(random, size)});
        }
        const CoarseReach foreseen = scene.foreseen(cellsOf(scene, 1));
        const Bytes grown = scene.grown();
        QCOMPARE(foreseen.voxels, countOf(grown));
        forEachVoxel(size, [&](const glm::ivec3& voxel) {
            QCOMPARE(int(stateAt(foreseen, cellsOf(scene, 1), voxel)),
                int(grown.at(voxel) != 0 ? CoarseReach::Reached : CoarseReach::Beyond));
        });
    }

    void aBarrierCutsAVessel_data() { addSides(); }

    /// It is one voxel thin, at any place in cells.
    void aBarrierCutsAVessel()
    {
        QFETCH(int, side);
        for (int at = 40; at < 44; ++at) {
            Scene scene(vessel());
            scene.sketch(own, {{5, 14, 14}});
            scene.shut([at](const glm::ivec3& voxel) { return voxel.x == at; });
            const CoarseGrid grid = cellsOf(scene, side);
            const CoarseReach foreseen = scene.foreseen(grid);
            const Bytes grown = scene.grown();
            QCOMPARE(countOf(grown), std::int64_t(at) * 12 * 12);
            QVERIFY2(error(foreseen, grown) < 0.03, qPrintable(QString::number(at)));
            QVERIFY(endsBefore(foreseen, grid, (at / side + 1) * side));
        }
    }

    void aSeedStaysOnItsSideOfABarrier_data() { addSides(); }

    void aSeedStaysOnItsSideOfABarrier()
    {
        QFETCH(int, side);
        for (int at = 40; at < 44; ++at) {
            for (const int away : {-1, 1}) {
                Scene scene(vessel());
                scene.sketch(own, {{at + away, 14, 14}, {at + away, 9, 19}});
                scene.shut([at](const glm::ivec3& voxel) { return voxel.x == at; });
                const Bytes grown = scene.grown();
                const CoarseReach foreseen = scene.foreseen(cellsOf(scene, side));
                QVERIFY2(error(foreseen, grown) < 0.03, qPrintable(QString::number(at)));
            }
        }
    }

    void aSlantingBarrierHolds_data() { addSides(); }

    void aSlantingBarrierHolds()
    {
        QFETCH(int, side);
        Scene scene(vessel());
        scene.sketch(own, {{5, 14, 14}});
        scene.burst.connectivity = 26;
        scene.shut([](const glm::ivec3& voxel) {
            const int along = 6 * voxel.x + 3 * voxel.y + 2 * voxel.z;
            return along >= 300 && along < 311; // no step leads across
        });
        const Bytes grown = scene.grown();
        QVERIFY(countOf(grown) < 50 * 12 * 12);
        QVERIFY(error(scene.foreseen(cellsOf(scene, side)), grown) < 0.05);
    }

    void aHoleInABarrierIsPassed_data() { addSides(); }

    void aHoleInABarrierIsPassed()
    {
        QFETCH(int, side);
        Scene scene(vessel());
        scene.sketch(own, {{5, 14, 14}});
        scene.shut([](const glm::ivec3& voxel) {
            return voxel.x == 41 && (voxel.y != 13 || voxel.z != 14);
        });
        const Bytes grown = scene.grown();
        QVERIFY(countOf(grown) > 80 * 12 * 12);
        QVERIFY(error(scene.foreseen(cellsOf(scene, side)), grown) < 0.03);
    }

    void whatIsLockedOrCarvedStopsIt_data() { addSides(); }

    /// Walls as thick as a cell: thinner ones may be passed.
    void whatIsLockedOrCarvedStopsIt()
    {
        QFETCH(int, side);
        for (const bool isCarved : {false, true}) {
            Scene scene(vessel());
            scene.sketch(own, {{5, 14, 14}});
            scene.burst.limits.onlyVisible = true;
            scene.burst.lockedLabels.set(7);
            forEachVoxel(scene.codes.size, [&](const glm::ivec3& voxel) {
                if (voxel.x >= 41 && voxel.x < 41 + side)
                    (isCarved ? scene.coverage : scene.fields.labels(0)).at(voxel) =
                        isCarved ? 128 : 7;
            });
            const Bytes grown = scene.grown();
            QCOMPARE(countOf(grown), std::int64_t(41) * 12 * 12);
            QVERIFY(error(scene.foreseen(cellsOf(scene, side)), grown) < 0.06);
        }
    }

    void whoGrowsTooTakesItsPart_data() { addSides(); }

    /// From both ends of the vessel, and where the other one has the longer way.
    void whoGrowsTooTakesItsPart()
    {
        QFETCH(int, side);
        for (const std::uint8_t other : {std::uint8_t(own - 1), std::uint8_t(own + 1)}) {
            for (const int from : {82, 62}) {
                Scene scene(vessel());
                scene.sketch(own, {{2, 14, 14}});
                scene.sketch(other, {{from, 14, 14}});
                const Bytes grown = scene.grown();
                QVERIFY(std::abs(double(countOf(grown)) / (12 * 12) - (from + 2) / 2.0) < 3.0);
                const double off = error(scene.foreseen(cellsOf(scene, side)), grown);
                QVERIFY2(off < 0.12, qPrintable(QString::number(off)));
            }
        }
    }

    void itStopsAtNecks_data() { addSides(); }

    /// A ball of 6 voxels has no room in the neck, one of 2 has, and the largest cells cannot tell
    /// the latter. Without the width more than twice as much is taken.
    void itStopsAtNecks()
    {
        QFETCH(int, side);
        for (const int radius : {6, 2}) {
            Scene scene(rooms());
            scene.sketch(own, {{18, 20, 20}});
            scene.burst.limits.passage = {
                .spacing = glm::ivec3(16), .reach = 16 * radius * 16 * radius};
            const CoarseGrid grid = cellsOf(scene, side);
            QCOMPARE(CoarsePassage(scene.burst.limits.passage, grid).isTold(), side <= radius);
            const Bytes grown = scene.grown();
            QCOMPARE(countOf(grown) > 30000, radius == 2);
            const double off = error(scene.foreseen(grid), grown);
            QVERIFY2(off < (side == 1 ? 0.001 : 0.25), qPrintable(QString::number(off)));
        }
    }

    /// In no ball, it takes itself alone.
    void aSeedWithoutRoomStaysAlone()
    {
        Scene scene(rooms());
        scene.sketch(own, {{38, 18, 18}});
        scene.burst.limits.passage = {.spacing = glm::ivec3(16), .reach = 96 * 96};
        QCOMPARE(countOf(scene.grown()), std::int64_t(1));
        QCOMPARE(scene.foreseen(cellsOf(scene, 1)).voxels, std::int64_t(1));
    }
};

BURIN_TEST(CoarseBarriersTest)

} // namespace coarseBarriersTest

#include "CoarseBarriersTest.moc"
