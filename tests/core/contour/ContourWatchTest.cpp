// SPDX-License-Identifier: Apache-2.0
#include "core/contour/ContourWatch.h"

#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace contourWatchTest {

using namespace core;

namespace {

const glm::ivec3 watchedSize(20, 18, 16);

/// A speck in the middle of what is all alike: it grows by a layer with each generation.
ContourGround speck()
{
    const std::size_t voxels =
        std::size_t(watchedSize.x) * std::size_t(watchedSize.y) * std::size_t(watchedSize.z);
    ContourGround ground{.volumeSize = watchedSize,
        .box = {glm::ivec3(0), watchedSize},
        .voxels = std::vector<std::uint8_t>(voxels, ContourGround::open),
        .codes = std::vector<std::uint16_t>(voxels, 100)};
    ground.voxels[std::size_t((8 * watchedSize.y + 9) * watchedSize.x + 10)] |=
        ContourGround::inside;
    return ground;
}

ContourRule outwards()
{
    return {.lowCode = 0,
        .highCode = 200,
        .softness = 10,
        .smoothness = 0,
        .kernel = {.steps = {{{1, 0, 0}, 3}, {{-1, 0, 0}, 3}, {{0, 1, 0}, 3}, {{0, -1, 0}, 3},
                       {{0, 0, 1}, 2}, {{0, 0, -1}, 2}},
            .extent = glm::ivec3(1),
            .total = 16}};
}

/// All that was reported.
struct Watched {
    explicit Watched(const ContourWish& wish)
        : end(watchContour(outwards(), ground, wish, Progress(),
            {.begun =
                    [this](const auto& known, const auto& shown) {
                        ++begun;
                        track = known;
                        state = shown;
                        atBegin = known->known();
                    },
                .further =
                    [this](std::vector<ContourGeneration> generations) {
                        for (ContourGeneration& each : generations)
                            track->append(std::move(each));
                    }}))
    {
    }
    /// Voxels that all generations changed.
    [[nodiscard]] std::size_t changes() const
    {
        std::size_t sum = 0;
        for (const ContourPlaces& each : track->between(0, track->known()))
            sum += each->size();
        return sum;
    }

    int begun = 0;
    int atBegin = -1;
    ContourGround ground = speck();
    std::shared_ptr<ContourTrack> track;
    std::shared_ptr<const ContourState> state;
    ContourEnd end;
};

constexpr double plenty = 1e12;

} // namespace

class ContourWatchTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// First the silent ones together with their state, and then the others.
    void itReports()
    {
        const Watched watched({.generations = 6, .silent = 4, .bytes = plenty});
        QVERIFY(watched.end == ContourEnd::AllGenerations);
        QCOMPARE(watched.begun, 1);
        QCOMPARE(watched.atBegin, 4);
        QCOMPARE(watched.track->shown(), 4);
        QCOMPARE(watched.track->known(), 6);
        QCOMPARE(watched.state->gained(), watched.track->gained());
        QVERIFY(watched.state->gained() > 4);
        ContourState last = *watched.state;
        last.pass(watched.track->between(4, 6));
        watched.track->goTo(6);
        QCOMPARE(last.gained(), watched.track->gained());
        const Watched whole({.generations = 1000, .silent = 0, .bytes = plenty});
        QVERIFY(whole.end == ContourEnd::Rests);
        QCOMPARE(whole.atBegin, 0);
        whole.track->goTo(whole.track->known());
        // It fills the box; one voxel of it was inside at first, but never the segment's.
        QCOMPARE(whole.track->gained(), std::int64_t(whole.ground.voxels.size()));
    }

    /// Of what a generation changed there is one copy, that of the track.
    void changesAreKeptOnce()
    {
        const Watched watched({.generations = 8, .silent = 3, .bytes = plenty});
        for (const ContourPlaces& each : watched.track->between(0, 8))
            QCOMPARE(each.use_count(), 2L); // the track's, and the one that is asked for here
        for (const ContourPlaces& each : watched.track->between(0, 8))
            QCOMPARE(each->capacity(), each->size());
    }

    /// What is allowed ends it, in silence or not; what is known by then is a track like any other.
    void memoryEndsIt_data()
    {
        QTest::addColumn<int>("silent");
        for (const int silent : {0, 5, 30})
            QTest::addRow("%d silent", silent) << silent;
    }
    void memoryEndsIt()
    {
        QFETCH(const int, silent);
        const std::size_t voxels = speck().voxels.size();
        QVERIFY(watchedContourBytes(voxels, 1000) >= watchedContourBytes(voxels, 0) + 4000.0);
        QVERIFY(watchedContourBytes(voxels, 0) >= 9.0 * double(voxels));
        const double bytes = watchedContourBytes(voxels, 1000);
        const Watched watched({.generations = 30, .silent = silent, .bytes = bytes});
        QVERIFY(watched.end == ContourEnd::OutOfMemory);
        QCOMPARE(watched.begun, 1);
        const int known = watched.track->known();
        QVERIFY(known >= 2 && known < 30);
        QCOMPARE(watched.atBegin, std::min(silent, known));
        // The last generation is the first one beyond.
        QVERIFY(watched.changes() > 1000);
        const std::size_t last = watched.track->between(known - 1, known).front()->size();
        QVERIFY(watched.changes() - last <= 1000);
        // The same ones as with plenty of it.
        const Watched other({.generations = known, .silent = 0, .bytes = plenty});
        const auto ways = watched.track->between(0, known);
        const auto others = other.track->between(0, known);
        for (int each = 0; each < known; ++each)
            QVERIFY(*ways[std::size_t(each)] == *others[std::size_t(each)]);
        const Watched none({.generations = 30, .silent = 3, .bytes = 0.0});
        QVERIFY(none.end == ContourEnd::OutOfMemory);
        QCOMPARE(none.track->known(), 0);
    }
};

BURIN_TEST(ContourWatchTest)

} // namespace contourWatchTest

#include "ContourWatchTest.moc"
