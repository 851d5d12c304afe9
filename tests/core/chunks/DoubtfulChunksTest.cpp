// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/DoubtfulChunks.h"

#include "core/chunks/BoxWalk.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <random>

namespace doubtfulChunksTest {

using core::ChunkSource;
using core::ChunkSurvey;
using core::ChunkTree;
using core::DoubtfulChunks;

namespace {

using Doubtful = DoubtfulChunks::Doubtful;
using Where = std::function<bool(const glm::dvec3&)>;

bool inBall(const glm::dvec3& place, const glm::dvec3& centre, double radius)
{
    return glm::length(place - centre) <= radius;
}

/// A segment of bright voxels, and what is as bright but not its own, in the dark.
struct Scene {
    glm::ivec3 size;
    std::vector<std::uint16_t> codes;
    std::vector<std::uint8_t> owners;

    Scene(const glm::ivec3& sides, const Where& isMasked, const Where& isBright)
        : size(sides)
    {
        std::mt19937 random{11};
        const core::BoxWalk walk(sides);
        for (std::size_t voxel = 0; voxel < walk.voxels(); ++voxel) {
            const glm::dvec3 place(walk.placeOf(voxel));
            owners.push_back(std::uint8_t(isMasked(place)));
            codes.push_back(std::uint16_t((isBright(place) ? 2000 : 1200) + int(random() % 61)));
        }
    }
    [[nodiscard]] ChunkSource source() const
    {
        return {.size = size, .codes = codes, .owners = owners};
    }
};

/// What was found in a scene.
struct Found {
    const Scene& scene;
    ChunkTree tree;
    ChunkSurvey survey;

    explicit Found(const Scene& in)
        : scene(in)
        , tree(*ChunkTree::of(in.source(), {}))
        , survey(ChunkSurvey::of(in.source(), tree))
    {
    }
    [[nodiscard]] DoubtfulChunks atFirst() const
    {
        return {tree, survey, 1, DoubtfulChunks::ownedBy(tree, 1)};
    }
    /// Whether a doubtful chunk is a set of voxels, but for a twentieth.
    [[nodiscard]] bool is(const Doubtful& doubtful, const Where& isIn) const
    {
        const core::BoxWalk walk(scene.size);
        const auto has = [&](std::size_t voxel) { return isIn(glm::dvec3(walk.placeOf(voxel))); };
        std::size_t all = 0;
        for (std::size_t voxel = 0; voxel < walk.voxels(); ++voxel)
            all += has(voxel) ? 1 : 0;
        const auto voxels = tree.voxels(doubtful.chunk);
        const auto shared = std::size_t(std::count_if(voxels.begin(), voxels.end(), has));
        return 20 * shared >= 19 * all && 20 * shared >= 19 * voxels.size() && has(doubtful.middle);
    }
    [[nodiscard]] bool isAmong(
        const std::vector<Doubtful>& all, bool inside, const Where& isIn) const
    {
        return std::any_of(all.begin(), all.end(), [&](const Doubtful& doubtful) {
            return doubtful.isInside == inside && is(doubtful, isIn);
        });
    }
};

const glm::dvec3 organ(30, 30, 30);
constexpr double organRadius = 22.0;
const glm::dvec3 leakBall(66, 30, 30);

bool inOrgan(const glm::dvec3& place)
{
    return inBall(place, organ, organRadius);
}

/// What the segment of some scenes lacks.
bool inLobe(const glm::dvec3& place)
{
    return inOrgan(place) && place.x < 18.0;
}

/// A ball beside the organ, and the channel to it.
bool inLeak(const glm::dvec3& place)
{
    const bool channel =
        place.x > 30.0 && place.x < 66.0 && std::hypot(place.y - 30.0, place.z - 30.0) <= 3.0;
    return !inOrgan(place) && (channel || inBall(place, leakBall, 12.0));
}

/// A share of 256, as the class says it: whole numbers, rounded down.
std::int64_t share(std::int64_t part, std::int64_t all)
{
    return all == 0 ? 0 : part * 256 / all;
}

} // namespace

/// Which chunks a user is led to.
class DoubtfulChunksTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aMissingLobe()
    {
        const Scene scene(
            {60, 60, 60}, [](const glm::dvec3& at) { return inOrgan(at) && !inLobe(at); }, inOrgan);
        const Found found(scene);
        const DoubtfulChunks doubtful = found.atFirst();
        const auto count = doubtful.suggestedCount();
        QVERIFY(count.has_value());
        QVERIFY2(*count <= 20, qPrintable(QString::number(*count)));
        const std::vector<Doubtful> first = doubtful.of(*count, 3);
        QVERIFY(!first.empty());
        QVERIFY(!first.front().isInside);
        QVERIFY(found.is(first.front(), inLobe));
    }

    void aLeakThroughAChannel()
    {
        const auto isBright = [](const glm::dvec3& at) { return inOrgan(at) || inLeak(at); };
        const Scene scene({86, 60, 60}, isBright, isBright);
        const Found found(scene);
        const DoubtfulChunks doubtful = found.atFirst();
        const auto count = doubtful.suggestedCount();
        QVERIFY(count.has_value());
        QVERIFY2(*count <= 60, qPrintable(QString::number(*count)));
        const std::vector<Doubtful> first = doubtful.of(*count, 3);
        QVERIFY(!first.empty());
        QVERIFY(first.front().isInside);
        QVERIFY(found.is(first.front(), inLeak));

        // Taken away it is not offered again.
        std::vector<bool> isInside = DoubtfulChunks::ownedBy(found.tree, 1);
        const std::vector<ChunkTree::Chunk> chunks = found.tree.chunksOfLeaves(*count);
        for (std::size_t leaf = 0; leaf < chunks.size(); ++leaf)
            isInside[leaf] = isInside[leaf] && chunks[leaf] != first.front().chunk;
        const DoubtfulChunks after(found.tree, found.survey, 1, isInside);
        for (const Doubtful& left : after.of(*count, 3))
            QVERIFY(left.chunk != first.front().chunk);
    }

    /// Both at once: at one number of chunks both stand by themselves.
    void aLobeAndALeak()
    {
        const Scene scene(
            {86, 60, 60},
            [](const glm::dvec3& at) { return (inOrgan(at) && !inLobe(at)) || inLeak(at); },
            [](const glm::dvec3& at) { return inOrgan(at) || inLeak(at); });
        const Found found(scene);
        const DoubtfulChunks doubtful = found.atFirst();
        const auto count = doubtful.suggestedCount();
        QVERIFY(count.has_value());
        const std::vector<Doubtful> first = doubtful.of(*count, 3);
        QVERIFY(found.isAmong(first, false, inLobe));
        QVERIFY(found.isAmong(first, true, inLeak));
        // Added, the lobe is where it belongs.
        std::vector<bool> isInside = DoubtfulChunks::ownedBy(found.tree, 1);
        const std::vector<ChunkTree::Chunk> chunks = found.tree.chunksOfLeaves(*count);
        for (const Doubtful& lobe : first) {
            for (std::size_t leaf = 0; leaf < chunks.size(); ++leaf)
                isInside[leaf] = isInside[leaf] || (chunks[leaf] == lobe.chunk && !lobe.isInside);
        }
        const DoubtfulChunks after(found.tree, found.survey, 1, isInside);
        const std::vector<Doubtful> then = after.of(*count, 3);
        QVERIFY(!found.isAmong(then, true, inLobe) && !found.isAmong(then, false, inLobe));
        QVERIFY(found.isAmong(then, true, inLeak));
    }

    /// What is right leaves nothing to be suggested, nor does a box without the segment.
    void nothingIsInDoubt()
    {
        const Scene right({60, 60, 60}, inOrgan, inOrgan);
        const Found found(right);
        QVERIFY(!found.atFirst().suggestedCount());
        QVERIFY(found.atFirst().of(found.tree.fewest() + 8, 3).empty());
        const DoubtfulChunks none(found.tree, found.survey, 1,
            std::vector<bool>(std::size_t(found.tree.finest()), false));
        QVERIFY(!none.suggestedCount() && none.of(found.tree.fewest(), 3).empty());
        const ChunkSurvey nothing;
        const DoubtfulChunks unsurveyed(
            found.tree, nothing, 1, DoubtfulChunks::ownedBy(found.tree, 1));
        QVERIFY(!unsurveyed.suggestedCount());
    }

    /// Every number of random boxes, from the voxels, with any leaves inside.
    void asTheHeaderSays()
    {
        std::size_t compared = 0;
        for (int seed = 0; seed < 10 && !QTest::currentTestFailed(); ++seed)
            compared += compareBox(seed);
        QVERIFY(compared > 0);
    }

    /// A chunk stands by itself from the least to the greatest number that the tree tells.
    void theTreeTellsWhen()
    {
        std::mt19937 random{3};
        const Scene scene(
            {12, 10, 8}, [](const glm::dvec3& at) { return at.x > 5.0; },
            [&](const glm::dvec3&) { return random() % 3 == 0; });
        const Found found(scene);
        std::map<ChunkTree::Chunk, std::pair<int, int>> seen;
        for (int count = found.tree.fewest(); count <= found.tree.finest(); ++count) {
            for (const ChunkTree::Chunk chunk : found.tree.division(count)) {
                seen.try_emplace(chunk, count, count);
                seen[chunk].second = count;
            }
        }
        QCOMPARE(seen.size(), std::size_t(found.tree.chunkCount()));
        for (const auto& [chunk, counts] : seen) {
            QCOMPARE(found.tree.fewestWith(chunk), counts.first);
            QCOMPARE(found.tree.mostWith(chunk), counts.second);
        }
    }

private:
    /// @return how many doubtful chunks there were
    static std::size_t compareBox(int seed)
    {
        std::size_t compared = 0;
        [&] { // checks return from it
            std::mt19937 random{std::uint32_t(seed)};
            const glm::dvec3 middle(8 + seed, 12, 10);
            const Scene scene(
                {24, 22, 20},
                [&](const glm::dvec3& at) {
                    return inBall(at, middle, 7.0) || random() % 400 == 0;
                },
                [&](const glm::dvec3& at) { return inBall(at, middle, 9.0) && at.y > 6.0; });
            const Found found(scene);
            const ChunkTree& tree = found.tree;
            std::vector<bool> isInside = DoubtfulChunks::ownedBy(tree, 1);
            if (seed % 2 == 1) {
                for (std::size_t leaf = 0; leaf < isInside.size(); ++leaf)
                    isInside[leaf] = random() % 8 == 0 ? !isInside[leaf] : isInside[leaf];
            }
            const DoubtfulChunks doubtful(tree, found.survey, 1, isInside);
            const core::BoxWalk walk(scene.size);
            std::map<std::pair<ChunkTree::Chunk, ChunkTree::Chunk>, std::array<std::int64_t, 2>>
                borders;
            for (const ChunkSurvey::Border& border : found.survey.borders)
                borders[{border.first, border.second}] = {
                    std::int64_t(border.bond), std::int64_t(border.faces)};
            std::int64_t held = 0;
            for (std::size_t voxel = 0; voxel < walk.voxels(); ++voxel)
                held += isInside[*tree.leafAt(voxel)] ? 1 : 0;

            std::int64_t greatest = 0; // of all chunks there are
            for (const int count :
                {tree.fewest(), (3 * tree.fewest() + tree.finest()) / 4, tree.finest()}) {
                const std::vector<ChunkTree::Chunk> chunkOf = tree.chunksOfLeaves(count);
                std::map<ChunkTree::Chunk, std::int64_t> expected;
                for (const ChunkTree::Chunk chunk : tree.division(count)) {
                    std::int64_t voxels = 0;
                    std::int64_t inner = 0;
                    for (const std::uint32_t voxel : tree.voxels(chunk)) {
                        ++voxels;
                        inner += isInside[*tree.leafAt(voxel)] ? 1 : 0;
                    }
                    std::array<std::int64_t, 2> bonds{};
                    std::array<std::int64_t, 2> faces{};
                    for (const auto& [pair, border] : borders) {
                        const bool first = chunkOf[pair.first] == chunk;
                        const bool second = chunkOf[pair.second] == chunk;
                        if (first == second)
                            continue;
                        const std::size_t side = isInside[first ? pair.second : pair.first] ? 1 : 0;
                        bonds[side] += border[0];
                        faces[side] += border[1];
                    }
                    const bool inside = 2 * inner > voxels;
                    if ((inside ? 2 * voxels : voxels) > held)
                        continue;
                    const auto edge = std::int64_t(std::floor(std::cbrt(double(voxels)) + 1e-9));
                    const std::int64_t cube = edge * edge;
                    const std::int64_t contact = bonds[1] / 256;
                    const int belongs =
                        tree.likelihood(chunk) * (inside == (tree.owner(chunk) == 1) ? 1 : -1);
                    std::int64_t first = 0;
                    std::int64_t second = 0;
                    std::int64_t third = 0;
                    if (inside) {
                        first = share(faces[0], faces[0] + contact);
                        second = cube > contact ? share(cube - contact, cube + 4 * contact) : 0;
                        third = share(510 - belongs, 765);
                    } else if (faces[1] > 0) {
                        first = share(bonds[1], bonds[0] + bonds[1]);
                        second = bonds[1] / faces[1] * contact / (contact + 2 * cube);
                        const std::int64_t lead = share(std::clamp(40 - belongs, 0, 40), 40);
                        third = lead * lead / 256;
                    }
                    std::int64_t doubt = voxels * first / 256;
                    doubt = doubt * second / 256;
                    doubt = doubt * third / 256;
                    if (16 * doubt >= voxels && doubt >= std::max<std::int64_t>(16, held / 4000))
                        expected[chunk] = doubt;
                }
                const std::vector<Doubtful> all = doubtful.of(count, 100000);
                QCOMPARE(all.size(), expected.size());
                compared += all.size();
                for (std::size_t i = 0; i < all.size(); ++i) {
                    QCOMPARE(all[i].doubt, expected.at(all[i].chunk));
                    QCOMPARE(tree.chunkAt(all[i].middle, count), std::optional(all[i].chunk));
                    QVERIFY(i == 0 || all[i - 1].doubt > all[i].doubt
                        || (all[i - 1].doubt == all[i].doubt && all[i - 1].chunk < all[i].chunk));
                }
                const std::vector<Doubtful> few = doubtful.of(count, 2);
                QVERIFY(few.size() == std::min<std::size_t>(2, all.size())
                    && std::equal(few.begin(), few.end(), all.begin()));
            }
            for (int count = tree.fewest(); count <= tree.finest(); ++count) {
                const std::vector<Doubtful> first = doubtful.of(count, 1);
                greatest = std::max(greatest, first.empty() ? 0 : first.front().doubt);
            }
            const auto suggested = doubtful.suggestedCount();
            QCOMPARE(suggested.has_value(), greatest > 0);
            if (suggested)
                QCOMPARE(doubtful.of(*suggested, 1).front().doubt, greatest);
        }();
        return compared;
    }
};

BURIN_TEST(DoubtfulChunksTest)

} // namespace doubtfulChunksTest

#include "DoubtfulChunksTest.moc"
