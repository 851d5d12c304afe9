// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <functional>
#include <memory>
#include <vector>

namespace coarseChunksGlTest {

using namespace gpu;

namespace {

constexpr glm::ivec2 size(80, 60);
constexpr std::uint32_t red = 0xFFFF0000;
constexpr std::uint32_t blue = 0xFF0000FF;

/// @param leafAt by cell of the box
std::shared_ptr<SceneChunks> chunksOf(const core::VoxelBox& box, const glm::ivec3& cell,
    const std::function<int(const glm::ivec3&)>& leafAt)
{
    auto chunks = std::make_shared<SceneChunks>();
    chunks->box = box;
    chunks->cell = cell;
    const glm::ivec3 cells = chunks->cells();
    std::vector<std::uint16_t> leaves;
    for (int z = 0; z < cells.z; ++z)
        for (int y = 0; y < cells.y; ++y)
            for (int x = 0; x < cells.x; ++x)
                leaves.push_back(std::uint16_t(leafAt({x, y, z})));
    chunks->leaves = std::make_shared<const std::vector<std::uint16_t>>(std::move(leaves));
    chunks->argb = {red, blue};
    chunks->opacity = 0.25f;
    return chunks;
}

int leafOfCell(const glm::ivec3& at)
{
    return (at.x + 2 * at.y + at.z * at.z) % 3;
}

} // namespace

/// Chunks that are known by cells of several voxels, as what a growth would take is.
class CoarseChunksGlTest : public test::FrameTest {
    Q_OBJECT

    [[nodiscard]] Frame drawn(const std::shared_ptr<const SceneChunks>& chunks)
    {
        SliceScene scene;
        scene.mmPerPixel = 0.5; // a voxel is two pixels wide
        scene.window = {.centre = 1000.0, .width = 1000.0};
        scene.chunks = chunks;
        return m_fixture->draw(scene, size);
    }
    [[nodiscard]] static glm::ivec3 at(const Frame& frame, int i, int j)
    {
        return test::pixel(frame, 2 * i, 2 * j);
    }

private Q_SLOTS:
    /// The box does not divide into cells: the last ones are cut off.
    void slicesShowEveryVoxelOfACell()
    {
        m_fixture->open(
            test::centredGeometry({40, 30, 20}), [](const glm::dvec3&) { return 1000.0; });
        const core::VoxelBox box{.minimum = {11, 8, 3}, .maximum = {32, 22, 14}};
        const glm::ivec3 cell(2, 3, 4);
        const Frame coarse = drawn(chunksOf(box, cell, leafOfCell));
        const Frame fine = drawn(chunksOf(
            box, glm::ivec3(1), [&cell](const glm::ivec3& at) { return leafOfCell(at / cell); }));
        QVERIFY(*coarse.rgba == *fine.rgba);
        QVERIFY(*coarse.rgba != *drawn(nullptr).rgba);
        // One that does not fit its cells is not drawn.
        auto wrong = std::make_shared<SceneChunks>(*chunksOf(box, cell, leafOfCell));
        wrong->cell = {2, 3, 6};
        QVERIFY(*drawn(wrong).rgba == *drawn(nullptr).rgba);
        wrong->cell = {2, 3, 0};
        QVERIFY(*drawn(wrong).rgba == *drawn(nullptr).rgba);
    }

    void slicesShowOnlyVoxelsWithTheseCodes()
    {
        m_fixture->open(test::centredGeometry({40, 30, 20}),
            [](const glm::dvec3& lps) { return lps.x < 0.0 ? 1000.0 : 1001.0; });
        const core::VoxelBox box{.minimum = {8, 8, 2}, .maximum = {32, 22, 12}};
        const Frame plain = drawn(nullptr);
        const auto tintedIn = [&](std::optional<core::CodeRange> codes) {
            const auto chunks = chunksOf(box, glm::ivec3(4), [](const glm::ivec3&) { return 1; });
            chunks->codes = codes;
            const Frame frame = drawn(chunks);
            return std::pair(
                at(frame, 13, 15) != at(plain, 13, 15), at(frame, 26, 15) != at(plain, 26, 15));
        };
        QCOMPARE(tintedIn({}), std::pair(true, true));
        QCOMPARE(tintedIn(core::CodeRange{1000, 1001}), std::pair(true, true));
        QCOMPARE(tintedIn(core::CodeRange{990, 1000}), std::pair(true, false));
        QCOMPARE(tintedIn(core::CodeRange{1001, 65535}), std::pair(false, true));
        QCOMPARE(tintedIn(core::CodeRange{1002, 65535}), std::pair(false, false));
    }

    /// A ball of cells, seen from the front (−y), two pixels a voxel.
    void bodiesAreWhereTheirCellsAre()
    {
        constexpr int side = 48;
        m_fixture->open(
            test::centredGeometry(glm::ivec3(side)), [](const glm::dvec3&) { return 0.0; });
        const glm::ivec3 cell(2, 3, 2);
        const core::VoxelBox box{.minimum = {8, 6, 10}, .maximum = {40, 42, 38}};
        const auto chunks = chunksOf(box, cell, [&](const glm::ivec3& at) {
            const glm::dvec3 middle =
                glm::dvec3(box.minimum) + (glm::dvec3(at) + 0.5) * glm::dvec3(cell);
            return glm::distance(middle, glm::dvec3(24.0)) < 10.0 ? 2 : 1;
        });
        chunks->argb = {0x00FF0000, blue};
        VolumeScene scene;
        scene.eyeLps = {0, -300, 0};
        scene.heightMm = side;
        scene.surfaceThreshold = 1000.0;
        scene.chunks = chunks;
        const Frame frame = m_fixture->draw(scene, {2 * side, 2 * side});
        const auto blueAt = [&](int i, int k) {
            return test::pixel(frame, 2 * i + 1, 2 * (side - k) - 1).b;
        };
        for (const glm::ivec2& in : {glm::ivec2(24, 24), {17, 24}, {31, 24}, {24, 17}, {24, 31}})
            QVERIFY2(blueAt(in.x, in.y) > 30, qPrintable(QString::number(in.x)));
        for (const glm::ivec2& out : {glm::ivec2(10, 24), {37, 24}, {24, 11}, {24, 36}, {14, 14}})
            QVERIFY2(blueAt(out.x, out.y) < 10, qPrintable(QString::number(out.x)));
    }
};

BURIN_TEST(CoarseChunksGlTest)

} // namespace coarseChunksGlTest

#include "CoarseChunksGlTest.moc"
