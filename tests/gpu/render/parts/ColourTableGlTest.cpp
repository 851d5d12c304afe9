// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <cmath>
#include <cstdlib>

namespace colourTableGlTest {

using namespace gpu;

namespace {

constexpr int side = 16; // one voxel of each value, 0 … 255, in every slice
constexpr int pixelsPerVoxel = 4;
/// Grey is value / 255.
constexpr core::WindowLevel everyValue{128.0, 256.0};

glm::ivec3 colourOf(ColourMap map, int grey)
{
    const std::uint32_t rgb = entriesOf(map)[std::size_t(grey)];
    return {int(rgb >> 16), int(rgb >> 8 & 255U), int(rgb & 255U)};
}

bool near(const glm::ivec3& a, const glm::ivec3& b)
{
    return std::abs(a.r - b.r) <= 1 && std::abs(a.g - b.g) <= 1 && std::abs(a.b - b.b) <= 1;
}

QString text(const glm::ivec3& colour)
{
    return QStringLiteral("%1 %2 %3").arg(colour.r).arg(colour.g).arg(colour.b);
}

SliceScene wholeSlice(ColourMap map)
{
    SliceScene scene;
    scene.mmPerPixel = 1.0 / pixelsPerVoxel;
    scene.window = everyValue;
    scene.interpolation = Interpolation::Nearest;
    scene.colours = map;
    return scene;
}

} // namespace

class ColourTableGlTest : public test::FrameTest {
    Q_OBJECT

    void openEveryValue()
    {
        m_fixture->open(test::centredGeometry({side, side, 3}), [](const glm::dvec3& lps) {
            const double middle = 0.5 * (side - 1);
            return std::round(lps.x + middle) + side * std::round(lps.y + middle);
        });
    }
    Frame drawn(const Scene& scene) { return m_fixture->draw(scene, glm::ivec2(64)); }

private Q_SLOTS:
    void slicesShowTheTable_data()
    {
        QTest::addColumn<int>("map");
        QTest::addColumn<bool>("inverted");
        QTest::addColumn<bool>("slab");
        for (int map = 0; map < int(colourMaps); ++map) {
            QTest::addRow("map %d", map) << map << false << false;
            QTest::addRow("map %d, inverted", map) << map << true << false;
            QTest::addRow("map %d, slab", map) << map << false << true;
        }
    }

    void slicesShowTheTable()
    {
        QFETCH(int, map);
        QFETCH(bool, inverted);
        QFETCH(bool, slab);
        openEveryValue();
        SliceScene scene = wholeSlice(ColourMap(map));
        scene.inverted = inverted;
        if (slab)
            scene.slab = {.mode = SlabMode::Maximum, .reach = 1, .stepMm = 1.0};
        const Frame frame = drawn(scene);
        for (int value = 0; value < side * side; ++value) {
            // Inside of the voxel: finer pictures mix what lies half a pixel around.
            const glm::ivec2 at =
                glm::ivec2(value % side, value / side) * pixelsPerVoxel + pixelsPerVoxel / 2;
            const glm::ivec3 seen = test::pixel(frame, at.x, at.y);
            const glm::ivec3 expected =
                colourOf(ColourMap(map), inverted ? side * side - 1 - value : value);
            QVERIFY2(near(seen, expected),
                qPrintable(
                    QStringLiteral("%1: %2, not %3").arg(value).arg(text(seen), text(expected))));
        }
    }

    /// Whatever was drawn in between.
    void mapsDoNotMix()
    {
        openEveryValue();
        const auto grey = *drawn(wholeSlice(ColourMap::Grey)).rgba;
        const auto iron = *drawn(wholeSlice(ColourMap::HotIron)).rgba;
        const auto steps = *drawn(wholeSlice(ColourMap::Pet20Step)).rgba;
        QVERIFY(grey != iron && iron != steps && steps != grey);
        QVERIFY(*drawn(wholeSlice(ColourMap::HotIron)).rgba == iron);
        QVERIFY(*drawn(wholeSlice(ColourMap::Grey)).rgba == grey);
        QVERIFY(*drawn(wholeSlice(ColourMap::HotIron)).rgba == iron);
    }

    /// Outside the volume and where it is carved it is black, and segments keep their colours,
    /// whatever the map makes of black.
    void onlyGreyValuesAreColoured()
    {
        m_fixture->open(test::centredGeometry({20, 20, 20}), [](const glm::dvec3&) { return 0.0; });
        m_fixture->fill(VolumeField::Radiation, {{0, 0, 0}, {6, 20, 20}}, 255);
        m_fixture->fill(VolumeField::Labels, {{12, 0, 0}, {20, 20, 20}}, 3);
        SegmentDisplay segments;
        segments.rgb[3] = 0x64C832;
        segments.visible[3] = true;
        segments.fillOpacity = 1.0f;
        SliceScene scene = wholeSlice(ColourMap::EvenLightness);
        scene.carvedAsHole = true;
        scene.showCarved = false;
        const Frame frame = m_fixture->draw(scene, glm::ivec2(100), segments);
        const int first = 10; // the volume begins there, a voxel is four pixels wide
        QCOMPARE(test::pixel(frame, first / 2, 50), glm::ivec3(0));
        QCOMPARE(test::pixel(frame, first + 2 * pixelsPerVoxel, 50), glm::ivec3(0));
        QVERIFY(near(test::pixel(frame, first + 9 * pixelsPerVoxel, 50),
            colourOf(ColourMap::EvenLightness, 0)));
        QCOMPARE(test::pixel(frame, first + 16 * pixelsPerVoxel, 50), glm::ivec3(0x64, 0xC8, 0x32));
    }

    void mipShowsTheTable_data()
    {
        QTest::addColumn<bool>("sculpted");
        QTest::newRow("whole") << false;
        QTest::newRow("sculpted") << true;
    }

    void mipShowsTheTable()
    {
        QFETCH(bool, sculpted);
        constexpr int value = 200;
        m_fixture->open(
            test::centredGeometry({16, 16, 16}), [](const glm::dvec3&) { return double(value); });
        if (sculpted)
            m_fixture->carveBox({{0, 0, 0}, {3, 3, 3}});
        VolumeScene scene;
        scene.mode = RenderMode::Mip;
        scene.heightMm = 24.0;
        scene.mipWindow = everyValue;
        const Frame grey = drawn(scene);
        QVERIFY(near(test::pixel(grey, 32, 32), glm::ivec3(value)));
        for (int map = 1; map < int(colourMaps); ++map) {
            scene.mipColours = ColourMap(map);
            const Frame frame = drawn(scene);
            QVERIFY2(near(test::pixel(frame, 32, 32), colourOf(ColourMap(map), value)),
                qPrintable(text(test::pixel(frame, 32, 32))));
            // Beside the volume there is nothing to be coloured.
            QCOMPARE(test::pixel(frame, 1, 1), test::pixel(grey, 1, 1));
        }
        // Of other modes it changes nothing.
        scene.mode = RenderMode::Xray;
        scene.xrayWindow = everyValue;
        const auto coloured = *drawn(scene).rgba;
        scene.mipColours = ColourMap::Grey;
        QVERIFY(*drawn(scene).rgba == coloured);
    }

    /// Beside the volume, and where its values are black, whatever a map makes of black: the parts
    /// of a picture are drawn by several programs.
    void mipStaysBlackWhereNothingIsSeen()
    {
        m_fixture->open(test::centredGeometry({16, 16, 16}), [](const glm::dvec3&) { return 0.0; });
        VolumeScene scene;
        scene.mode = RenderMode::Mip;
        scene.heightMm = 24.0;
        scene.mipWindow = everyValue;
        scene.mipColours = ColourMap::EvenLightness;
        for (const bool sculpted : {false, true}) {
            if (sculpted)
                m_fixture->carveBox({{0, 0, 0}, {3, 3, 3}});
            const Frame frame = drawn(scene);
            for (int y = 0; y < frame.sizePixels.y; ++y)
                for (int x = 0; x < frame.sizePixels.x; ++x)
                    QCOMPARE(test::pixel(frame, x, y), glm::ivec3(0));
        }
    }

    void theCuttingPlaneShowsTheTable()
    {
        constexpr int value = 77;
        m_fixture->open(
            test::centredGeometry({16, 16, 16}), [](const glm::dvec3&) { return double(value); });
        VolumeScene scene;
        scene.heightMm = 24.0;
        scene.surfaceThreshold = 1000.0;
        scene.plane = ScenePlane{.centreLps = {0.0, 0.0, 0.0},
            .rightLps = {1.0, 0.0, 0.0},
            .downLps = {0.0, 0.0, -1.0},
            .halfSizeMm = {6.0, 6.0},
            .window = everyValue};
        QVERIFY(near(test::pixel(drawn(scene), 32, 32), glm::ivec3(value)));
        scene.plane->colours = ColourMap::HotMetalBlue;
        QVERIFY(near(test::pixel(drawn(scene), 32, 32), colourOf(ColourMap::HotMetalBlue, value)));
    }
};

BURIN_TEST(ColourTableGlTest)

} // namespace colourTableGlTest

#include "ColourTableGlTest.moc"
