// SPDX-License-Identifier: Apache-2.0
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/EngineConformance.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace referenceSmoothingTest {

using namespace core;
using reference::ReferenceEngine;
using test::Bytes;
using test::Codes;

namespace {

template <class Visit> void forEachVoxel(const glm::ivec3& from, const glm::ivec3& to, Visit visit)
{
    for (int z = from.z; z <= to.z; ++z)
        for (int y = from.y; y <= to.y; ++y)
            for (int x = from.x; x <= to.x; ++x)
                visit(glm::ivec3(x, y, z));
}

void fill(Codes& codes, const glm::ivec3& from, const glm::ivec3& to, std::uint16_t code)
{
    forEachVoxel(from, to, [&](const glm::ivec3& voxel) { codes.at(voxel) = code; });
}

/// The labels after a growth from one seed to closure over faces; 1 is what has grown.
Bytes grown(const Codes& codes, const glm::ivec3& seed, int low, int high, GrowLimits limits)
{
    ReferenceEngine engine;
    if (!engine.openVolume(codes.size, codes.values))
        qFatal("no volume");
    submitWhole(engine, SeedPlacement{.label = 1, .voxels = {seed}});
    submitWhole(engine, GrowBurst{.lowCode = low, .highCode = high, .limits = limits},
        {GrowAdvance{.steps = GrowAdvance::toClosure}});
    reference::DenseFields fields = engine.fields();
    return fields.labels(0);
}

int count(const Bytes& labels)
{
    return int(std::count(labels.values.begin(), labels.values.end(), 1));
}

/// Whether the weighted median around a voxel lies in an interval, by what lies on either side: not
/// by sorting, as the oracle does.
bool isMedianIn(const Codes& codes, const glm::ivec3& voxel, int low, int high)
{
    int below = 0;
    int above = 0;
    forEachVoxel(voxel - 1, voxel + 1, [&](const glm::ivec3& near) {
        const glm::ivec3 aside = glm::abs(near - voxel);
        // 2 for each axis on which it does not lie aside, and the voxel itself one more.
        const int weight = (8 >> (aside.x + aside.y + aside.z)) + (near == voxel ? 1 : 0);
        const int code = codes.at(glm::clamp(near, glm::ivec3(0), codes.size - 1));
        below += code < low ? weight : 0;
        above += code > high ? weight : 0;
    });
    return below <= 32 && above <= 32;
}

/// What hangs together with a seed over faces by voxels that qualify: 1.
template <class Qualifies> Bytes flooded(const Codes& codes, const glm::ivec3& seed, Qualifies is)
{
    Bytes reached{codes.size, std::vector<std::uint8_t>(codes.values.size(), 0)};
    std::vector<glm::ivec3> open;
    const auto reach = [&](const glm::ivec3& voxel) {
        if (!codes.contains(voxel) || reached.at(voxel) != 0 || !is(voxel))
            return;
        reached.at(voxel) = 1;
        open.push_back(voxel);
    };
    reach(seed);
    while (!open.empty()) {
        const glm::ivec3 voxel = open.back();
        open.pop_back();
        for (int axis = 0; axis < 3; ++axis) {
            glm::ivec3 step(0);
            step[axis] = 1;
            reach(voxel + step);
            reach(voxel - step);
        }
    }
    return reached;
}

/// Noise around 600 with a deviation of 101, nearly normal: σ of twelve even draws is 29.15 · √12.
std::uint16_t noisy(test::Random& random)
{
    int sum = 0;
    for (int draw = 0; draw < 12; ++draw)
        sum += test::randomInt(random, 0, 100);
    return std::uint16_t(sum);
}

} // namespace

/// Growth that compares medians with its interval (GrowLimits::smoothed).
class ReferenceSmoothingTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// A cube of 12³ voxels in which single voxels are too low or too high. All are filled, and of
    /// the cube only its eight corners are lost: 28 of 65 lie in it around them.
    void holesAreFilledAndFacesAndEdgesStay()
    {
        Codes codes = test::constantVolume({20, 19, 18}, 0);
        const glm::ivec3 from(4, 4, 3);
        fill(codes, from, from + 11, 1000);
        int holes = 0;
        for (const int z : {2, 5, 8})
            for (const int y : {2, 5, 8})
                for (const int x : {2, 5, 8})
                    codes.at(from + glm::ivec3(x, y, z)) = ++holes % 2 ? 0 : 65535;
        const glm::ivec3 seed = from + 6;
        QCOMPARE(count(grown(codes, seed, 900, 1100, {})), 12 * 12 * 12 - holes);
        QCOMPARE(count(grown(codes, seed, 900, 1100, {.smoothed = true})), 12 * 12 * 12 - 8);
        // A seed may lie on what was a hole.
        QCOMPARE(count(grown(codes, from + 5, 900, 1100, {})), 0);
        QCOMPARE(count(grown(codes, from + 5, 900, 1100, {.smoothed = true})), 12 * 12 * 12 - 8);
        // A majority counts the voxels' own values: around a voxel inside at most one of the 27 is
        // a hole, around one of a face nine lie beside the cube.
        QCOMPARE(
            count(grown(codes, seed, 900, 1100, {.majority = 26, .smoothed = true})), 10 * 10 * 10);
    }

    /// A sheet one voxel thick holds 33 of 65.
    void aWallOfOneVoxelIsAWallAndASegment()
    {
        Codes wall = test::constantVolume({9, 5, 5}, 100);
        fill(wall, {5, 0, 0}, {5, 4, 4}, 0);
        const GrowLimits smoothed{.smoothed = true};
        QCOMPARE(count(grown(wall, {0, 2, 2}, 1, 65535, smoothed)), 5 * 25);
        QCOMPARE(count(grown(wall, {5, 2, 2}, 0, 0, smoothed)), 25);
    }

    /// A thread holds 17 of 65 and is not followed; a bar two voxels thick holds 37 at least.
    void aThreadIsNotFollowed()
    {
        Codes codes = test::constantVolume({24, 9, 9}, 0);
        fill(codes, {0, 0, 0}, {7, 8, 8}, 100);
        fill(codes, {16, 0, 0}, {23, 8, 8}, 100);
        fill(codes, {8, 4, 4}, {15, 4, 4}, 100);
        const int block = 8 * 81;
        QCOMPARE(count(grown(codes, {2, 4, 4}, 50, 150, {})), 2 * block + 8);
        QCOMPARE(count(grown(codes, {2, 4, 4}, 50, 150, {.smoothed = true})), block);
        fill(codes, {8, 4, 4}, {15, 5, 5}, 100);
        QCOMPARE(count(grown(codes, {2, 4, 4}, 50, 150, {.smoothed = true})), 2 * block + 32);
    }

    /// Beyond the volume the nearest voxels are repeated.
    void cornersOfTheVolumeAreFilledToo()
    {
        Codes codes = test::constantVolume({6, 6, 6}, 65535);
        for (const glm::ivec3& hole :
            {glm::ivec3(0, 0, 0), glm::ivec3(5, 0, 3), glm::ivec3(3, 5, 3), glm::ivec3(5, 5, 5)})
            codes.at(hole) = 0;
        QCOMPARE(count(grown(codes, {2, 2, 2}, 65535, 65535, {})), 216 - 4);
        QCOMPARE(count(grown(codes, {2, 2, 2}, 65535, 65535, {.smoothed = true})), 216);
        QCOMPARE(count(grown(codes, {0, 0, 0}, 0, 0, {})), 1);
        QCOMPARE(count(grown(codes, {0, 0, 0}, 0, 0, {.smoothed = true})), 0);
    }

    /// At two standard deviations one voxel in 22 is out; of the medians inside of the ball none
    /// is, and its border stays within a voxel of where it was.
    void aBallInNoiseHasNoHoles()
    {
        constexpr int side = 30;
        constexpr int low = 600 - 202;
        constexpr int high = 600 + 202;
        test::Random random(1917);
        const glm::ivec3 centre(15, 14, 15);
        const auto distance = [&](const glm::ivec3& voxel) {
            return glm::length(glm::dvec3(voxel - centre));
        };
        Codes codes = test::constantVolume(glm::ivec3(side), 0);
        int ball = 0;
        forEachVoxel(glm::ivec3(0), glm::ivec3(side - 1), [&](const glm::ivec3& voxel) {
            const bool isIn = distance(voxel) <= 12.0;
            ball += isIn ? 1 : 0;
            codes.at(voxel) = std::uint16_t(noisy(random) + (isIn ? 0 : 2000));
        });
        fill(codes, centre, centre, 600);
        const Bytes plain = grown(codes, centre, low, high, {});
        const Bytes smoothed = grown(codes, centre, low, high, {.smoothed = true});
        QVERIFY(plain.values == flooded(codes, centre, [&](const glm::ivec3& voxel) {
            return codes.at(voxel) >= low && codes.at(voxel) <= high;
        }).values);
        QVERIFY(smoothed.values == flooded(codes, centre, [&](const glm::ivec3& voxel) {
            return isMedianIn(codes, voxel, low, high);
        }).values);

        const auto holes = [&](const Bytes& labels, double within) {
            int missing = 0;
            forEachVoxel(glm::ivec3(0), glm::ivec3(side - 1), [&](const glm::ivec3& voxel) {
                missing += distance(voxel) <= within && labels.at(voxel) == 0 ? 1 : 0;
            });
            return missing;
        };
        // 4.6 % of 5 575 and of 7 153 voxels, give or take six deviations.
        QVERIFY2(holes(plain, 11.0) > 160, qPrintable(QString::number(holes(plain, 11.0))));
        QCOMPARE(holes(smoothed, 10.2), 0); // all 27 lie in the ball
        QVERIFY2(holes(smoothed, 12.0) * 2 < holes(plain, 12.0),
            qPrintable(QStringLiteral("%1, and %2 without")
                           .arg(holes(smoothed, 12.0))
                           .arg(holes(plain, 12.0))));
        // Nothing outside of the ball joins.
        QCOMPARE(count(smoothed), ball - holes(smoothed, 12.0));
    }

    /// The statistics of seeds are those of the voxels' own values; medians are held against them.
    void seedsNarrowTheIntervalOfMedians()
    {
        test::Random random(23);
        Codes codes = test::constantVolume({24, 24, 24}, 0);
        for (std::uint16_t& code : codes.values)
            code = noisy(random);
        const glm::ivec3 seed(12, 12, 12);
        fill(codes, seed, seed, 600);
        const GrowLimits plain{.sigmas256 = 512};
        const GrowLimits smoothed{.smoothed = true, .sigmas256 = 512};
        const int without = count(grown(codes, seed, 0, 65535, plain));
        const int with = count(grown(codes, seed, 0, 65535, smoothed));
        const int all = 24 * 24 * 24;
        QVERIFY2(all - without > all / 50, qPrintable(QString::number(without)));
        QVERIFY2((all - with) * 20 < all - without, qPrintable(QString::number(with)));
    }
};

BURIN_TEST(ReferenceSmoothingTest)

} // namespace referenceSmoothingTest

#include "ReferenceSmoothingTest.moc"
