// SPDX-License-Identifier: Apache-2.0
#include "core/growth/coarse/CoarseFlood.h"

#include "core/growth/SeedWord.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace coarseFloodTest {

using namespace core;
using test::Bytes;
using test::Codes;

namespace {

CoarseCodes sampled(const Codes& codes, std::int64_t mostCells)
{
    CoarseCodes coarse(CoarseGrid::of(codes.size, glm::dvec3(1.0), mostCells));
    const auto slice = std::size_t(codes.size.x) * std::size_t(codes.size.y);
    for (int layer = 0; layer < coarse.grid().size().z; ++layer) {
        const auto z = std::size_t(coarse.grid().sampleOf({0, 0, layer}).z);
        coarse.takeSlice(layer, std::span(codes.values).subspan(z * slice, slice));
    }
    return coarse;
}

std::vector<std::uint8_t> sampled(const Bytes& labels, const CoarseGrid& grid)
{
    std::vector<std::uint8_t> cells;
    const glm::ivec3 size = grid.size();
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                cells.push_back(labels.at(grid.sampleOf({x, y, z})));
    return cells;
}

CoarseSeed seedAt(const Codes& codes, const glm::ivec3& voxel)
{
    return {.voxel = voxel, .code = codes.at(voxel)};
}

/// A flood of every voxel, as plainly as can be.
Bytes plainFlood(const Codes& codes, const Bytes& labels, const std::vector<CoarseSeed>& seeds,
    const CoarseRule& rule)
{
    Bytes reached{codes.size, std::vector<std::uint8_t>(codes.values.size())};
    const auto isOpen = [&](const glm::ivec3& voxel) {
        return codes.contains(voxel) && codes.at(voxel) >= rule.lowCode
            && codes.at(voxel) <= rule.highCode
            && !rule.closed.test(labels.values.empty() ? 0 : labels.at(voxel))
            && glm::all(glm::greaterThanEqual(voxel, rule.boxFrom))
            && glm::all(glm::lessThanEqual(voxel, rule.boxTo));
    };
    std::vector<glm::ivec3> open;
    const auto take = [&](const glm::ivec3& voxel) {
        if (!isOpen(voxel) || reached.at(voxel) != 0)
            return;
        reached.at(voxel) = 1;
        open.push_back(voxel);
    };
    for (const CoarseSeed& seed : seeds)
        take(seed.voxel);
    while (!open.empty()) {
        const glm::ivec3 voxel = open.back();
        open.pop_back();
        for (int i = 0; i < rule.connectivity; ++i) {
            const std::array<int, 3>& step = seedWord::offsets[std::size_t(i)];
            take(voxel + glm::ivec3(step[0], step[1], step[2]));
        }
    }
    return reached;
}

/// What slices draw: voxels of the interval in cells that were reached, or touch them.
Bytes drawn(
    const Codes& codes, const CoarseGrid& grid, const CoarseReach& reach, const CoarseRule& rule)
{
    Bytes shown{codes.size, std::vector<std::uint8_t>(codes.values.size())};
    const glm::ivec3 size = reach.cells.maximum - reach.cells.minimum;
    for (int z = 0; z < codes.size.z; ++z) {
        for (int y = 0; y < codes.size.y; ++y) {
            for (int x = 0; x < codes.size.x; ++x) {
                const glm::ivec3 voxel(x, y, z);
                const glm::ivec3 at = voxel / grid.cell - reach.cells.minimum;
                if (glm::any(glm::lessThan(at, glm::ivec3(0)))
                    || glm::any(glm::greaterThanEqual(at, size)))
                    continue;
                const std::size_t number =
                    (std::size_t(at.z) * std::size_t(size.y) + std::size_t(at.y))
                        * std::size_t(size.x)
                    + std::size_t(at.x);
                const int code = codes.at(voxel);
                shown.at(voxel) = reach.states[number] != CoarseReach::Beyond
                    && code >= rule.lowCode && code <= rule.highCode;
            }
        }
    }
    return shown;
}

/// One past the last voxel along x that is in a cell that was reached, or touches one.
int endAlongX(const CoarseReach& reach, const CoarseGrid& grid)
{
    const int width = reach.cells.maximum.x - reach.cells.minimum.x;
    int end = 0;
    for (std::size_t at = 0; at < reach.states.size(); ++at) {
        if (reach.states[at] != CoarseReach::Beyond)
            end = std::max(end, reach.cells.minimum.x + int(at % std::size_t(width)) + 1);
    }
    return end * grid.cell.x;
}

std::int64_t countOf(const Bytes& voxels)
{
    return std::count(voxels.values.begin(), voxels.values.end(), std::uint8_t(1));
}

double dice(const Bytes& a, const Bytes& b)
{
    std::int64_t both = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i)
        both += a.values[i] != 0 && b.values[i] != 0 ? 1 : 0;
    return 2.0 * double(both) / double(countOf(a) + countOf(b));
}

/// A ball of tissue in noise of up to a half of its code.
Codes ballAt(const glm::ivec3& size, const glm::dvec3& centre, double radius)
{
    test::Random random(7);
    Codes codes = test::noiseVolume(size, test::tissueCode / 2, random);
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                if (glm::distance(glm::dvec3(x, y, z), centre) < radius)
                    codes.at({x, y, z}) = test::tissueCode;
    return codes;
}

const CoarseRule tissue{.lowCode = test::tissueCode - 10, .highCode = test::tissueCode + 10};

} // namespace

class CoarseFloodTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void cellsAreAsLongEveryWay()
    {
        const auto cellOf = [](const glm::ivec3& size, const glm::dvec3& spacing, int most) {
            return CoarseGrid::of(size, spacing, most).cell;
        };
        QCOMPARE(cellOf({40, 30, 20}, glm::dvec3(1.0), 24000), glm::ivec3(1));
        QCOMPARE(cellOf({512, 512, 512}, glm::dvec3(0.7), 1 << 21), glm::ivec3(4));
        QCOMPARE(cellOf({512, 512, 60}, {0.7, 0.7, 5.0}, 1 << 21), glm::ivec3(3, 3, 1));
        QCOMPARE(cellOf({1, 1, 1}, glm::dvec3(1.0), 0), glm::ivec3(1));
        const CoarseGrid grid = CoarseGrid::of({7, 5, 3}, glm::dvec3(1.0), 24);
        QCOMPARE(grid.cell, glm::ivec3(2));
        QCOMPARE(grid.size(), glm::ivec3(4, 3, 2));
        QCOMPARE(grid.sampleOf({0, 1, 0}), glm::ivec3(1, 3, 1));
        QCOMPARE(grid.sampleOf({3, 2, 1}), glm::ivec3(6, 4, 2)); // cut off
        QCOMPARE(grid.voxelsIn({0, 0, 0}), std::int64_t(8));
        QCOMPARE(grid.voxelsIn({3, 2, 1}), std::int64_t(1));
    }

    void equalsPlainFloodWhereEveryVoxelIsACell_data()
    {
        QTest::addColumn<int>("number");
        for (int number = 0; number < 40; ++number)
            QTest::addRow("volume %d", number) << number;
    }

    void equalsPlainFloodWhereEveryVoxelIsACell()
    {
        QFETCH(int, number);
        test::Random random(std::uint32_t(900 + number));
        const glm::ivec3 size{test::randomInt(random, 1, 20), test::randomInt(random, 1, 18),
            test::randomInt(random, 1, 16)};
        const Codes codes = test::noiseVolume(size, 100, random);
        const Bytes labels = test::labelBoxes(size, 3, random);
        CoarseRule rule{.lowCode = 20, .highCode = test::randomInt(random, 50, 90)};
        rule.connectivity = std::array{6, 18, 26}[std::size_t(test::randomInt(random, 0, 2))];
        rule.closed.set(2).set(3);
        if (number % 2 == 0) {
            rule.boxFrom = size / 5;
            rule.boxTo = size - 1 - size / 6;
        }
        std::vector<CoarseSeed> seeds;
        for (int i = 0; i < 3; ++i)
            seeds.push_back(seedAt(codes, test::randomVoxel(random, size)));
        const CoarseCodes coarse = sampled(codes, std::int64_t(codes.values.size()));
        QVERIFY(coarse.grid().isExact());
        const auto reach =
            coarseFlood(coarse, {.labels = sampled(labels, coarse.grid())}, seeds, rule);
        QVERIFY(reach);
        const Bytes wanted = plainFlood(codes, labels, seeds, rule);
        QCOMPARE(drawn(codes, coarse.grid(), *reach, rule).values, wanted.values);
        QCOMPARE(reach->voxels, countOf(wanted));
        QVERIFY(std::find(reach->states.begin(), reach->states.end(), CoarseReach::Rim)
            == reach->states.end());
    }

    void coversABallInCells_data()
    {
        QTest::addColumn<int>("cell");
        QTest::newRow("2") << 2;
        QTest::newRow("3") << 3;
        QTest::newRow("4") << 4;
    }

    /// Nearly every voxel, since those of the cells around are told apart by their own codes.
    void coversABallInCells()
    {
        QFETCH(int, cell);
        const Codes codes = ballAt({61, 58, 50}, {31.0, 27.0, 24.0}, 17.0);
        const glm::ivec3 cells = (codes.size + cell - 1) / cell;
        const CoarseCodes coarse = sampled(codes, std::int64_t(cells.x) * cells.y * cells.z);
        QCOMPARE(coarse.grid().cell, glm::ivec3(cell));
        const std::vector<CoarseSeed> seeds{seedAt(codes, {31, 27, 24})};
        const auto reach = coarseFlood(coarse, {}, seeds, tissue);
        QVERIFY(reach);
        const Bytes wanted = plainFlood(codes, {}, seeds, tissue);
        QVERIFY(dice(drawn(codes, coarse.grid(), *reach, tissue), wanted) > 0.99);
        QVERIFY(std::abs(double(reach->voxels) / double(countOf(wanted)) - 1.0) < 0.1);
    }

    /// Another body with the same codes is not taken, nor is one behind a closed label.
    void staysWhereItHangsTogether()
    {
        Codes codes = ballAt({60, 40, 40}, {16.0, 20.0, 20.0}, 11.0);
        const Codes other = ballAt({60, 40, 40}, {43.0, 20.0, 20.0}, 11.0);
        for (std::size_t i = 0; i < codes.values.size(); ++i)
            codes.values[i] = std::max(codes.values[i], other.values[i]);
        const CoarseCodes coarse = sampled(codes, 12000);
        QCOMPARE(coarse.grid().cell, glm::ivec3(2));
        const std::vector<CoarseSeed> seeds{seedAt(codes, {16, 20, 20})};
        const auto apart = coarseFlood(coarse, {}, seeds, tissue);
        QVERIFY(apart);
        QCOMPARE(endAlongX(*apart, coarse.grid()), 28);

        // A bridge joins them, until something that is closed lies in it.
        for (int z = 17; z < 24; ++z)
            for (int y = 17; y < 24; ++y)
                for (int x = 16; x < 43; ++x)
                    codes.at({x, y, z}) = test::tissueCode;
        const CoarseCodes joined = sampled(codes, 12000);
        const auto both = coarseFlood(joined, {}, seeds, tissue);
        QVERIFY(both && endAlongX(*both, joined.grid()) > 50);
        Bytes labels{codes.size, std::vector<std::uint8_t>(codes.values.size())};
        for (int z = 0; z < 40; ++z)
            for (int y = 0; y < 40; ++y)
                for (int x = 28; x < 32; ++x)
                    labels.at({x, y, z}) = 5;
        CoarseRule rule = tissue;
        rule.closed.set(5);
        const auto closed =
            coarseFlood(joined, {.labels = sampled(labels, joined.grid())}, seeds, rule);
        QVERIFY(closed);
        QCOMPARE(endAlongX(*closed, joined.grid()), 28);
        rule.closed.reset();
        rule.boxTo = {24, 39, 39};
        const auto boxed = coarseFlood(joined, {}, seeds, rule);
        QVERIFY(boxed);
        QCOMPARE(endAlongX(*boxed, joined.grid()), 26);
    }

    void doubledCellsHoldWhatTheSingleOnesHold()
    {
        const Codes codes = ballAt({61, 58, 50}, {31.0, 27.0, 24.0}, 17.0);
        const std::vector<CoarseSeed> seeds{seedAt(codes, {31, 27, 24})};
        const CoarseCodes coarse = sampled(codes, 31 * 29 * 25);
        QCOMPARE(coarse.grid().cell, glm::ivec3(2));
        const CoarseReach single = coarseFlood(coarse, {}, seeds, tissue).value();
        CoarseGrid grid = coarse.grid();
        grid.cell *= 2;
        const CoarseReach doubled = inDoubledCells(single);
        const glm::ivec3 size = doubled.cells.maximum - doubled.cells.minimum;
        QCOMPARE(doubled.states.size(), std::size_t(size.x * size.y * size.z));
        QVERIFY(doubled.states.size() < single.states.size() / 5);
        QCOMPARE(doubled.voxels, single.voxels);
        const Bytes wanted = drawn(codes, coarse.grid(), single, tissue);
        QCOMPARE(drawn(codes, grid, doubled, tissue).values, wanted.values);
        const auto reached =
            std::count(doubled.states.begin(), doubled.states.end(), CoarseReach::Reached);
        const double share = 64.0 * double(reached) / double(single.voxels);
        QVERIFY2(share > 0.8 && share < 1.2, qPrintable(QString::number(share)));
        QVERIFY(inDoubledCells({}).states.empty());
    }

    void seedsMustQualify()
    {
        const Codes codes = ballAt({40, 40, 40}, {20.0, 20.0, 20.0}, 9.0);
        const CoarseCodes coarse = sampled(codes, 8000);
        const auto from = [&](const std::vector<glm::ivec3>& voxels) {
            std::vector<CoarseSeed> seeds;
            for (const glm::ivec3& voxel : voxels)
                seeds.push_back(seedAt(codes, voxel));
            return coarseFlood(coarse, {}, seeds, tissue).value();
        };
        const CoarseReach none = from({{2, 2, 2}, {20, 20, 31}});
        QVERIFY(none.cells.empty() && none.states.empty() && none.voxels == 0);
        QVERIFY(from({{2, 2, 2}, {20, 20, 20}}).voxels > 2000);
        // On the border: its cell's middle lies outside the ball, or not.
        for (int x = 26; x < 29; ++x)
            QVERIFY(from({{x, 20, 20}}).voxels > 2000);
    }

    /// As around the seeds of strokes: of the growth, and of who grows with it.
    void codesLieInOneOfTheRanges()
    {
        Codes codes = test::constantVolume({30, 1, 1}, 50);
        for (int x = 10; x < 30; ++x)
            codes.at({x, 0, 0}) = x < 20 ? 60 : 70;
        CoarseRule rule{.lowCode = 40, .highCode = 80};
        std::vector<CoarseSeed> seeds{seedAt(codes, {0, 0, 0})};
        const auto voxels = [&] {
            return coarseFlood(sampled(codes, 30), {}, seeds, rule).value().voxels;
        };
        QCOMPARE(voxels(), std::int64_t(30));
        rule.among = {{.low = 45, .high = 55}, {.low = 60, .high = 60}};
        QCOMPARE(voxels(), std::int64_t(20));
        rule.among->pop_back();
        QCOMPARE(voxels(), std::int64_t(10));
        rule.among->clear();
        QCOMPARE(voxels(), std::int64_t(0));
        rule.among.reset();
        seeds.push_back(seedAt(codes, {29, 0, 0}));
        seeds.back().of = CoarseSeed::Of::RivalAfter;
        rule.rivalsAmong = {{.low = 70, .high = 75}};
        QCOMPARE(voxels(), std::int64_t(20));
        rule.rivalsAmong->front() = {.low = 71, .high = 75};
        QCOMPARE(voxels(), std::int64_t(30));
        const std::vector<std::uint8_t> within =
            codesWithin(rule, std::vector<CodeInterval>{{.low = -5, .high = 41}, {78, 70000}});
        QCOMPARE(within.size(), std::size_t(65536));
        QCOMPARE(std::count(within.begin(), within.end(), std::uint8_t(1)), std::ptrdiff_t(5));
    }

    void canBeCancelled()
    {
        const Codes codes = test::constantVolume({30, 30, 30}, test::tissueCode);
        Progress progress;
        progress.cancel();
        const auto reach =
            coarseFlood(sampled(codes, 1000), {}, {seedAt(codes, {1, 1, 1})}, tissue, progress);
        QVERIFY(!reach && reach.error().code == ErrorCode::Cancelled);
    }
};

BURIN_TEST(CoarseFloodTest)

} // namespace coarseFloodTest

#include "CoarseFloodTest.moc"
