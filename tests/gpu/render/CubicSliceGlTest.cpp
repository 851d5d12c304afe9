// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/fixtures/frames/VoxelNoise.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace cubicSliceGlTest {

using namespace gpu;

namespace {

const glm::ivec2 size(151, 149);

SliceScene oblique()
{
    SliceScene scene;
    scene.centreLps = {1.3, -0.7, 2.1};
    scene.rightLps = glm::normalize(glm::dvec3(1.0, 0.4, 0.2));
    scene.downLps = glm::normalize(glm::cross(scene.rightLps, glm::dvec3(0.3, -1.0, 0.2)));
    scene.mmPerPixel = 0.31;
    scene.window = {2000.0, 4001.0};
    scene.interpolation = Interpolation::Cubic;
    return scene;
}

glm::dvec3 lpsOf(const SliceScene& scene, double x, double y)
{
    return scene.centreLps + scene.rightLps * ((x - size.x / 2.0) * scene.mmPerPixel)
        + scene.downLps * ((y - size.y / 2.0) * scene.mmPerPixel);
}

bool any(const std::vector<Frame>& frames, Frame::Quality quality)
{
    return std::any_of(
        frames.begin(), frames.end(), [=](const Frame& frame) { return frame.quality == quality; });
}

} // namespace

/// Slices that are interpolated by cubics once nothing moves.
class CubicSliceGlTest : public test::FrameTest {
    Q_OBJECT

    FrameRequest request(const SliceScene& scene, bool interacting) const
    {
        return {.view = 1,
            .sizePixels = size,
            .scene = scene,
            .segments = {},
            .interacting = interacting};
    }
    std::vector<Frame> ask(const SliceScene& scene, bool interacting)
    {
        m_fixture->scheduler.request(request(scene, interacting));
        return m_fixture->settle();
    }
    void open()
    {
        const test::VoxelNoise noise(test::tiltedGeometry({40, 30, 24}));
        m_fixture->open(noise.geometry(), noise.codes());
    }

private Q_SLOTS:
    void valuesAreThoseOfTheKernel_data()
    {
        QTest::addColumn<bool>("tilted");
        QTest::addColumn<double>("mmPerPixel");
        QTest::newRow("anisotropic") << false << 0.31;
        QTest::newRow("tilted gantry") << true << 0.31;
        QTest::newRow("magnified") << true << 0.02;
    }
    void valuesAreThoseOfTheKernel()
    {
        QFETCH(bool, tilted);
        QFETCH(double, mmPerPixel);
        const test::VoxelNoise noise(tilted ? test::tiltedGeometry({40, 30, 24})
                                            : test::centredGeometry({40, 30, 24}, {0.7, 1.1, 2.0}));
        m_fixture->open(noise.geometry(), noise.codes());
        SliceScene scene = oblique();
        scene.mmPerPixel = mmPerPixel;
        const std::vector<Frame> frames = ask(scene, false);
        QVERIFY(frames.size() >= 2);
        QCOMPARE(frames.back().quality, Frame::Quality::Refined);
        const auto linear = std::find_if(frames.begin(), frames.end(),
            [](const Frame& frame) { return frame.quality == Frame::Quality::Full; });
        QVERIFY(linear != frames.end());
        double worstLinear = 0.0;
        double worstCubic = 0.0;
        int inside = 0;
        int atBorder = 0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::dvec3 lps = lpsOf(scene, x + 0.5, y + 0.5);
                const double depth = noise.depthOf(lps);
                if (depth < -1e-4)
                    QCOMPARE(test::pixel(frames.back(), x, y), glm::ivec3(0));
                if (depth < 1e-4)
                    continue;
                ++inside;
                atBorder += depth < 1.5 ? 1 : 0;
                worstLinear = std::max(worstLinear,
                    std::abs(test::pixel(*linear, x, y).g
                        - test::greyOf(noise.linearAt(lps), scene.window)));
                worstCubic = std::max(worstCubic,
                    std::abs(test::pixel(frames.back(), x, y).g
                        - test::greyOf(noise.cubicAt(lps), scene.window)));
            }
        }
        qInfo("%d pixels: off by %.3f (linear) and %.3f (cubic) of 255", inside, worstLinear,
            worstCubic);
        QVERIFY(inside > 4000);
        QVERIFY(mmPerPixel < 0.1 || atBorder > 300);
        // Rounding to bytes is half of one, and to half floats before it an eighth.
        QVERIFY(worstLinear < 0.65);
        QVERIFY(worstCubic < 0.65);
    }

    /// Where nobody asks for cubics nothing is otherwise than it was.
    void onlyWhereTheyAreWanted()
    {
        open();
        SliceScene plain = oblique();
        plain.interpolation = Interpolation::Linear;
        const std::vector<Frame> frames = ask(plain, false);
        QVERIFY(!any(frames, Frame::Quality::Full));
        QCOMPARE(frames.back().quality, Frame::Quality::Refined);
        // Nearest voxels are final at once, too, and the same while something moves.
        SliceScene nearest = oblique();
        nearest.interpolation = Interpolation::Nearest;
        const std::vector<Frame> voxels = ask(nearest, false);
        QVERIFY(!any(voxels, Frame::Quality::Full));
        QCOMPARE(voxels.back().quality, Frame::Quality::Refined);
        QVERIFY(*voxels.back().rgba != *frames.back().rgba);
        (void)ask(plain, true);
        const std::vector<Frame> moving = ask(nearest, true);
        QCOMPARE(moving.size(), std::size_t(1));
        QVERIFY(*moving.back().rgba == *voxels.back().rgba);
        // The full picture of a cubic one is the plain one.
        const std::vector<Frame> cubic = ask(oblique(), false);
        const auto full = std::find_if(cubic.begin(), cubic.end(),
            [](const Frame& frame) { return frame.quality == Frame::Quality::Full; });
        QVERIFY(full != cubic.end());
        QVERIFY(*full->rgba == *frames.back().rgba);
        QVERIFY(*cubic.back().rgba != *frames.back().rgba);
    }

    void finerOnceNothingMoves()
    {
        open();
        SliceScene scene = oblique();
        const std::vector<Frame> known = ask(scene, false);
        for (int step = 0; step < 3; ++step) {
            scene.centreLps.x += 0.4;
            const std::vector<Frame> moving = ask(scene, true);
            QVERIFY(!moving.empty());
            QVERIFY(!any(moving, Frame::Quality::Refined));
        }
        // Only that it rests is new.
        std::vector<Frame> frames = ask(scene, false);
        QCOMPARE(frames.size(), std::size_t(1));
        QCOMPARE(frames[0].quality, Frame::Quality::Refined);
        const auto tiles = m_fixture->scheduler.counters().tiles;
        QVERIFY(ask(scene, false).empty());
        QVERIFY(ask(scene, true).empty());
        QCOMPARE(m_fixture->scheduler.counters().tiles, tiles);
        // Back where it was: the picture that was.
        scene = oblique();
        (void)ask(scene, true);
        QVERIFY(*ask(scene, false).back().rgba == *known.back().rgba);
    }

    void plainWhileEditsRun()
    {
        open();
        (void)ask(oblique(), false);
        m_fixture->fill(VolumeField::Labels, {{10, 2, 8}, {20, 20, 16}}, 1);
        const auto before = m_fixture->scheduler.counters().frames;
        for (int i = 0; i < 1000 && m_fixture->scheduler.work(true); ++i) { }
        QCOMPARE(m_fixture->scheduler.counters().frames - before, std::int64_t(1));
        const std::vector<Frame> frames = m_fixture->settle();
        QVERIFY(!frames.empty());
        QCOMPARE(frames.back().quality, Frame::Quality::Refined);
    }

    /// Each sample would take 64 voxels.
    void slabsAreLinear()
    {
        open();
        SliceScene slab = oblique();
        slab.slab = {.mode = SlabMode::Mean, .reach = 2, .stepMm = 0.7};
        const std::vector<Frame> cubic = ask(slab, false);
        QVERIFY(!any(cubic, Frame::Quality::Full));
        slab.interpolation = Interpolation::Linear;
        QVERIFY(*ask(slab, false).back().rgba == *cubic.back().rgba);
    }

    /// The same in the 3D view with a cutting plane.
    void planesAreFinerOnceNothingMoves()
    {
        open();
        VolumeScene view;
        view.eyeLps = {0.0, -300.0, 0.0};
        view.heightMm = 30.0;
        view.surfaceThreshold = 65000.0;
        view.plane = ScenePlane{};
        view.plane->downLps = {0.0, 0.0, -1.0};
        view.plane->window = {2000.0, 4001.0};
        FrameRequest moving{
            .view = 1, .sizePixels = size, .scene = view, .segments = {}, .interacting = true};
        m_fixture->scheduler.request(moving);
        const std::vector<Frame> coarse = m_fixture->settle();
        QVERIFY(!coarse.empty());
        QVERIFY(!any(coarse, Frame::Quality::Refined));
        moving.interacting = false;
        m_fixture->scheduler.request(moving);
        const std::vector<Frame> fine = m_fixture->settle();
        QVERIFY(any(fine, Frame::Quality::Refined));
        m_fixture->scheduler.request(moving);
        QVERIFY(m_fixture->settle().empty());
    }
};

BURIN_TEST(CubicSliceGlTest)

} // namespace cubicSliceGlTest

#include "CubicSliceGlTest.moc"
