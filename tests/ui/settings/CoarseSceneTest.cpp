// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/CoarseScene.h"

#include "core/chunks/CoarseChunks.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace coarseSceneTest {

namespace {

constexpr glm::ivec3 size(30, 24, 20);
constexpr core::VoxelBox box{.minimum = {2, 4, 6}, .maximum = {2 + size.x, 4 + size.y, 6 + size.z}};
constexpr int segment = 3;

bool isOwned(int x)
{
    return x >= 20;
}

core::CoarseChunks divided()
{
    std::vector<std::uint16_t> codes;
    std::vector<std::uint8_t> owners;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                codes.push_back(x < 10 ? 500 : x < 20 ? 2000 : 2050);
                owners.push_back(isOwned(x) ? segment : 0);
            }
        }
    }
    auto coarse = core::CoarseChunks::of({.size = size, .codes = codes, .owners = owners}, box, {});
    if (!coarse)
        qFatal("not divided");
    return *std::move(coarse);
}

} // namespace

/// How chunks are drawn before they are there.
class CoarseSceneTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whatTheSegmentHasIsStrong()
    {
        const core::CoarseChunks coarse = divided();
        const auto scene =
            ui::coarseScene(coarse, {.segment = segment, .count = 3, .opacity = 0.25f});
        QCOMPARE(scene->box.minimum, box.minimum);
        QCOMPARE(scene->cell, glm::ivec3(2));
        QCOMPARE(scene->cells(), (size + 1) / 2);
        QCOMPARE(scene->leaves, coarse.leaves);
        QCOMPARE(scene->opacity, 0.25f);
        QVERIFY(scene->rims.empty());
        QCOMPARE(scene->argb.size(), std::size_t(coarse.tree.finest()));
        std::uint32_t own = 0;
        for (std::size_t leaf = 0; leaf < scene->argb.size(); ++leaf) {
            const bool isOwn = coarse.tree.owner(core::ChunkTree::Chunk(leaf)) == segment;
            QCOMPARE(scene->argb[leaf] >> 24, isOwn ? 255U : 90U);
            own = isOwn ? scene->argb[leaf] : own;
        }
        // What the segment has is one chunk, and others that touch it have other colours.
        const auto leafAt = [&](const glm::ivec3& cell) {
            const glm::ivec3 cells = scene->cells();
            const std::size_t at = std::size_t((cell.z * cells.y + cell.y) * cells.x + cell.x);
            return std::size_t((*scene->leaves)[at] - 1);
        };
        QCOMPARE(scene->argb[leafAt({12, 5, 5})], own);
        QVERIFY((scene->argb[leafAt({8, 5, 5})] & 0xFFFFFFU) != (own & 0xFFFFFFU));
    }

    void whatIsHiddenHasNoShare()
    {
        const core::CoarseChunks coarse = divided();
        int asked = 0;
        const auto scene = ui::coarseScene(coarse,
            {.segment = segment, .count = 3, .isHidden = [&asked](int) { return ++asked > 0; }});
        QVERIFY(asked > 0);
        for (std::size_t leaf = 0; leaf < scene->argb.size(); ++leaf) {
            const bool isOwn = coarse.tree.owner(core::ChunkTree::Chunk(leaf)) == segment;
            QCOMPARE(scene->argb[leaf] >> 24, isOwn ? 255U : 0U);
        }
    }
};

BURIN_TEST(CoarseSceneTest)

} // namespace coarseSceneTest

#include "CoarseSceneTest.moc"
