// SPDX-License-Identifier: Apache-2.0
#include "core/growth/SeedWord.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/EngineConformance.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

#include <algorithm>
#include <array>

namespace referenceSpreadTest {

using namespace core;

namespace {

constexpr std::uint64_t never = ~std::uint64_t(0);

/// The rule as it is written, with nothing clever: every voxel takes the least that a neighbour
/// offers, over and over, until none changes. Seeds are voxels of the labels in `seeds`.
std::vector<std::uint8_t> spreadLiterally(
    const test::Codes& codes, const std::vector<std::uint8_t>& held, const SpreadLabels& spread)
{
    // cost · 256 + label: the least is the least (cost, label).
    std::vector<std::uint64_t> words(held.size(), never);
    for (std::size_t at = 0; at < held.size(); ++at) {
        if (spread.seeds[held[at]])
            words[at] = held[at];
    }
    for (bool changed = true; changed;) {
        changed = false;
        for (int z = 0; z < codes.size.z; ++z) {
            for (int y = 0; y < codes.size.y; ++y) {
                for (int x = 0; x < codes.size.x; ++x) {
                    const std::size_t at = codes.offset({x, y, z});
                    if (held[at] != 0 && !spread.overwritable[held[at]])
                        continue;
                    for (std::size_t way = 0; way < std::size_t(spread.connectivity); ++way) {
                        const auto& step = seedWord::offsets[way];
                        const glm::ivec3 from(x - step[0], y - step[1], z - step[2]);
                        if (!codes.contains(from) || words[codes.offset(from)] == never)
                            continue;
                        const std::size_t there = codes.offset(from);
                        const std::uint64_t cost = (words[there] >> 8)
                            + std::uint64_t(
                                  std::abs(int(codes.values[at]) - int(codes.values[there])))
                                * spread.differenceWeight
                            + spread.lengths[way / 2];
                        const std::uint64_t offer = cost << 8 | (words[there] & 0xFFu);
                        if (cost < SpreadLabels::maxCost && offer < words[at]) {
                            words[at] = offer;
                            changed = true;
                        }
                    }
                }
            }
        }
    }
    std::vector<std::uint8_t> labels = held;
    for (std::size_t at = 0; at < held.size(); ++at) {
        if (words[at] != never)
            labels[at] = std::uint8_t(words[at] & 0xFFu);
    }
    return labels;
}

} // namespace

/// The oracle of growing from seeds against its rule, and against what one knows beforehand.
class ReferenceSpreadTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void followsTheRule()
    {
        for (int number = 0; number < 40; ++number) {
            test::Random random(std::uint32_t(77000 + number));
            const glm::ivec3 size{test::randomInt(random, 2, 14), test::randomInt(random, 1, 12),
                test::randomInt(random, 1, 12)};
            const test::Codes codes = test::noiseVolume(size, number % 2 ? 40 : 65535, random);
            test::Bytes held{size, std::vector<std::uint8_t>(codes.values.size(), 0)};
            for (std::uint8_t& label : held.values)
                label = random() % 12 ? std::uint8_t(0) : std::uint8_t(random() % 5);
            held.values.front() = 1;
            held.values.back() = 2;
            SpreadLabels spread;
            spread.seeds.set(1).set(2).set(4);
            spread.overwritable[3] = number % 3;
            spread.connectivity = std::array<int, 3>{6, 18, 26}[std::size_t(number) % 3];
            spread.differenceWeight = std::uint32_t(number % 5 ? 4 : 64);
            for (std::uint32_t& length : spread.lengths)
                length = std::uint32_t(test::randomInt(random, 1, 20));
            spread.box = VoxelBox{glm::ivec3(0), size};

            reference::ReferenceEngine oracle;
            QVERIFY(oracle.openVolume(size, codes.values));
            oracle.submit(SwapBricks{test::bricksOf(held, Field::Labels, 0)});
            submitWhole(oracle, spread);
            QVERIFY(!test::lastResult(oracle).error);
            reference::DenseFields fields = oracle.fields();
            QVERIFY2(fields.labels(0).values == spreadLiterally(codes, held.values, spread),
                qPrintable(QString::number(number)));
        }
    }

    /// On even ground the border lies half-way; a voxel as near to both goes to the lower label.
    void halfWayOnEvenGround()
    {
        const test::Codes codes = test::constantVolume({9, 1, 1}, 500);
        test::Bytes held{codes.size, std::vector<std::uint8_t>(9, 0)};
        held.at({0, 0, 0}) = 8;
        held.at({8, 0, 0}) = 5;
        SpreadLabels spread;
        spread.seeds.set(5).set(8);
        spread.lengths.fill(3);
        reference::ReferenceEngine oracle;
        QVERIFY(oracle.openVolume(codes.size, codes.values));
        oracle.submit(SwapBricks{test::bricksOf(held, Field::Labels, 0)});
        submitWhole(oracle, spread);
        reference::DenseFields fields = oracle.fields();
        const std::vector<std::uint8_t> expected{8, 8, 8, 8, 5, 5, 5, 5, 5};
        QVERIFY(fields.labels(0).values == expected);
    }

    /// The border lies on the edge between two values, wherever the seeds are.
    void edgesDivide()
    {
        const glm::ivec3 size(30, 7, 7);
        const test::Codes codes = test::slab(size, 0, 20, 29);
        test::Bytes held{size, std::vector<std::uint8_t>(codes.values.size(), 0)};
        held.at({19, 3, 3}) = 1;
        held.at({29, 6, 6}) = 2;
        SpreadLabels spread;
        spread.seeds.set(1).set(2);
        spread.lengths.fill(1);
        spread.box = VoxelBox{glm::ivec3(0), size};
        reference::ReferenceEngine oracle;
        QVERIFY(oracle.openVolume(size, codes.values));
        oracle.submit(SwapBricks{test::bricksOf(held, Field::Labels, 0)});
        submitWhole(oracle, spread);
        reference::DenseFields fields = oracle.fields();
        for (int x = 0; x < size.x; ++x)
            QCOMPARE(int(fields.labels(0).at({x, 2, 5})), x < 20 ? 1 : 2);
    }

    void theBoxIsAroundTheSeeds()
    {
        const glm::ivec3 size(200, 60, 50);
        const SpreadLabels spread;
        const VoxelBox box = spreadBox(spread, {{20, 30, 40}, {141, 32, 50}}, size);
        QVERIFY(box.minimum == glm::ivec3(20 - 7, 27, 37)); // 121 voxels: a twentieth, rounded up
        QVERIFY(box.maximum == glm::ivec3(141 + 7, 35, 50));
    }
};

BURIN_TEST(ReferenceSpreadTest)

} // namespace referenceSpreadTest

#include "ReferenceSpreadTest.moc"
