// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/radiation/SparseRadiationKernel.h"
#include "tests/reference/fields/SparseRadiation.h"
#include "tests/support/fixtures/frames/GlTest.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QtTest>

#include <algorithm>

namespace sparseRadiationGlTest {

using namespace gpu;

/// The kernel's tiles equal the oracle's field, to the bit.
class SparseRadiationGlTest : public test::GlTest {
    Q_OBJECT

    static constexpr int side = SparseRadiationKernel::tileSide;

    static void compare(const std::vector<SparseRadiationKernel::Point>& points, int tileCount)
    {
        SparseRadiationKernel kernel(ShaderLibrary::builtIn());
        Texture3D target(
            {.label = "tiles", .size = {side * 4, side * 4, side * 8}, .format = GL_RG8});
        std::vector<reference::SparsePoint> all;
        for (const auto& point : points)
            all.push_back({point.footprint, point.label});
        std::vector<SparseRadiationKernel::Tile> tiles;
        for (int i = 0; i < tileCount; ++i) {
            SparseRadiationKernel::Tile tile{
                .origin = glm::ivec3(i % 3, i / 3 % 3, i / 9) * 16 - 1,
                .texel = glm::ivec3(i % 4, i / 4 % 4, i / 16) * side,
                .points = {},
            };
            // Listed points may also miss the tile.
            for (std::size_t p = 0; p < points.size(); ++p)
                tile.points.push_back(std::uint32_t(p));
            tiles.push_back(std::move(tile));
        }
        kernel.update(points, tiles, target);
        for (const SparseRadiationKernel::Tile& tile : tiles) {
            std::vector<std::uint8_t> texels(std::size_t(2 * side * side * side));
            target.read(tile.texel, glm::ivec3(side), std::as_writable_bytes(std::span(texels)));
            const auto truth = reference::sparseRadiation(all, tile.origin, glm::ivec3(side));
            for (std::size_t i = 0; i < truth.sums.values.size(); ++i) {
                QCOMPARE(
                    int(texels[2 * i]), int(core::radiation::sparseByte(truth.sums.values[i])));
                QCOMPARE(int(texels[2 * i + 1]), int(truth.labels.values[i]));
            }
        }
    }

private Q_SLOTS:
    void equalsTheOracle();
    void ofManyPointsInOnePlace();
    void ofNoPointsIsEmpty();
    void ofMoreTilesAndPointsThanOnePass();
};

void SparseRadiationGlTest::equalsTheOracle()
{
    const int count = test::longRun() ? 100 : 8;
    for (int seed = 0; seed < count; ++seed) {
        test::Random random{std::uint32_t(100 + seed)};
        std::vector<SparseRadiationKernel::Point> points;
        for (int i = test::randomInt(random, 1, 50); i > 0; --i) {
            const glm::dvec3 spacing{test::randomInt(random, 2, 8) / 4.0,
                test::randomInt(random, 2, 8) / 4.0, test::randomInt(random, 2, 20) / 4.0};
            const glm::dvec3 at{test::randomInt(random, -2000, 12000) / 256.0,
                test::randomInt(random, -2000, 12000) / 256.0,
                test::randomInt(random, -2000, 6000) / 256.0};
            points.push_back(
                {core::radiation::sparseFootprint(
                     at, core::radiation::sparseRadii(test::randomInt(random, 1, 8), spacing)),
                    std::uint8_t(test::randomInt(random, 1, 255))});
        }
        compare(points, 9);
        if (QTest::currentTestFailed())
            return;
    }
}

void SparseRadiationGlTest::ofManyPointsInOnePlace()
{
    // Sums far beyond 1, unclamped until the end; equal parts, so the greatest label stays.
    std::vector<SparseRadiationKernel::Point> points;
    for (int i = 0; i < 4000; ++i)
        points.push_back({core::radiation::sparseFootprint({15.5, 16.0, 0.0}, glm::dvec3(3.0)),
            std::uint8_t(1 + i % 7)});
    compare(points, 4);
}

void SparseRadiationGlTest::ofNoPointsIsEmpty()
{
    compare({}, 2);
}

void SparseRadiationGlTest::ofMoreTilesAndPointsThanOnePass()
{
    test::Random random(5);
    std::vector<SparseRadiationKernel::Point> points;
    for (int i = 0; i < 150; ++i)
        points.push_back({core::radiation::sparseFootprint(
                              {test::randomInt(random, 0, 47), test::randomInt(random, 0, 47),
                                  test::randomInt(random, 0, 130)},
                              glm::dvec3(3.0)),
            std::uint8_t(test::randomInt(random, 1, 3))});
    compare(points, 70); // 70 · 150 footprints: two passes of tiles, more than one dispatch each
}

BURIN_TEST(SparseRadiationGlTest)

} // namespace sparseRadiationGlTest

#include "SparseRadiationGlTest.moc"
