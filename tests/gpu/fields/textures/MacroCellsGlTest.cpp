// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/textures/MacroCells.h"
#include "gpu/gl/Program.h"
#include "tests/support/fixtures/frames/GlTest.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <random>

namespace macroCellsGlTest {

using namespace gpu;

namespace {

const glm::ivec3 size(37, 20, 17); // no multiples of a cell

std::size_t at(const glm::ivec3& extent, int x, int y, int z)
{
    return std::size_t((z * extent.y + y) * extent.x + x);
}

} // namespace

class MacroCellsGlTest : public test::GlTest {
    Q_OBJECT

    /// Calls back for every voxel that samples in [8c, 8c + 8) can reach.
    template <class Visit> static void voxelsOf(const glm::ivec3& cell, Visit visit)
    {
        const glm::ivec3 last = glm::min(cell * 8 + 8, size - 1);
        for (int z = cell.z * 8; z <= last.z; ++z)
            for (int y = cell.y * 8; y <= last.y; ++y)
                for (int x = cell.x * 8; x <= last.x; ++x)
                    visit(x, y, z);
    }
    template <class Visit> static void allCells(Visit visit)
    {
        const glm::ivec3 cells = MacroCells::cellsFor(size);
        for (int z = 0; z < cells.z; ++z)
            for (int y = 0; y < cells.y; ++y)
                for (int x = 0; x < cells.x; ++x)
                    visit(glm::ivec3(x, y, z), at(cells, x, y, z));
    }
    static std::vector<std::uint16_t> randomCodes()
    {
        std::mt19937 random(7);
        std::vector<std::uint16_t> codes(std::size_t(size.x * size.y * size.z));
        for (std::uint16_t& code : codes)
            code = std::uint16_t(1000 + random() % 50000);
        return codes;
    }

private Q_SLOTS:
    void rangesCoverWhatSamplesReach()
    {
        const std::vector<std::uint16_t> codes = randomCodes();
        const MacroCells cells(size, codes);
        QCOMPARE(cells.cells(), glm::ivec3(5, 3, 3));
        std::vector<std::uint16_t> ranges(2 * 45);
        cells.ranges().read(
            glm::ivec3(0), cells.cells(), std::as_writable_bytes(std::span(ranges)));
        allCells([&](const glm::ivec3& cell, std::size_t index) {
            std::uint16_t lowest = 0xFFFF;
            std::uint16_t highest = 0;
            voxelsOf(cell, [&](int x, int y, int z) {
                lowest = std::min(lowest, codes[at(size, x, y, z)]);
                highest = std::max(highest, codes[at(size, x, y, z)]);
            });
            QCOMPARE(ranges[2 * index], lowest);
            QCOMPARE(ranges[2 * index + 1], highest);
        });
        QCOMPARE(cells.greatestCode(), int(*std::max_element(codes.begin(), codes.end())));
    }

    /// A brick is ruled out only where it holds none of the codes, and is so where all its cells
    /// are of other ones.
    void bricksAreRuledOut()
    {
        std::mt19937 random(5);
        std::vector<std::uint16_t> codes(std::size_t(size.x * size.y * size.z), 10);
        for (int i = 0; i < 20; ++i)
            codes[random() % codes.size()] = std::uint16_t(100 + random() % 900);
        codes.back() = 1000;
        const MacroCells cells(size, codes);
        const core::BrickGrid grid{size};
        int ruledOut = 0;
        for (int round = 0; round < 200; ++round) {
            const int lowest = int(random() % 1100);
            const int highest = lowest + int(random() % 200);
            for (int brick = 0; brick < grid.brickCount(); ++brick) {
                bool holds = false;
                const core::VoxelBox box = grid.boxOf(brick);
                const glm::ivec3 end = glm::min(box.maximum, size);
                for (int z = box.minimum.z; z < end.z; ++z)
                    for (int y = box.minimum.y; y < end.y; ++y)
                        for (int x = box.minimum.x; x < end.x; ++x) {
                            const int code = codes[at(size, x, y, z)];
                            holds = holds || (lowest <= code && code <= highest);
                        }
                const bool may = cells.mayHold(grid.brickPosition(brick), lowest, highest);
                QVERIFY(may || !holds);
                ruledOut += may ? 0 : 1;
            }
        }
        QVERIFY2(ruledOut > 100, qPrintable(QString::number(ruledOut)));
        QVERIFY(!cells.mayHold({0, 0, 0}, 1001, 65535));
        QVERIFY(cells.mayHold(grid.bricks() - 1, 1000, 1000));
    }

    void dirtyBoxesAreEnough()
    {
        std::vector<std::uint16_t> codes(std::size_t(size.x * size.y * size.z), 10);
        codes[at(size, 20, 9, 9)] = 500;
        MacroCells cells(size, codes);
        Program kernel(ShaderLibrary::builtIn(),
            {.label = "macro-cells", .path = "fields/textures/macroCells.comp"});
        Texture3D radiation({.label = "radiation", .size = size, .format = GL_R8});
        Texture3D segmentation({.label = "segmentation", .size = size, .format = GL_R8});
        radiation.clear();
        segmentation.clear();
        std::vector<std::uint8_t> carved(codes.size(), 0);
        std::vector<std::uint8_t> inside(codes.size(), 0);
        std::mt19937 random(3);
        const VisibleCodes visible{{{400, 600}}};
        for (int round = 0; round < 12; ++round) {
            glm::ivec3 first;
            glm::ivec3 extent;
            for (int axis = 0; axis < 3; ++axis) {
                first[axis] = int(random() % unsigned(size[axis]));
                extent[axis] = 1 + int(random() % unsigned(size[axis] - first[axis]));
            }
            const auto value = std::uint8_t(round % 3 == 2 ? 0 : 200);
            const bool carve = round % 2 == 0;
            (carve ? radiation : segmentation).clear(first, extent, &value);
            for (int z = first.z; z < first.z + extent.z; ++z)
                for (int y = first.y; y < first.y + extent.y; ++y)
                    for (int x = first.x; x < first.x + extent.x; ++x)
                        (carve ? carved : inside)[at(size, x, y, z)] = value;
            cells.update(kernel, radiation, segmentation, {first, first + extent});

            std::vector<std::uint8_t> skip(2 * 45);
            cells.skipMap(visible).read(
                glm::ivec3(0), cells.cells(), std::as_writable_bytes(std::span(skip)));
            bool any = false;
            allCells([&](const glm::ivec3& cell, std::size_t index) {
                bool shown = false;
                bool allCarved = true;
                bool anyCarved = false;
                bool anySegment = false;
                voxelsOf(cell, [&](int x, int y, int z) {
                    const std::size_t voxel = at(size, x, y, z);
                    shown = shown || codes[voxel] >= 400;
                    allCarved = allCarved && carved[voxel] >= 128;
                    anyCarved = anyCarved || carved[voxel] >= 128;
                    anySegment = anySegment || inside[voxel] >= 128;
                });
                const int flags = (shown && !allCarved ? MacroCells::tissueFlag : 0)
                    | (anyCarved ? MacroCells::carvedFlag : 0)
                    | (anySegment ? MacroCells::segmentFlag : 0)
                    | (shown ? MacroCells::shownFlag : 0);
                QCOMPARE(int(skip[2 * index + 1]), flags);
                const bool occupied =
                    (flags & (MacroCells::tissueFlag | MacroCells::segmentFlag)) != 0;
                QCOMPARE(skip[2 * index] == 0, occupied);
                any = any || anyCarved || anySegment;
            });
            QCOMPARE(cells.isSculpted(), any);
        }
    }
};

BURIN_TEST(MacroCellsGlTest)

} // namespace macroCellsGlTest

#include "MacroCellsGlTest.moc"
