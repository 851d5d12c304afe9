// SPDX-License-Identifier: Apache-2.0
#include "core/chunks/ChunkSurvey.h"

#include "core/chunks/BoxWalk.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <random>
#include <utility>

namespace chunkSurveyTest {

using core::ChunkSource;
using core::ChunkSurvey;
using core::ChunkTree;

/// Where leaves touch and where their middles are, against voxels that are looked at one by one.
class ChunkSurveyTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void asVoxelsSay_data()
    {
        QTest::addColumn<int>("seed");
        for (int seed = 0; seed < 8; ++seed)
            QTest::addRow("random %d", seed) << seed;
    }
    void asVoxelsSay()
    {
        QFETCH(int, seed);
        std::mt19937 random{std::uint32_t(seed)};
        const glm::ivec3 size(9 + seed, 21, 17);
        const core::BoxWalk walk(size);
        std::vector<std::uint16_t> codes;
        std::vector<std::uint8_t> owners;
        for (std::size_t voxel = 0; voxel < walk.voxels(); ++voxel) {
            const glm::ivec3 block = walk.placeOf(voxel) / (3 + seed);
            codes.push_back(std::uint16_t(3000 + (block.x * 5 + block.y * 11 + block.z * 3) % 7 * 70
                + int(random() % (seed % 2 == 0 ? 40U : 2000U))));
            owners.push_back(random() % 50 == 0 ? ChunkSource::outside
                                                : std::uint8_t(walk.placeOf(voxel).y > 8));
        }
        const ChunkSource source{.size = size, .codes = codes, .owners = owners};
        const auto tree = ChunkTree::of(source, {});
        QVERIFY(tree);
        const ChunkSurvey survey = ChunkSurvey::of(source, *tree);
        QCOMPARE(survey.size, size);

        // The sums of each leaf, voxel by voxel.
        std::map<ChunkTree::Chunk, std::vector<std::size_t>> voxelsOf;
        for (std::size_t voxel = 0; voxel < walk.voxels(); ++voxel) {
            if (const auto leaf = tree->leafAt(voxel))
                voxelsOf[*leaf].push_back(voxel);
        }
        QCOMPARE(survey.middles.size(), voxelsOf.size());
        std::map<ChunkTree::Chunk, int> means;
        for (const auto& [leaf, voxels] : voxelsOf) {
            long long codesSum = 0;
            glm::ivec3 places(0);
            for (const std::size_t voxel : voxels) {
                codesSum += codes[voxel];
                places += walk.placeOf(voxel);
            }
            const auto count = int(voxels.size());
            means[leaf] = int(codesSum / count);
            const auto offBy = [&](std::size_t voxel) {
                const glm::ivec3 off = walk.placeOf(voxel) - places / count;
                return off.x * off.x + off.y * off.y + off.z * off.z;
            };
            const auto nearest = *std::min_element(voxels.begin(), voxels.end(),
                [&](std::size_t one, std::size_t other) { return offBy(one) < offBy(other); });
            QCOMPARE(std::size_t(survey.middles[leaf]), nearest); // the first of equal ones
        }

        std::map<std::pair<ChunkTree::Chunk, ChunkTree::Chunk>, ChunkSurvey::Border> expected;
        walk.forEachPair([&](std::size_t voxel, std::size_t neighbour) {
            const auto one = tree->leafAt(voxel);
            const auto other = tree->leafAt(neighbour);
            if (!one || !other || one == other)
                return;
            const int step = std::abs(int(codes[voxel]) - int(codes[neighbour])) / 2;
            const int apart = std::max(step, std::abs(means[*one] - means[*other]));
            const int units = std::min(1023, apart * 64 / tree->noise());
            ChunkSurvey::Border& border = expected[std::minmax(*one, *other)];
            border.first = std::min(*one, *other);
            border.second = std::max(*one, *other);
            border.faces += 1;
            border.bond += std::uint64_t((256 * 64 * 64) / (64 * 64 + units * units));
        });
        std::vector<ChunkSurvey::Border> listed;
        for (const auto& [pair, border] : expected)
            listed.push_back(border);
        QVERIFY(!listed.empty());
        QVERIFY(survey.borders == listed);
    }

    /// The numbers that the header promises: halved by one deviation, a tenth at three.
    void deviationsWeakenTheBond()
    {
        // Columns of two values; neighbours differ by 60 within each, so that this is the noise.
        constexpr glm::ivec3 size(8, 4, 4);
        const core::BoxWalk walk(size);
        for (const auto& [apart, least, most] :
            {std::array{0, 200, 256}, std::array{60, 100, 140}, std::array{180, 15, 35}}) {
            std::vector<std::uint16_t> codes;
            std::vector<std::uint8_t> owners;
            for (std::size_t voxel = 0; voxel < walk.voxels(); ++voxel) {
                const glm::ivec3 place = walk.placeOf(voxel);
                const int side = place.x < 4 ? 0 : 1;
                codes.push_back(
                    std::uint16_t(1000 + side * apart + (place.x + place.y + place.z) % 2 * 60));
                owners.push_back(std::uint8_t(side));
            }
            const ChunkSource source{.size = size, .codes = codes, .owners = owners};
            const auto tree = ChunkTree::of(source, {});
            QVERIFY(tree);
            QCOMPARE(tree->noise(), 60);
            const ChunkSurvey survey = ChunkSurvey::of(source, *tree);
            std::uint64_t bond = 0;
            std::uint32_t faces = 0;
            for (const ChunkSurvey::Border& border : survey.borders) {
                if (tree->owner(border.first) == tree->owner(border.second))
                    continue;
                bond += border.bond;
                faces += border.faces;
            }
            QCOMPARE(faces, 16U);
            const auto each = int(bond / faces);
            QVERIFY2(each >= least && each <= most, qPrintable(QString::number(each)));
        }
    }
};

BURIN_TEST(ChunkSurveyTest)

} // namespace chunkSurveyTest

#include "ChunkSurveyTest.moc"
