// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/ChunkTree.h"

#include "core/chunks/BoxWalk.h"
#include "tests/support/program/TestProgram.h"

#include <QElapsedTimer>
#include <QTest>

#include <algorithm>
#include <functional>
#include <map>
#include <random>
#include <set>

namespace chunkTreeTest {

namespace {

using core::ChunkSource;
using core::ChunkTree;

constexpr std::uint8_t outside = ChunkSource::outside;

/// A box that is filled voxel by voxel.
struct Box {
    glm::ivec3 size{0};
    std::vector<std::uint16_t> codes;
    std::vector<std::uint8_t> owners;

    Box(const glm::ivec3& sides, const std::function<std::uint8_t(const glm::dvec3&)>& ownerAt,
        const std::function<int(const glm::dvec3&)>& codeAt)
        : size(sides)
    {
        const core::BoxWalk walk(sides);
        for (std::size_t voxel = 0; voxel < walk.voxels(); ++voxel) {
            const glm::dvec3 place(walk.placeOf(voxel));
            owners.push_back(ownerAt(place));
            codes.push_back(std::uint16_t(codeAt(place)));
        }
    }
    [[nodiscard]] ChunkSource source() const
    {
        return {.size = size, .codes = codes, .owners = owners};
    }
    [[nodiscard]] std::size_t at(int x, int y, int z) const
    {
        return std::size_t((z * size.y + y) * size.x + x);
    }
};

ChunkTree divided(const Box& box)
{
    auto tree = ChunkTree::of(box.source(), {});
    if (!tree)
        qFatal("not divided");
    return std::move(*tree);
}

class Noise {
public:
    explicit Noise(std::uint32_t seed)
        : m_random(seed)
    {
    }
    int operator()(int most) { return int(m_random() % std::uint32_t(2 * most + 1)) - most; }

private:
    std::mt19937 m_random;
};

bool inBall(const glm::dvec3& place, const glm::dvec3& centre, double radius)
{
    return glm::length(place - centre) <= radius;
}

/// Which share of one set of voxels the voxels of a chunk are, and of the chunk the set.
double overlap(const ChunkTree& tree, ChunkTree::Chunk chunk,
    const std::function<bool(std::size_t)>& inSet, std::size_t setSize)
{
    const auto voxels = tree.voxels(chunk);
    const auto shared = std::count_if(voxels.begin(), voxels.end(), inSet);
    return 2.0 * double(shared) / double(voxels.size() + setSize);
}

/// Whether chunks of a division are what they are said to be.
void checkDivision(const ChunkTree& tree, const Box& box, int count)
{
    const auto chunks = tree.division(count);
    QCOMPARE(int(chunks.size()), count);
    std::vector<int> seen(box.owners.size(), 0);
    for (const ChunkTree::Chunk chunk : chunks) {
        QVERIFY(!tree.voxels(chunk).empty());
        for (const std::uint32_t voxel : tree.voxels(chunk)) {
            ++seen[voxel];
            QCOMPARE(box.owners[voxel], tree.owner(chunk));
            QCOMPARE(tree.chunkAt(voxel, count), std::optional(chunk));
        }
    }
    for (std::size_t voxel = 0; voxel < seen.size(); ++voxel)
        QCOMPARE(seen[voxel], box.owners[voxel] == outside ? 0 : 1);
}

/// Each chunk hangs together by faces.
void checkConnected(const ChunkTree& tree, const Box& box, int count)
{
    const core::BoxWalk walk(box.size);
    for (const ChunkTree::Chunk chunk : tree.division(count)) {
        const auto voxels = tree.voxels(chunk);
        std::set<std::size_t> left(voxels.begin(), voxels.end());
        std::vector<std::size_t> front{*left.begin()};
        left.erase(left.begin());
        while (!front.empty()) {
            const std::size_t voxel = front.back();
            front.pop_back();
            walk.forEachNeighbour(voxel, [&](std::size_t neighbour) {
                if (left.erase(neighbour) > 0)
                    front.push_back(neighbour);
            });
        }
        QVERIFY(left.empty());
    }
}

} // namespace

class ChunkTreeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// Random boxes: every voxel is in one chunk of each division, of its owner, in one part, and
    /// finer divisions divide coarser ones.
    void divisionsHold_data()
    {
        QTest::addColumn<int>("seed");
        for (int seed = 0; seed < 12; ++seed)
            QTest::addRow("random %d", seed) << seed;
    }
    void divisionsHold()
    {
        QFETCH(int, seed);
        std::mt19937 random{std::uint32_t(seed)};
        const auto below = [&random](int most) { return int(random() % std::uint32_t(most)); };
        const glm::ivec3 size(1 + below(23), 1 + below(23), 1 + below(23));
        const glm::dvec3 centre(below(size.x), below(size.y), below(size.z));
        const double radius = 2 + below(12);
        Noise noise{std::uint32_t(seed)};
        const Box box(
            size,
            [&](const glm::dvec3& place) {
                return std::uint8_t(below(9) == 0       ? outside
                        : inBall(place, centre, radius) ? 1 + below(2) / 2
                                                        : 0);
            },
            [&](const glm::dvec3& place) {
                return 1000 + int(place.x) * 20 + noise(seed % 2 == 0 ? 10 : 900);
            });
        const ChunkTree tree = divided(box);
        for (const int count :
            {tree.fewest(), (tree.fewest() + tree.finest()) / 2, tree.finest()}) {
            checkDivision(tree, box, count);
            checkConnected(tree, box, count);
        }
        const int half = (tree.fewest() + tree.finest()) / 2;
        for (const ChunkTree::Chunk chunk : tree.division(tree.finest())) {
            std::set<ChunkTree::Chunk> coarse;
            for (const std::uint32_t voxel : tree.voxels(chunk))
                coarse.insert(*tree.chunkAt(voxel, half));
            QCOMPARE(coarse.size(), std::size_t(1));
        }
        const ChunkTree again = divided(box);
        for (std::size_t voxel = 0; voxel < box.owners.size(); ++voxel)
            QCOMPARE(again.chunkAt(voxel, half), tree.chunkAt(voxel, half));
    }

    /// A leak through a neck, of the same values as the organ: one chunk at a division that a user
    /// would look through.
    void aLeakOfEqualValues()
    {
        const glm::dvec3 organ(30, 30, 30);
        const glm::dvec3 leak(66, 30, 30);
        Noise noise(5);
        const Box box(
            {86, 60, 60},
            [&](const glm::dvec3& place) {
                const bool neck = place.x > 30 && place.x < 66
                    && glm::length(glm::dvec2(place.y, place.z) - glm::dvec2(30)) <= 3.0;
                return std::uint8_t(inBall(place, organ, 22) || inBall(place, leak, 12) || neck);
            },
            [&](const glm::dvec3&) { return 2000 + noise(30); });
        const ChunkTree tree = divided(box);
        const auto inLeak = [&](std::size_t voxel) {
            const glm::dvec3 place(core::BoxWalk(box.size).placeOf(voxel));
            return box.owners[voxel] == 1 && place.x > 54;
        };
        std::size_t leakSize = 0;
        for (std::size_t voxel = 0; voxel < box.owners.size(); ++voxel)
            leakSize += inLeak(voxel) ? 1 : 0;
        const auto chunk = tree.chunkAt(box.at(66, 30, 30), tree.fewest() + 6);
        QVERIFY(chunk.has_value());
        QVERIFY2(overlap(tree, *chunk, inLeak, leakSize) > 0.95,
            qPrintable(QString::number(overlap(tree, *chunk, inLeak, leakSize))));
    }

    /// A neighbour of other values that the mask took in: by its values, though it is wide, and it
    /// does not look likely.
    void aNeighbourOfOtherValues()
    {
        const glm::dvec3 organ(30, 30, 30);
        const glm::dvec3 other(52, 30, 30);
        Noise noise(7);
        const auto isOther = [&](const glm::dvec3& place) {
            return inBall(place, other, 14) && !inBall(place, organ, 20);
        };
        const Box box(
            {76, 60, 60},
            [&](const glm::dvec3& place) {
                return std::uint8_t(inBall(place, organ, 20) || isOther(place));
            },
            [&](const glm::dvec3& place) {
                return (isOther(place) ? 2150 : inBall(place, organ, 20) ? 2000 : 1000) + noise(40);
            });
        const ChunkTree tree = divided(box);
        const core::BoxWalk walk(box.size);
        const auto inOther = [&](std::size_t voxel) {
            return isOther(glm::dvec3(walk.placeOf(voxel)));
        };
        std::size_t otherSize = 0;
        for (std::size_t voxel = 0; voxel < box.owners.size(); ++voxel)
            otherSize += inOther(voxel) ? 1 : 0;
        const auto chunk = tree.chunkAt(box.at(58, 30, 30), tree.fewest() + 6);
        QVERIFY(chunk.has_value());
        QVERIFY2(overlap(tree, *chunk, inOther, otherSize) > 0.95,
            qPrintable(QString::number(overlap(tree, *chunk, inOther, otherSize))));
        const auto home = tree.chunkAt(box.at(30, 30, 30), tree.fewest() + 6);
        QVERIFY(tree.likelihood(*home) > tree.likelihood(*chunk));
    }

    void theFinestIsBounded()
    {
        std::mt19937 random(3);
        const Box box(
            {80, 80, 80}, [](const glm::dvec3&) { return std::uint8_t(0); },
            [&](const glm::dvec3&) { return int(random() % 4000U); });
        QElapsedTimer timer;
        timer.start();
        const ChunkTree tree = divided(box);
        qInfo("512 000 voxels of noise: %lld ms", timer.elapsed());
        QCOMPARE(tree.finest(), ChunkTree::mostChunks);
        QCOMPARE(tree.fewest(), 1);
        checkDivision(tree, box, 10);
    }

    /// The work tells how far it is, never less than before in a step, and is given up at any one.
    void tellsHowFarItIs()
    {
        std::mt19937 random(4);
        const Box box(
            {60, 60, 60}, [](const glm::dvec3& at) { return std::uint8_t(at.x < 30 ? 0 : 1); },
            [&](const glm::dvec3&) { return int(random() % 4000U); });
        std::vector<core::ProgressStep> steps;
        double last = 0.0;
        bool grows = true;
        int reports = 0;
        const auto watch = [&](core::ProgressStep step, int done, int total) {
            ++reports;
            const double now = double(done) / total;
            if (steps.empty() || steps.back() != step) {
                steps.push_back(step);
                last = 0.0;
            }
            grows = grows && now >= last && now <= 1.0;
            last = now;
        };
        const core::Progress watched(watch);
        QVERIFY(ChunkTree::of(box.source(), watched));
        QCOMPARE(steps,
            (std::vector{core::ProgressStep::FindingLikelyParts,
                core::ProgressStep::CuttingIntoPieces, core::ProgressStep::JoiningParts}));
        QVERIFY(grows);
        QVERIFY(reports > 60);
        for (const core::ProgressStep wanted : steps) {
            core::Progress* called = nullptr;
            int after = 0;
            core::Progress cancelled([&](core::ProgressStep step, int, int) {
                after += called->cancelled() ? 1 : 0;
                if (step == wanted)
                    called->cancel();
            });
            called = &cancelled;
            const auto tree = ChunkTree::of(box.source(), cancelled);
            QVERIFY2(!tree && tree.error().code == core::ErrorCode::Cancelled,
                qPrintable(QString::number(int(wanted))));
            QVERIFY2(after <= 1, qPrintable(QStringLiteral("%1: %2").arg(int(wanted)).arg(after)));
        }
    }

    /// Where the image shows nothing, a probability map alone tells parts from each other.
    void aMapTellsWhatTheImageDoesNot()
    {
        const glm::ivec3 size(40, 20, 20);
        Noise noise(11);
        const auto isSegment = [](const glm::dvec3& at) { return at.x < 22; };
        Box box(
            size, [&](const glm::dvec3& at) { return std::uint8_t(isSegment(at) ? 3 : 0); },
            [&](const glm::dvec3&) { return 1000 + noise(20); });
        // The segment's last columns are a leak that the map doubts; beyond lies what it misses.
        std::vector<std::uint8_t> map;
        for (std::size_t voxel = 0; voxel < box.codes.size(); ++voxel) {
            const auto x = int(voxel % 40);
            map.push_back(std::uint8_t(x < 16 ? 250 : x < 22 ? 140 : x < 30 ? 100 : 5));
        }
        ChunkSource source = box.source();
        const auto partsOf = [&](const ChunkTree& tree) {
            std::set<ChunkTree::Chunk> chunks;
            for (const int x : {5, 19, 26, 36})
                chunks.insert(*tree.chunkAt(box.at(x, 10, 10), 4));
            return chunks.size();
        };
        const auto plain = ChunkTree::of(source, {});
        QVERIFY(plain);
        QVERIFY(plain->voxels(*plain->chunkAt(box.at(19, 10, 10), 4)).size()
            != std::size_t(6 * 20 * 20));
        source.probabilities = map;
        source.likely = 3;
        const auto mapped = ChunkTree::of(source, {});
        QVERIFY(mapped);
        QCOMPARE(partsOf(*mapped), std::size_t(4));
        const auto likelihoodAt = [&](int x) {
            return mapped->likelihood(*mapped->chunkAt(box.at(x, 10, 10), 4));
        };
        QCOMPARE(likelihoodAt(5), 2 * 250 - 255);
        QCOMPARE(likelihoodAt(19), 2 * 140 - 255);
        QCOMPARE(likelihoodAt(26), 255 - 2 * 100);
        QCOMPARE(likelihoodAt(36), 255 - 2 * 5);
        // To the voxel: the map's steps are the chunks' borders.
        QCOMPARE(mapped->voxels(*mapped->chunkAt(box.at(19, 10, 10), 4)).size(),
            std::size_t(6 * 20 * 20));
    }

    void refusesAnotherSize()
    {
        const std::vector<std::uint16_t> codes(7);
        const std::vector<std::uint8_t> owners(8);
        QVERIFY(!ChunkTree::of({.size = {2, 2, 2}, .codes = codes, .owners = owners}, {}));
        QVERIFY(!ChunkTree::of({.size = {0, 0, 0}, .codes = {}, .owners = {}}, {}));
        const std::vector<std::uint16_t> eight(8);
        QVERIFY(!ChunkTree::of({.size = {2, 2, 2},
                                   .codes = eight,
                                   .owners = owners,
                                   .probabilities = std::span(owners).first(7)},
            {}));
    }
};

BURIN_TEST(ChunkTreeTest)

} // namespace chunkTreeTest

#include "ChunkTreeTest.moc"
