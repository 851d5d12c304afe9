// SPDX-License-Identifier: Apache-2.0
#include "core/contour/ContourTrack.h"

#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <random>
#include <vector>

namespace contourTrackTest {

using namespace core;

namespace {

using Sight = std::vector<bool>;

const glm::ivec3 trackSize(15, 14, 12);

/// Noise with a ball in its middle, of which a half was the segment's before; one voxel in nine is
/// held, one in twelve may not change.
ContourGround noisyGround(std::uint32_t seed)
{
    std::mt19937 random(seed);
    ContourGround ground{.volumeSize = trackSize, .box = {glm::ivec3(0), trackSize}};
    for (int z = 0; z < trackSize.z; ++z) {
        for (int y = 0; y < trackSize.y; ++y) {
            for (int x = 0; x < trackSize.x; ++x) {
                const glm::ivec3 step = glm::ivec3(x, y, z) - trackSize / 2;
                std::uint8_t flags = 0;
                if (step.x * step.x + step.y * step.y + step.z * step.z <= 9)
                    flags = ContourGround::open | ContourGround::inside
                        | (x < trackSize.x / 2 ? ContourGround::own : 0);
                else if (random() % 12 > 0)
                    flags = ContourGround::open;
                if (random() % 9 == 0)
                    flags |= ContourGround::held;
                ground.voxels.push_back(flags);
                ground.codes.push_back(std::uint16_t(random() % 300));
            }
        }
    }
    return ground;
}

template <class Visit> void visitAll(Visit&& visit)
{
    std::size_t place = 0;
    for (int z = 0; z < trackSize.z; ++z) {
        for (int y = 0; y < trackSize.y; ++y) {
            for (int x = 0; x < trackSize.x; ++x)
                visit(glm::ivec3(x, y, z), place++);
        }
    }
}

/// As it would be written: what is held stays as it was.
Sight writtenOf(const ContourEvolution& evolution, const ContourGround& start)
{
    Sight sight(start.voxels.size(), false);
    visitAll([&](const glm::ivec3& voxel, std::size_t place) {
        sight[place] = start.voxels[place] & ContourGround::held
            ? (start.voxels[place] & ContourGround::own) != 0
            : evolution.isInside(voxel);
    });
    return sight;
}

Sight shownBy(const ContourState& state)
{
    Sight sight(std::size_t(trackSize.x) * std::size_t(trackSize.y) * std::size_t(trackSize.z));
    visitAll(
        [&](const glm::ivec3& voxel, std::size_t place) { sight[place] = state.isInside(voxel); });
    return sight;
}

} // namespace

class ContourTrackTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Every generation, in any order, is what the evolution came to, with the counts of voxels.
    void everyGenerationIsShown_data()
    {
        QTest::addColumn<uint>("seed");
        for (const uint seed : {1U, 2U, 3U})
            QTest::addRow("seed %u", seed) << seed;
    }
    void everyGenerationIsShown()
    {
        QFETCH(const uint, seed);
        const ContourGround start = noisyGround(seed);
        const ContourRule rule{.lowCode = 0,
            .highCode = 210,
            .softness = 40,
            .smoothness = 40,
            .kernel = {.steps = {{{1, 0, 0}, 3}, {{-1, 0, 0}, 3}, {{0, 1, 0}, 3}, {{0, -1, 0}, 3},
                           {{0, 0, 1}, 2}, {{0, 0, -1}, 2}},
                .extent = glm::ivec3(1),
                .total = 16}};
        ContourEvolution evolution(rule, start);
        const ContourState first(start.box, start.voxels);
        ContourState last = first;
        ContourTrack track(first);
        std::vector<Sight> states{writtenOf(evolution, start)};
        while (evolution.generation() < 6 && evolution.step(Progress())) {
            QCOMPARE(evolution.lastChanged()->size(), evolution.lastChanges());
            last.pass(*evolution.lastChanged());
            track.append(
                {.changed = evolution.lastChanged(), .gained = last.gained(), .lost = last.lost()});
            // The same, not a copy.
            QVERIFY(track.between(track.known() - 1, track.known())
                == std::vector<ContourPlaces>{evolution.lastChanged()});
            states.push_back(writtenOf(evolution, start));
            QCOMPARE(track.shown(), 0); // it goes only where it is told to
        }
        QVERIFY(track.known() >= 3);
        QVERIFY(states.front() != states.back());
        std::mt19937 random(seed);
        ContourState walked = first;
        for (int walk = 0; walk < 20; ++walk) {
            const int generation = int(random() % std::uint32_t(track.known() + 1));
            walked.pass(track.between(track.shown(), generation));
            track.goTo(generation);
            QCOMPARE(track.shown(), generation);
            const Sight& state = states[std::size_t(generation)];
            QVERIFY(shownBy(walked) == state);
            std::int64_t gained = 0;
            std::int64_t lost = 0;
            visitAll([&](const glm::ivec3& voxel, std::size_t place) {
                const bool was = start.voxels[place] & ContourGround::own;
                QCOMPARE(walked.wasInside(voxel), was);
                gained += state[place] && !was ? 1 : 0;
                lost += was && !state[place] ? 1 : 0;
            });
            QCOMPARE(track.gained(), gained);
            QCOMPARE(track.lost(), lost);
            QCOMPARE(walked.gained(), gained);
            QCOMPARE(walked.lost(), lost);
        }
    }
};

BURIN_TEST(ContourTrackTest)

} // namespace contourTrackTest

#include "ContourTrackTest.moc"
