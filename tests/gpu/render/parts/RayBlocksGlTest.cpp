// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/parts/RayBlocks.h"

#include "core/document/Piece.h"
#include "tests/support/faults/ChangedRaycaster.h"
#include "tests/support/fixtures/frames/FrameFixture.h"
#include "tests/support/fixtures/frames/GlTest.h"
#include "tests/support/program/TestProgram.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

namespace rayBlocksGlTest {

using namespace gpu;

namespace {

constexpr glm::ivec2 frameSize{230, 200};

/// Every program of the ray caster able to draw cuts and segments.
ShaderLibrary oneKind(const QTemporaryDir& folder)
{
    return test::changedRaycaster(
        folder, "#undef SCULPTED\n#define SCULPTED 1\n#undef SEGMENTS\n#define SEGMENTS 1\n");
}

/// A bumpy ball in air.
double ball(const glm::dvec3& lps)
{
    const double bumps = std::sin(lps.x * 0.5) + std::sin(lps.y * 0.4) + std::sin(lps.z * 0.6);
    return std::max(0.0, 400.0 + 60.0 * (34.0 + bumps - glm::length(lps)));
}

struct Random {
    std::mt19937 engine;
    double between(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(engine);
    }
    glm::dvec3 inBox(double reach)
    {
        const double x = between(-reach, reach);
        const double y = between(-reach, reach);
        return {x, y, between(-reach, reach)};
    }
};

VolumeScene randomScene(Random& random, RenderMode mode)
{
    VolumeScene scene;
    scene.mode = mode;
    scene.orthographic = random.between(0, 1) < 0.5;
    scene.targetLps = random.inBox(12.0);
    scene.eyeLps =
        scene.targetLps + glm::normalize(random.inBox(1.0) + 1e-3) * random.between(60.0, 200.0);
    scene.heightMm = random.between(25.0, 130.0);
    scene.surfaceThreshold = 400.0;
    scene.mipWindow = {1200.0, 2200.0};
    scene.xrayWindow = {600.0, 1400.0};
    scene.transferFunction.points = {
        {300.0, 0x8a4b32, 0.0}, {600.0, 0xd9a066, 0.08}, {2500.0, 0xf2e4c4, 0.5}};
    return scene;
}

core::VoxelBox randomBox(Random& random, const glm::ivec3& size)
{
    const glm::dvec3 room(size - 12);
    const glm::ivec3 low(glm::floor((random.inBox(0.5) + 0.5) * room));
    return {low, low + 3 + glm::ivec3(glm::floor((random.inBox(0.5) + 0.5) * 8.0))};
}

/// The pixel in which a place is seen; x < 0: not before the eye.
glm::dvec2 pixelOf(const VolumeScene& scene, const glm::dvec3& lps)
{
    const glm::dvec3 forward = glm::normalize(scene.targetLps - scene.eyeLps);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, scene.up));
    const glm::dvec3 down = glm::cross(forward, right);
    const double perMm = frameSize.y / scene.heightMm;
    const glm::dvec3 from = lps - scene.targetLps;
    glm::dvec2 place(glm::dot(from, right), glm::dot(from, down));
    if (!scene.orthographic) {
        const double depth = glm::dot(lps - scene.eyeLps, forward);
        if (depth <= 1e-6)
            return {-1.0, -1.0};
        place *= glm::distance(scene.eyeLps, scene.targetLps) / depth;
    }
    return 0.5 * glm::dvec2(frameSize) + place * perMm;
}

RayBlocks::Kind kindAt(const RayBlocks& blocks, const glm::ivec2& pixel)
{
    const auto parts =
        blocks.split({pixel / RayBlocks::block * RayBlocks::block, glm::ivec2(RayBlocks::block)});
    for (std::size_t kind = 0; kind < parts.size(); ++kind)
        if (!parts[kind].empty())
            return RayBlocks::Kind(kind);
    return RayBlocks::Kind::Plain;
}

} // namespace

/// Blocks of a picture are drawn by the simplest program that draws them right.
class RayBlocksGlTest : public test::GlTest {
    Q_OBJECT

    static constexpr glm::ivec3 size{88, 80, 72};
    int m_rounds = qEnvironmentVariableIsSet("BURIN_LONG") ? 40 : 2;

    static void open(test::FrameFixture& fixture, Random& random)
    {
        fixture.open(test::centredGeometry(size, {1.0, 1.1, 0.9}), ball);
        fixture.fill(VolumeField::Radiation, randomBox(random, size), 255);
        const core::VoxelBox segment = randomBox(random, size);
        fixture.fill(VolumeField::Labels, segment, 1);
        fixture.fill(VolumeField::Segmentation, segment, 255);
    }

private Q_SLOTS:
    void drawTheSame_data()
    {
        QTest::addColumn<int>("mode");
        QTest::newRow("surface") << int(RenderMode::Surface);
        QTest::newRow("volume rendering") << int(RenderMode::Dvr);
        QTest::newRow("MIP") << int(RenderMode::Mip);
        QTest::newRow("X-ray") << int(RenderMode::Xray);
    }

    void drawTheSame()
    {
        QFETCH(int, mode);
        const QTemporaryDir folder;
        test::FrameFixture sorted;
        test::FrameFixture all(oneKind(folder));
        SegmentDisplay segments;
        segments.rgb[1] = 0x4AA3FF;
        segments.visible[1] = true;
        Random random{std::mt19937(unsigned(mode) + 11)};
        int plain = 0;
        for (int round = 0; round < m_rounds; ++round) {
            Random again = random;
            open(sorted, random);
            open(all, again);
            const VolumeScene scene = randomScene(random, RenderMode(mode));
            const Frame a = sorted.draw(scene, frameSize, segments);
            const Frame b = all.draw(scene, frameSize, segments);
            int off = 0;
            int most = 0;
            for (int y = 0; y < frameSize.y; ++y) {
                for (int x = 0; x < frameSize.x; ++x) {
                    const glm::ivec3 apart = glm::abs(test::pixel(a, x, y) - test::pixel(b, x, y));
                    const int worst = std::max({apart.r, apart.g, apart.b});
                    off += worst > 1 ? 1 : 0;
                    most = std::max(most, worst);
                }
            }
            QVERIFY2(off <= frameSize.x * frameSize.y / 1000 && most <= 3,
                qPrintable(QStringLiteral("round %1: %2 pixels off, by up to %3")
                               .arg(round)
                               .arg(off)
                               .arg(most)));
            const RayBlocks blocks(sorted.volume, scene, {.frameSize = frameSize});
            const auto parts = blocks.split({{0, 0}, frameSize});
            plain += parts[0].empty() ? 0 : 1;
        }
        QVERIFY(plain > 0); // else nothing was compared
    }

    /// What a tile is split into covers each of its pixels once, whatever the scale.
    void splitsWithoutGaps()
    {
        test::FrameFixture fixture;
        Random random{std::mt19937(3)};
        for (int round = 0; round < m_rounds; ++round) {
            open(fixture, random);
            const VolumeScene scene = randomScene(random, RenderMode::Dvr);
            const int factor = 1 + round % 4;
            const glm::ivec2 drawn = (frameSize + (factor - 1)) / factor;
            const RayBlocks blocks(fixture.volume, scene,
                {.frameSize = frameSize, .pixelScale = float(frameSize.x) / float(drawn.x)});
            std::vector<int> covered(std::size_t(drawn.x * drawn.y));
            TilePlan plan(drawn);
            while (!plan.finished()) {
                for (const auto& part : blocks.split(plan.take(random.between(1.0, 60000.0))))
                    for (const Tile& tile : part)
                        for (int y = 0; y < tile.size.y; ++y)
                            for (int x = 0; x < tile.size.x; ++x)
                                ++covered[std::size_t(
                                    (tile.minimum.y + y) * drawn.x + tile.minimum.x + x)];
            }
            QCOMPARE(std::count(covered.begin(), covered.end(), 1), std::ptrdiff_t(covered.size()));
        }
    }

    /// Every place of a cut or a piece, and what is near enough to be looked at, lies in a block of
    /// its kind.
    void knowWhatIsNear()
    {
        test::FrameFixture fixture;
        Random random{std::mt19937(7)};
        int looked = 0;
        for (int round = 0; round < 4 * m_rounds; ++round) {
            const core::VolumeGeometry geometry = test::centredGeometry(size, {1.0, 1.1, 0.9});
            fixture.open(geometry, ball);
            const core::VoxelBox cut = randomBox(random, size);
            reference::DenseFields state(size);
            for (int z = cut.minimum.z; z < cut.maximum.z; ++z)
                for (int y = cut.minimum.y; y < cut.maximum.y; ++y)
                    for (int x = cut.minimum.x; x < cut.maximum.x; ++x)
                        state.coverage(1).at({x, y, z}) = 255;
            fixture.put(state);
            VolumeScene scene = randomScene(random, RenderMode::Surface);
            core::Piece piece;
            piece.pivotLps = random.inBox(10.0);
            piece.pose.offsetMm = random.inBox(25.0);
            piece.pose.rotationDegrees = random.inBox(90.0);
            piece.pose.zoom = random.between(0.5, 2.0);
            const bool withPiece = round % 2 == 1;
            const glm::dmat4 shownFromTrue = core::shownFromTrue(piece, {});
            if (withPiece)
                scene.pieces = {{.id = 1, .layer = 1, .shownFromTrue = shownFromTrue}};
            fixture.draw(scene, frameSize);
            const RayBlocks blocks(fixture.volume, scene, {.frameSize = frameSize});
            for (int look = 0; look < 200; ++look) {
                const glm::dvec3 inside = glm::dvec3(cut.minimum)
                    + (random.inBox(0.5) + 0.5) * glm::dvec3(cut.maximum - cut.minimum - 1);
                // The farthest look of ambient occlusion goes 15.9 mm.
                const glm::dvec3 near = glm::normalize(random.inBox(1.0)) * random.between(0, 15.9);
                const glm::dvec3 trueLps =
                    glm::dvec3(geometry.indexToWorld * glm::dvec4(inside, 1.0)) + near;
                const glm::dvec3 lps =
                    withPiece ? glm::dvec3(shownFromTrue * glm::dvec4(trueLps, 1.0)) : trueLps;
                const glm::dvec2 seenAt = pixelOf(scene, lps);
                if (!(seenAt.x >= 0.0 && seenAt.y >= 0.0 && seenAt.x < frameSize.x
                        && seenAt.y < frameSize.y))
                    continue;
                ++looked;
                QCOMPARE(kindAt(blocks, glm::ivec2(seenAt)),
                    withPiece ? RayBlocks::Kind::Pieces : RayBlocks::Kind::Carved);
            }
        }
        QVERIFY(looked > 50 * m_rounds);
    }
};

BURIN_TEST(RayBlocksGlTest)

} // namespace rayBlocksGlTest

#include "RayBlocksGlTest.moc"
