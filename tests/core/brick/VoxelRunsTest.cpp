// SPDX-License-Identifier: Apache-2.0
#include "core/brick/VoxelRunSets.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <iterator>
#include <random>
#include <set>

namespace voxelRunsTest {

using core::VoxelRuns;

namespace {

constexpr std::uint64_t voxels = 3000;

using Places = std::set<std::uint64_t>;

Places randomPlaces(std::mt19937& random)
{
    Places places;
    const unsigned runs = random() % 40;
    for (unsigned run = 0; run < runs; ++run) {
        const std::uint64_t first = random() % voxels;
        for (std::uint64_t at = first; at < std::min(voxels, first + random() % 200); ++at)
            places.insert(at);
    }
    return places;
}

VoxelRuns runsOf(const Places& places)
{
    VoxelRuns runs;
    for (const std::uint64_t place : places)
        runs.append(place, 1);
    return runs;
}

Places placesOf(const VoxelRuns& runs)
{
    Places places;
    for (const core::VoxelRun& run : runs.runs()) {
        for (std::uint64_t at = 0; at < run.count; ++at)
            places.insert(run.first + at);
    }
    return places;
}

} // namespace

class VoxelRunsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void setsOfPlaces()
    {
        std::mt19937 random(1);
        for (int round = 0; round < 300; ++round) {
            const Places one = randomPlaces(random);
            const Places other = randomPlaces(random);
            const VoxelRuns runs = runsOf(one);
            QCOMPARE(runs.voxelCount(), std::uint64_t(one.size()));
            QCOMPARE(placesOf(runs), one);
            for (std::size_t i = 1; i < runs.runs().size(); ++i)
                QVERIFY(runs.runs()[i - 1].first + runs.runs()[i - 1].count < runs.runs()[i].first);

            Places both = one;
            both.insert(other.begin(), other.end());
            const VoxelRuns all = core::united(runs, runsOf(other));
            QCOMPARE(all, runsOf(both));
            QCOMPARE(core::sharedVoxels(runs, runsOf(other)),
                std::uint64_t(one.size() + other.size() - both.size()));

            Places inOne;
            std::set_symmetric_difference(one.begin(), one.end(), other.begin(), other.end(),
                std::inserter(inOne, inOne.end()));
            QCOMPARE(core::differing(runs, runsOf(other)), runsOf(inOne));
            Places shared;
            std::set_intersection(one.begin(), one.end(), other.begin(), other.end(),
                std::inserter(shared, shared.end()));
            QCOMPARE(core::common(runs, runsOf(other)), runsOf(shared));
            QVERIFY(core::differing(runs, runs).empty());

            const std::optional<VoxelRuns> again =
                core::unpackedRuns(core::packedRuns(runs), voxels);
            QVERIFY(again);
            QCOMPARE(*again, runs);
        }
    }

    void placesBeyondTheVolume()
    {
        VoxelRuns runs;
        runs.append(10, 5);
        runs.append(voxels - 3, 3);
        QVERIFY(core::unpackedRuns(core::packedRuns(runs), voxels));
        QVERIFY(!core::unpackedRuns(core::packedRuns(runs), voxels - 1));
        VoxelRuns far;
        far.append(std::uint64_t(1) << 62, std::uint64_t(1) << 62);
        QVERIFY(core::unpackedRuns(core::packedRuns(far), std::uint64_t(1) << 63));
        QVERIFY(!core::unpackedRuns(core::packedRuns(far), voxels));
    }

    /// Whatever the bytes are, an answer comes; and where one does, it is sound.
    void damagedBytes()
    {
        std::mt19937 random(2);
        const QByteArray sound = core::packedRuns(runsOf(randomPlaces(random)));
        QVERIFY(!core::unpackedRuns({}, voxels));
        int refused = 0;
        for (int round = 0; round < 2000; ++round) {
            QByteArray bytes = sound;
            if (round % 4 == 0)
                bytes.truncate(qsizetype(random() % unsigned(bytes.size())));
            else
                bytes[qsizetype(random() % unsigned(bytes.size()))] = char(random());
            const std::optional<VoxelRuns> runs = core::unpackedRuns(bytes, voxels);
            refused += runs ? 0 : 1;
            QVERIFY(!runs || runs->end() <= voxels);
        }
        QVERIFY(refused > 500);
    }
};

BURIN_TEST(VoxelRunsTest)

} // namespace voxelRunsTest

#include "VoxelRunsTest.moc"
