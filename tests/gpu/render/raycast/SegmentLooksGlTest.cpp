// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SlabScene.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace segmentLooksGlTest {

using namespace gpu;

namespace {

constexpr std::uint32_t blue = 0x2060FF;
constexpr std::uint32_t red = 0xF03020;
constexpr double half = 128.0 / 255.0; ///< 50 %, as the palette holds it
const glm::ivec2 size(96, 96);

glm::ivec3 rgbOf(std::uint32_t rgb)
{
    return {int(rgb >> 16), int(rgb >> 8 & 0xFFu), int(rgb & 0xFFu)};
}

int apart(const glm::ivec3& a, const glm::ivec3& b)
{
    const glm::ivec3 off = glm::abs(a - b);
    return std::max({off.r, off.g, off.b});
}

/// Of two colours; the share is that of the second.
glm::ivec3 mixed(const glm::ivec3& a, const glm::ivec3& b, double share)
{
    return glm::ivec3(glm::round(glm::mix(glm::dvec3(a), glm::dvec3(b), share)));
}

QString text(const glm::ivec3& seen, const glm::ivec3& expected)
{
    return QStringLiteral("%1 %2 %3 instead of %4 %5 %6")
        .arg(seen.r)
        .arg(seen.g)
        .arg(seen.b)
        .arg(expected.r)
        .arg(expected.g)
        .arg(expected.b);
}

SegmentDisplay shown(int transparencyPercent = 0, bool voxelTrue = false)
{
    SegmentDisplay display;
    display.rgb[1] = blue;
    display.rgb[2] = red;
    display.visible[1] = display.visible[2] = true;
    display.transparencyPercent[1] = std::uint8_t(transparencyPercent);
    display.voxelTrue = voxelTrue;
    return display;
}

/// The share of the three most frequent colours among all pixels that are not black.
double shareOfThreeColours(const Frame& frame)
{
    struct Colour {
        glm::ivec3 rgb;
        int count = 0;
    };
    std::vector<Colour> colours;
    int lit = 0;
    for (int y = 0; y < frame.sizePixels.y; ++y) {
        for (int x = 0; x < frame.sizePixels.x; ++x) {
            const glm::ivec3 rgb = test::pixel(frame, x, y);
            if (rgb == glm::ivec3(0))
                continue;
            ++lit;
            const auto found = std::find_if(colours.begin(), colours.end(),
                [&rgb](const Colour& each) { return apart(each.rgb, rgb) <= 2; });
            if (found == colours.end())
                colours.push_back({rgb, 1});
            else
                ++found->count;
        }
    }
    std::sort(colours.begin(), colours.end(),
        [](const Colour& a, const Colour& b) { return a.count > b.count; });
    int most = 0;
    for (std::size_t i = 0; i < std::min<std::size_t>(colours.size(), 3); ++i)
        most += colours[i].count;
    return lit > 0 ? double(most) / lit : 0.0;
}

} // namespace

/// Translucent segments, and segments as their voxels are.
class SegmentLooksGlTest : public test::FrameTest {
    Q_OBJECT

    void put(const core::VoxelBox& box, int label)
    {
        m_fixture->fill(VolumeField::Labels, box, std::uint8_t(label));
        m_fixture->fill(VolumeField::Segmentation, box, 255);
    }
    /// A ball of segment 2, of ten voxels' radius, in a block of another segment; 0: alone.
    void putBall(int block)
    {
        constexpr int side = 64;
        std::vector<std::uint8_t> labels;
        for (int z = 0; z < side; ++z) {
            for (int y = 0; y < side; ++y) {
                for (int x = 0; x < side; ++x) {
                    const glm::dvec3 away = glm::dvec3(x, y, z) - 31.5;
                    const glm::dvec3 far = glm::abs(away);
                    const bool inBlock = std::max({far.x, far.y, far.z}) < 14.0;
                    labels.push_back(std::uint8_t(glm::length(away) < 10.0 ? 2
                            : inBlock                                      ? block
                                                                           : 0));
                }
            }
        }
        std::vector<std::uint8_t> bodies;
        for (const std::uint8_t label : labels)
            bodies.push_back(label != 0 ? 255 : 0);
        m_fixture->volume.labels().upload<std::uint8_t>(labels);
        m_fixture->volume.segmentation().upload<std::uint8_t>(bodies);
        for (const VolumeField field : {VolumeField::Labels, VolumeField::Segmentation})
            m_fixture->volume.markDirty(field, {glm::ivec3(0), glm::ivec3(side)});
    }
    /// How far the red of a pixel is from the mean of its four neighbours, on average around the
    /// middle of a picture.
    static double roughness(const Frame& frame)
    {
        constexpr int reach = 7; // pixels
        double sum = 0.0;
        int count = 0;
        for (int y = 48 - reach; y < 48 + reach; ++y) {
            for (int x = 48 - reach; x < 48 + reach; ++x) {
                const int beside = test::pixel(frame, x - 1, y).r + test::pixel(frame, x + 1, y).r
                    + test::pixel(frame, x, y - 1).r + test::pixel(frame, x, y + 1).r;
                sum += std::abs(0.25 * beside - test::pixel(frame, x, y).r);
                ++count;
            }
        }
        return sum / count;
    }
    static void addModes()
    {
        QTest::addColumn<int>("mode");
        QTest::newRow("isosurface") << int(RenderMode::Surface);
        QTest::newRow("volume rendering") << int(RenderMode::Dvr);
        QTest::newRow("MIP") << int(RenderMode::Mip);
        QTest::newRow("X-ray") << int(RenderMode::Xray);
    }

private Q_SLOTS:
    void slicesMixByTheOpacity()
    {
        m_fixture->open(
            test::centredGeometry({20, 20, 20}), [](const glm::dvec3&) { return 600.0; });
        m_fixture->fill(VolumeField::Labels, {{5, 5, 5}, {15, 15, 15}}, 1);
        SliceScene scene;
        scene.mmPerPixel = 0.1;
        scene.window = {500.0, 1000.0};
        const glm::ivec2 large(200, 200); // voxel i covers pixels 10·i … 10·i + 9
        const glm::ivec3 grey(153); // ((600 − 499.5) / 999 + 0.5) · 255
        for (const int percent : {0, 50, 95}) {
            SegmentDisplay segments = shown(percent);
            segments.fillOpacity = 0.5f;
            const Frame frame = m_fixture->draw(scene, large, segments);
            QCOMPARE(test::pixel(frame, 20, 100), grey);
            const double opacity = double(100 - percent) / 100.0;
            const glm::ivec3 fill = mixed(grey, rgbOf(blue), 0.5 * opacity);
            const glm::ivec3 line = mixed(grey, rgbOf(blue), opacity);
            const glm::ivec3 inside = test::pixel(frame, 100, 100);
            const glm::ivec3 rim = test::pixel(frame, 50, 100);
            QVERIFY2(apart(inside, fill) <= 1, qPrintable(text(inside, fill)));
            QVERIFY2(apart(rim, line) <= 1, qPrintable(text(rim, line)));
        }
    }

    /// In every mode, half of what is seen is the segment, and half what would be seen without it.
    void tissueIsSeenThroughASegment_data() { addModes(); }
    void tissueIsSeenThroughASegment()
    {
        QFETCH(int, mode);
        m_fixture->open(test::centredGeometry({64, 64, 64}), test::slabBetween(-5.0, 20.0));
        const VolumeScene scene = test::sceneAlongY(RenderMode(mode));
        const Frame without = m_fixture->draw(scene, size, shown());
        put({{26, 18, 26}, {38, 22, 38}}, 1); // in front of the slab
        const Frame opaque = m_fixture->draw(scene, size, shown());
        const Frame through = m_fixture->draw(scene, size, shown(50));
        const glm::ivec3 behind = test::pixel(without, 48, 48);
        const glm::ivec3 before = test::pixel(opaque, 48, 48);
        QVERIFY2(apart(behind, before) > 40, qPrintable(text(before, behind)));
        const glm::ivec3 seen = test::pixel(through, 48, 48);
        const glm::ivec3 expected = mixed(behind, before, half);
        QVERIFY2(apart(seen, expected) <= 3, qPrintable(text(seen, expected)));
        // Beside it nothing changes.
        const glm::ivec3 beside = test::pixel(through, 20, 48);
        QVERIFY(beside != glm::ivec3(0));
        QVERIFY(apart(beside, test::pixel(opaque, 20, 48)) <= 1);
        // And all of it is as it was once it is opaque again.
        QVERIFY(*m_fixture->draw(scene, size, shown()).rgba == *opaque.rgba);
    }

    /// A tumour in a liver; and the liver has no rim of its own that were opaque.
    void anOpaqueSegmentIsSeenInATranslucentOne_data()
    {
        QTest::addColumn<int>("mode");
        QTest::addColumn<int>("context");
        QTest::newRow("isosurface") << int(RenderMode::Surface) << int(Context::Opaque);
        QTest::newRow("volume rendering") << int(RenderMode::Dvr) << int(Context::Opaque);
        QTest::newRow("segments alone") << int(RenderMode::Surface) << int(Context::Hidden);
        QTest::newRow("cut away") << int(RenderMode::Surface) << int(Context::CutAway);
        QTest::newRow("cut away, volume rendering")
            << int(RenderMode::Dvr) << int(Context::CutAway);
    }
    void anOpaqueSegmentIsSeenInATranslucentOne()
    {
        QFETCH(int, mode);
        QFETCH(int, context);
        VolumeScene scene = test::sceneAlongY(RenderMode(mode));
        scene.context = Context(context);
        const core::VoxelBox inner{{28, 22, 28}, {36, 26, 36}};
        m_fixture->open(test::centredGeometry({64, 64, 64}), test::noMatter);
        put(inner, 2);
        const Frame alone = m_fixture->draw(scene, size, shown());
        put({{24, 18, 24}, {40, 30, 40}}, 1);
        m_fixture->fill(VolumeField::Labels, inner, 2);
        const Frame opaque = m_fixture->draw(scene, size, shown());
        const Frame through = m_fixture->draw(scene, size, shown(50));
        const glm::ivec3 seen = test::pixel(through, 48, 48);
        const glm::ivec3 expected =
            mixed(test::pixel(alone, 48, 48), test::pixel(opaque, 48, 48), half);
        QVERIFY2(expected.r > 60, qPrintable(text(expected, seen)));
        QVERIFY2(apart(seen, expected) <= 4, qPrintable(text(seen, expected)));
        int outer = 0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                if (std::max(std::abs(x - 48), std::abs(y - 48)) < 8)
                    continue; // the inner one
                const glm::ivec3 before = test::pixel(opaque, x, y);
                const glm::ivec3 rest = mixed(glm::ivec3(0), before, half);
                const glm::ivec3 here = test::pixel(through, x, y);
                outer += before != glm::ivec3(0) ? 1 : 0;
                QVERIFY2(apart(here, rest) <= 4, qPrintable(text(here, rest)));
            }
        }
        QVERIFY(outer > 50);
    }

    /// Its border is known by whole voxels only, whose steps are not to show in the light: a ball
    /// in a translucent block is less than half as rough as its voxels are alone.
    void anOpaqueBallInATranslucentBlockIsSmooth_data()
    {
        QTest::addColumn<int>("context");
        QTest::newRow("isosurface") << int(Context::Opaque);
        QTest::newRow("segments alone") << int(Context::Hidden);
    }
    void anOpaqueBallInATranslucentBlockIsSmooth()
    {
        QFETCH(int, context);
        VolumeScene scene = test::sceneAlongY(RenderMode::Surface);
        scene.context = Context(context);
        m_fixture->open(test::centredGeometry({64, 64, 64}), test::noMatter);
        putBall(0);
        const double alone = roughness(m_fixture->draw(scene, size, shown()));
        putBall(1);
        const double through = roughness(m_fixture->draw(scene, size, shown(50)));
        qInfo("alone %.2f of 255, by half through the block %.2f", alone, through);
        QVERIFY(alone > 2.0);
        QVERIFY(through / half < 0.5 * alone);
    }

    void whatIsHiddenIsNoneHoweverOpaque()
    {
        m_fixture->open(test::centredGeometry({64, 64, 64}), test::noMatter);
        m_fixture->fill(VolumeField::Labels, {{24, 18, 24}, {40, 30, 40}}, 1);
        SegmentDisplay hidden = shown(50, true);
        hidden.visible[1] = false;
        put({{50, 18, 24}, {56, 30, 40}}, 2); // so that there is something
        const Frame frame = m_fixture->draw(test::sceneAlongY(RenderMode::Surface), size, hidden);
        QCOMPARE(test::pixel(frame, 48, 48), glm::ivec3(0));
        QVERIFY(test::pixel(frame, 48 + 25, 48) != glm::ivec3(0));
    }

    /// From the front a voxel is a square with one colour: that of a flat face.
    void aVoxelIsASquare_data()
    {
        QTest::addColumn<int>("mode");
        QTest::addColumn<int>("context");
        QTest::newRow("isosurface") << int(RenderMode::Surface) << int(Context::Opaque);
        QTest::newRow("volume rendering") << int(RenderMode::Dvr) << int(Context::Opaque);
        QTest::newRow("MIP") << int(RenderMode::Mip) << int(Context::Opaque);
        QTest::newRow("X-ray") << int(RenderMode::Xray) << int(Context::Opaque);
        QTest::newRow("segments alone") << int(RenderMode::Surface) << int(Context::Hidden);
        QTest::newRow("translucent context") << int(RenderMode::Dvr) << int(Context::Translucent);
    }
    void aVoxelIsASquare()
    {
        QFETCH(int, mode);
        QFETCH(int, context);
        VolumeScene scene = test::sceneAlongY(RenderMode(mode));
        scene.context = Context(context);
        scene.heightMm = 32.0;
        const glm::ivec2 fine(128, 128); // 4 pixels per voxel
        // The voxel after the middle, along each axis: right of the middle of the picture, above
        // it.
        const core::VoxelBox one{{32, 32, 32}, {33, 33, 33}};
        const glm::ivec2 low(64, 60);
        m_fixture->open(test::centredGeometry({64, 64, 64}), test::noMatter);
        put(one, 1);
        const auto litPixels = [&](const Frame& frame) {
            int lit = 0;
            for (int y = 0; y < fine.y; ++y)
                for (int x = 0; x < fine.x; ++x)
                    lit += test::pixel(frame, x, y) != glm::ivec3(0) ? 1 : 0;
            return lit;
        };
        const Frame square = m_fixture->draw(scene, fine, shown(0, true));
        QCOMPARE(litPixels(square), 16);
        const glm::ivec3 colour = test::pixel(square, low.x, low.y);
        for (int y = 0; y < 4; ++y) {
            for (int x = 0; x < 4; ++x) {
                const glm::ivec3 here = test::pixel(square, low.x + x, low.y + y);
                QVERIFY(here != glm::ivec3(0));
                QVERIFY2(apart(here, colour) <= 1, qPrintable(text(here, colour)));
            }
        }
        // A smooth one has no corners.
        QVERIFY(litPixels(m_fixture->draw(scene, fine, shown())) != 16);
        put({{24, 30, 24}, {40, 36, 40}}, 1);
        const glm::ivec3 flat = test::pixel(m_fixture->draw(scene, fine, shown()), 64, 64);
        QVERIFY2(apart(colour, flat) <= 2, qPrintable(text(colour, flat)));
    }

    /// Steps of voxels have three directions, and so three colours.
    void stepsShowThreeFaces()
    {
        m_fixture->open(test::centredGeometry({64, 64, 64}), test::noMatter);
        for (int z = 0; z < 5; ++z)
            for (int y = 0; y + z < 5; ++y)
                put({{30, 30 + y, 30 + z}, {35 - y - z, 31 + y, 31 + z}}, 1);
        VolumeScene scene = test::sceneAlongY(RenderMode::Surface);
        scene.eyeLps = {200.0, 150.0, 180.0};
        scene.targetLps = {0.5, 0.5, 0.5};
        scene.heightMm = 10.0;
        const glm::ivec2 fine(160, 160);
        const double faces = shareOfThreeColours(m_fixture->draw(scene, fine, shown(0, true)));
        const double smooth = shareOfThreeColours(m_fixture->draw(scene, fine, shown()));
        QVERIFY2(faces > 0.5, qPrintable(QString::number(faces)));
        QVERIFY2(smooth < faces, qPrintable(QString::number(smooth)));
    }

    /// The segment that is drawn as a surface has no voxels either; slices show it.
    void whatHasNoBodyHasNoVoxels()
    {
        m_fixture->open(test::centredGeometry({64, 64, 64}), test::noMatter);
        put({{24, 18, 24}, {40, 30, 40}}, 1);
        VolumeScene scene = test::sceneAlongY(RenderMode::Surface);
        const SegmentDisplay display = shown(0, true);
        QVERIFY(test::pixel(m_fixture->draw(scene, size, display), 48, 48) != glm::ivec3(0));
        scene.bodiless = 1;
        QCOMPARE(test::pixel(m_fixture->draw(scene, size, display), 48, 48), glm::ivec3(0));
    }
};

BURIN_TEST(SegmentLooksGlTest)

} // namespace segmentLooksGlTest

#include "SegmentLooksGlTest.moc"
