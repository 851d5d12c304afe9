// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/textures/MaximumCells.h"
#include "tests/support/fixtures/frames/GlTest.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <random>
#include <vector>

namespace maximumCellsGlTest {

using namespace gpu;

class MaximumCellsGlTest : public test::GlTest {
    Q_OBJECT

private Q_SLOTS:
    void greatestCodesAndDistancesByDefinition()
    {
        const glm::ivec3 size(38, 21, 17); // no multiples of a cell
        const auto at = [](const glm::ivec3& extent, const glm::ivec3& p) {
            return std::size_t((p.z * extent.y + p.y) * extent.x + p.x);
        };
        const auto all = [](const glm::ivec3& extent, auto visit) {
            for (int z = 0; z < extent.z; ++z)
                for (int y = 0; y < extent.y; ++y)
                    for (int x = 0; x < extent.x; ++x)
                        visit(glm::ivec3(x, y, z));
        };
        std::mt19937 random(11);
        std::vector<std::uint16_t> codes(std::size_t(size.x * size.y * size.z));
        all(size, [&](const glm::ivec3& voxel) {
            codes[at(size, voxel)] = std::uint16_t(1000 * voxel.x + random() % 3000);
        });
        const MaximumCells maxima(size, codes);
        const glm::ivec3 cells(10, 6, 5);
        QCOMPARE(maxima.cells(), cells);
        std::vector<std::uint16_t> texels(4 * 300);
        maxima.texture().read(glm::ivec3(0), cells, std::as_writable_bytes(std::span(texels)));
        QVERIFY(std::is_sorted(maxima.levels().begin(), maxima.levels().end()));
        all(cells, [&](const glm::ivec3& cell) {
            // Samples in [4c, 4c + 4) reach voxels 4c … 4c + 4.
            int greatest = 0;
            all(glm::min(glm::ivec3(5), size - cell * 4), [&](const glm::ivec3& offset) {
                greatest = std::max(greatest, int(codes[at(size, cell * 4 + offset)]));
            });
            QCOMPARE(int(texels[4 * at(cells, cell)]), greatest);
            for (std::size_t k = 0; k < maxima.levels().size(); ++k) {
                int nearest = 255;
                all(cells, [&](const glm::ivec3& other) {
                    const glm::ivec3 apart = glm::abs(other - cell);
                    if (texels[4 * at(cells, other)] > maxima.levels()[k])
                        nearest = std::min(nearest, std::max({apart.x, apart.y, apart.z}));
                });
                const int word = texels[4 * at(cells, cell) + 1 + k / 2];
                QCOMPARE(word >> 8 * int(k % 2) & 255, nearest);
            }
        });
    }

    void oneValueEverywhere()
    {
        const MaximumCells maxima(glm::ivec3(9, 5, 1), std::vector<std::uint16_t>(45, 700));
        QCOMPARE(maxima.levels(), (std::array<int, 6>{700, 700, 700, 700, 700, 700}));
        std::vector<std::uint16_t> texels(4 * 6);
        maxima.texture().read(
            glm::ivec3(0), maxima.cells(), std::as_writable_bytes(std::span(texels)));
        QCOMPARE(texels[0], std::uint16_t(700));
        QCOMPARE(texels[1], std::uint16_t(0xFFFF)); // nothing exceeds it
    }
};

BURIN_TEST(MaximumCellsGlTest)

} // namespace maximumCellsGlTest

#include "MaximumCellsGlTest.moc"
