// SPDX-License-Identifier: Apache-2.0
#include "core/growth/SeedWord.h"
#include "gpu/kernels/spread/ToleranceKernel.h"
#include "tests/reference/growth/Tolerance.h"
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/fixtures/frames/VoxelNoise.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <cmath>
#include <cstdlib>

namespace slicePassGlTest {

using namespace gpu;

namespace {

/// DICOM PS3.3 C.11.2.1.2.1, LINEAR, to 0 … 255, as the standard words it.
int windowed(double value, const core::WindowLevel& window)
{
    const double c = window.centre;
    const double w = window.width;
    if (value <= c - 0.5 - (w - 1) / 2)
        return 0;
    if (value > c - 0.5 + (w - 1) / 2)
        return 255;
    return int(std::lround(((value - (c - 0.5)) / (w - 1) + 0.5) * 255.0));
}

/// A slope in all directions: trilinear interpolation has it exactly.
double ramp(const glm::dvec3& lps)
{
    return 2000.0 + 11.0 * lps.x + 17.0 * lps.y - 23.0 * lps.z;
}

glm::dvec3 lpsOf(const SliceScene& scene, const glm::ivec2& size, double x, double y)
{
    return scene.centreLps + scene.rightLps * ((x - size.x / 2.0) * scene.mmPerPixel)
        + scene.downLps * ((y - size.y / 2.0) * scene.mmPerPixel);
}

bool isInside(const core::VolumeGeometry& geometry, const glm::dvec3& lps, double margin)
{
    const glm::dvec3 index = geometry.toIndex(lps);
    for (int axis = 0; axis < 3; ++axis)
        if (index[axis] < -0.5 - margin || index[axis] > geometry.size[axis] - 0.5 + margin)
            return false;
    return true;
}

core::VolumeGeometry tilted()
{
    core::VolumeGeometry geometry = test::centredGeometry({40, 30, 24}, {0.7, 1.1, 2.0});
    geometry.indexToWorld[2][1] = 0.6; // gantry tilt
    geometry.indexToWorld[0][2] = 0.2;
    return geometry;
}

} // namespace

class SlicePassGlTest : public test::FrameTest {
    Q_OBJECT

private Q_SLOTS:
    void equalsWindowLevelOnTheProcessor_data()
    {
        QTest::addColumn<int>("plane");
        QTest::addColumn<bool>("sheared");
        QTest::addColumn<bool>("inverted");
        QTest::newRow("axial") << 0 << false << false;
        QTest::newRow("coronal") << 1 << false << false;
        QTest::newRow("sagittal, MONOCHROME1") << 2 << false << true;
        QTest::newRow("oblique") << 3 << false << false;
        QTest::newRow("axial, tilted gantry") << 0 << true << false;
        QTest::newRow("oblique, tilted gantry") << 3 << true << false;
    }

    void equalsWindowLevelOnTheProcessor()
    {
        QFETCH(int, plane);
        QFETCH(bool, sheared);
        QFETCH(bool, inverted);
        const core::VolumeGeometry geometry =
            sheared ? tilted() : test::centredGeometry({40, 30, 24}, {0.7, 1.1, 2.0});
        core::VoxelEncoding encoding;
        encoding.rescaleIntercept = -300.0;
        m_fixture->open(geometry, ramp, encoding);
        SliceScene scene;
        const glm::dvec3 rights[] = {
            {1, 0, 0}, {1, 0, 0}, {0, 1, 0}, glm::normalize(glm::dvec3(1, 0.4, 0.2))};
        const glm::dvec3 downs[] = {{0, 1, 0}, {0, 0, -1}, {0, 0, -1}, {}};
        scene.rightLps = rights[plane];
        scene.downLps = plane < 3
            ? downs[plane]
            : glm::normalize(glm::cross(scene.rightLps, glm::dvec3(0.3, -1, 0.2)));
        scene.centreLps = {1.3, -0.7, 2.1};
        scene.mmPerPixel = 0.31;
        scene.window = {1700.0, 1000.0};
        scene.inverted = inverted;
        const glm::ivec2 size(151, 149);
        const Frame frame = m_fixture->draw(scene, size);
        QCOMPARE(frame.sizePixels, size);
        int inside = 0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::dvec3 lps = lpsOf(scene, size, x + 0.5, y + 0.5);
                const int seen = test::pixel(frame, x, y).r;
                if (!isInside(geometry, lps, 1e-3)) {
                    QCOMPARE(seen, 0);
                } else if (isInside(geometry, lps, -0.51)) {
                    ++inside;
                    int expected = windowed(ramp(lps) - 300.0, scene.window);
                    expected = inverted ? 255 - expected : expected;
                    // Codes are whole numbers: half a code is 0.13 of a grey level here.
                    QVERIFY2(std::abs(seen - expected) <= 1,
                        qPrintable(QStringLiteral("(%1, %2): %3, not %4")
                                       .arg(x)
                                       .arg(y)
                                       .arg(seen)
                                       .arg(expected)));
                }
            }
        }
        QVERIFY(inside > 2000);
    }

    void nearestShowsVoxels()
    {
        const core::VolumeGeometry geometry = test::centredGeometry({9, 9, 9});
        m_fixture->open(
            geometry, [](const glm::dvec3& lps) { return glm::length(lps) < 0.1 ? 200.0 : 0.0; });
        SliceScene scene;
        scene.mmPerPixel = 0.1;
        scene.window = {100.5, 201.0};
        scene.interpolation = Interpolation::Nearest;
        Frame frame = m_fixture->draw(scene, {40, 40});
        QCOMPARE(test::pixel(frame, 16, 20).r, 255);
        QCOMPARE(test::pixel(frame, 14, 20).r, 0);
        scene.interpolation = Interpolation::Linear;
        frame = m_fixture->draw(scene, {40, 40});
        QVERIFY(test::pixel(frame, 16, 20).r < 200);
        QVERIFY(test::pixel(frame, 14, 20).r > 50);
    }

    /// A narrow window over the whole range of codes: a 256th of a neighbour would be seen.
    void nearestIsTheVoxelsOwnValue_data()
    {
        QTest::addColumn<bool>("tilted");
        QTest::addColumn<bool>("isOblique");
        QTest::addColumn<double>("mmPerPixel");
        QTest::newRow("axial, anisotropic") << false << false << 0.31;
        QTest::newRow("oblique, anisotropic") << false << true << 0.31;
        QTest::newRow("oblique, tilted gantry") << true << true << 0.31;
        QTest::newRow("oblique, magnified") << true << true << 0.02;
        QTest::newRow("oblique, small") << true << true << 1.3;
    }
    void nearestIsTheVoxelsOwnValue()
    {
        QFETCH(bool, tilted);
        QFETCH(bool, isOblique);
        QFETCH(double, mmPerPixel);
        const test::VoxelNoise noise(tilted ? test::tiltedGeometry({40, 30, 24})
                                            : test::centredGeometry({40, 30, 24}, {0.7, 1.1, 2.0}),
            65535);
        m_fixture->open(noise.geometry(), noise.codes());
        SliceScene scene;
        scene.centreLps = {1.3, -0.7, 2.1};
        if (isOblique) {
            scene.rightLps = glm::normalize(glm::dvec3(1, 0.4, 0.2));
            scene.downLps = glm::normalize(glm::cross(scene.rightLps, glm::dvec3(0.3, -1, 0.2)));
        }
        scene.mmPerPixel = mmPerPixel;
        scene.interpolation = Interpolation::Nearest;
        const glm::ivec2 size(151, 149);
        int inside = 0;
        int graded = 0;
        for (const double centre : {9000.0, 31000.0, 52000.0}) {
            scene.window = {centre, 6001.0};
            const Frame frame = m_fixture->draw(scene, size);
            for (int y = 0; y < size.y; ++y) {
                for (int x = 0; x < size.x; ++x) {
                    const glm::dvec3 lps = lpsOf(scene, size, x + 0.5, y + 0.5);
                    if (noise.depthOf(lps) < -1e-3)
                        QCOMPARE(test::pixel(frame, x, y), glm::ivec3(0));
                    if (noise.depthOf(lps) < 1e-3 || noise.besideBorder(lps) < 1e-3)
                        continue;
                    ++inside;
                    const double expected = test::greyOf(noise.nearestAt(lps), scene.window);
                    graded += expected > 0.0 && expected < 255.0 ? 1 : 0;
                    QVERIFY2(std::abs(test::pixel(frame, x, y).g - expected) < 0.65,
                        qPrintable(QStringLiteral("(%1, %2): %3, not %4")
                                       .arg(x)
                                       .arg(y)
                                       .arg(test::pixel(frame, x, y).g)
                                       .arg(expected)));
                }
            }
        }
        qInfo("%d pixels, of which %d are neither black nor white", inside, graded);
        QVERIFY(inside > 1000 && graded > 100);
    }

    void widthOneIsAStep()
    {
        m_fixture->open(test::centredGeometry({9, 9, 9}),
            [](const glm::dvec3& lps) { return lps.x > 0.1 ? 101.0 : 99.0; });
        SliceScene scene;
        scene.mmPerPixel = 1.0;
        scene.window = {100.5, 1.0};
        const Frame frame = m_fixture->draw(scene, {9, 9});
        QCOMPARE(test::pixel(frame, 2, 4).r, 0);
        QCOMPARE(test::pixel(frame, 6, 4).r, 255);
    }

    void segmentsAreFilledAndOutlined()
    {
        m_fixture->open(test::centredGeometry({20, 20, 20}), [](const glm::dvec3&) { return 0.0; });
        m_fixture->fill(VolumeField::Labels, {{5, 5, 5}, {15, 15, 15}}, 3);
        SliceScene scene;
        scene.mmPerPixel = 0.1;
        scene.window = {500.0, 1000.0};
        SegmentDisplay segments;
        segments.rgb[3] = 0x64C832;
        segments.visible[3] = true;
        segments.fillOpacity = 0.5f;
        segments.outlineWidthPixels = 2.0f;
        const glm::ivec2 size(200, 200); // voxel i covers pixels 10·i … 10·i + 9
        Frame frame = m_fixture->draw(scene, size, segments);
        QCOMPARE(test::pixel(frame, 100, 100), glm::ivec3(50, 100, 25));
        QCOMPARE(test::pixel(frame, 50, 100), glm::ivec3(100, 200, 50));
        QCOMPARE(test::pixel(frame, 149, 100), glm::ivec3(100, 200, 50));
        QCOMPARE(test::pixel(frame, 49, 100), glm::ivec3(0));
        QCOMPARE(test::pixel(frame, 150, 100), glm::ivec3(0));
        int outline = 0;
        for (int x = 0; x < size.x; ++x)
            outline += test::pixel(frame, x, 100).g == 200 ? 1 : 0;
        QCOMPARE(outline, 4);
        segments.visible[3] = false;
        frame = m_fixture->draw(scene, size, segments);
        QCOMPARE(test::pixel(frame, 100, 100), glm::ivec3(0));
    }

    void carvedVoxelsAreTinted()
    {
        m_fixture->open(test::centredGeometry({20, 20, 20}), [](const glm::dvec3&) { return 0.0; });
        m_fixture->fill(VolumeField::Radiation, {{5, 5, 5}, {15, 15, 15}}, 255);
        SliceScene scene;
        scene.mmPerPixel = 0.1;
        scene.window = {500.0, 1000.0};
        Frame frame = m_fixture->draw(scene, {200, 200});
        // Interpolated, the cut lies half-way between voxel centres: pixels 50 and 150.
        QVERIFY(test::pixel(frame, 50, 100).r > 180);
        const int within = test::pixel(frame, 100, 100).r;
        QVERIFY(within > 5 && within < 60);
        QCOMPARE(test::pixel(frame, 47, 100).r, 0);
        scene.showCarved = false;
        frame = m_fixture->draw(scene, {200, 200});
        QCOMPARE(test::pixel(frame, 50, 100).r, 0);
    }

    /// A hole is black, with or without its rim; segments are drawn over it.
    void carvedVoxelsAreAHoleOnRequest()
    {
        m_fixture->open(
            test::centredGeometry({20, 20, 20}), [](const glm::dvec3&) { return 600.0; });
        m_fixture->fill(VolumeField::Radiation, {{5, 5, 5}, {15, 15, 15}}, 255);
        m_fixture->fill(VolumeField::Labels, {{8, 5, 5}, {10, 15, 15}}, 3);
        SegmentDisplay segments;
        segments.rgb[3] = 0x64C832;
        segments.visible[3] = true;
        segments.fillOpacity = 0.5f;
        segments.outlineWidthPixels = 2.0f;
        SliceScene scene;
        scene.mmPerPixel = 0.1;
        scene.window = {500.0, 1000.0};
        scene.carvedAsHole = true;
        Frame frame = m_fixture->draw(scene, {200, 200}, segments);
        QCOMPARE(test::pixel(frame, 130, 100), glm::ivec3(0));
        QCOMPARE(test::pixel(frame, 90, 100), glm::ivec3(50, 100, 25));
        QVERIFY(test::pixel(frame, 50, 100).r > 180); // the rim
        QVERIFY(test::pixel(frame, 170, 100).r > 140); // what is left
        scene.showCarved = false;
        frame = m_fixture->draw(scene, {200, 200}, segments);
        QCOMPARE(test::pixel(frame, 130, 100), glm::ivec3(0));
        QCOMPARE(test::pixel(frame, 52, 100), glm::ivec3(0)); // no rim
        scene.carvedAsHole = false;
        frame = m_fixture->draw(scene, {200, 200}, segments);
        QVERIFY(test::pixel(frame, 130, 100).r > 140);
    }

    /// Pictures at a tolerance are those of what the segment would be then.
    void drawsASegmentAtATolerance_data()
    {
        QTest::addColumn<int>("plane");
        QTest::newRow("in the only label plane") << 0;
        QTest::newRow("in a further one") << 1;
        QTest::newRow("in one with an empty number below") << 3;
    }
    void drawsASegmentAtATolerance()
    {
        QFETCH(int, plane);
        const auto its = std::uint8_t(plane);
        const core::VolumeGeometry geometry = test::centredGeometry({40, 30, 24});
        const auto code = [](const glm::dvec3& lps) { return 2000.0 + 10.0 * lps.x; };
        reference::DenseFields now({40, 30, 24});
        now.seedWords(its).at({20, 15, 12}) = core::seedWord::pendingSeed(1);
        for (int x = 2; x < 38; ++x) {
            for (int y = 4; y < 9; ++y) {
                now.labels(its).at({x, y, 12}) = 1; // held before any growth
                now.labels(its).at({x, y + 5, 12}) = 1; // grown
                now.seedWords(its).at({x, y + 5, 12}) = core::seedWord::member(3, 1, 0);
                now.labels(its).at({x, y + 13, 12}) = 2; // another segment's
                now.seedWords(its).at({x, y + 13, 12}) = core::seedWord::member(2, 2, 1);
            }
        }
        if (plane > 0) { // what lies in the first plane stays as it is
            for (int x = 5; x < 30; ++x)
                now.labels(0).at({x, 12, 12}) = 2;
        }
        m_fixture->open(geometry, code);
        m_fixture->put(now);
        TolerancePrograms programs(m_fixture->shaders);
        const core::ToleranceRule rule{.plane = its, .label = 1};
        auto kernel = ToleranceKernel::begin(programs, *m_fixture->edits.fields, rule);
        QVERIFY(kernel);
        while (!(*kernel)->done())
            (*kernel)->advance(7);

        reference::DenseArray<std::uint16_t> codes{
            now.size(), std::vector<std::uint16_t>(40 * 30 * 24)};
        for (int z = 0; z < 24; ++z)
            for (int y = 0; y < 30; ++y)
                for (int x = 0; x < 40; ++x)
                    codes.at({x, y, z}) =
                        std::uint16_t(std::lround(code(geometry.toWorld({x, y, z}))));
        const auto field = reference::traceTolerance(codes, now.composedCoverage({}), now, rule);
        QVERIFY(field);
        SegmentDisplay segments;
        segments.rgb = {};
        segments.rgb[1] = 0x40C060;
        segments.rgb[2] = 0xC04060;
        segments.visible[1] = segments.visible[2] = true;
        segments.growthPlane = its;
        SliceScene scene{.centreLps = geometry.toWorld({19.5, 14.5, 12.0}), .mmPerPixel = 0.25};
        scene.window = {.centre = 2000.0, .width = 800.0};
        const auto drawn = [&](std::optional<int> tolerance) {
            segments.atTolerance.reset();
            if (tolerance)
                segments.atTolerance = ToleranceDisplay{.label = 1, .tolerance = *tolerance};
            return *m_fixture->draw(scene, {160, 120}, segments).rgba;
        };
        const auto expected = [&](int tolerance) {
            reference::DenseFields then = now;
            for (int z = 0; z < 24; ++z) {
                for (int y = 0; y < 30; ++y) {
                    for (int x = 0; x < 40; ++x) {
                        const glm::ivec3 voxel(x, y, z);
                        std::uint8_t& label = then.labels(its).at(voxel);
                        const std::uint32_t word = now.seedWords(its).at(voxel);
                        if (field->at(voxel) && *field->at(voxel) <= tolerance)
                            label = 1;
                        else if (label == 1 && core::seedWord::isMember(word))
                            label = 0;
                    }
                }
            }
            test::FrameFixture other;
            other.open(geometry, code);
            other.put(then);
            SegmentDisplay plain = segments;
            plain.atTolerance.reset();
            return *other.draw(scene, {160, 120}, plain).rgba;
        };
        const auto before = drawn({});
        for (const int tolerance : {0, 95, 40}) {
            const auto picture = drawn(tolerance);
            QVERIFY(picture == expected(tolerance));
            QVERIFY(picture != before);
        }
        segments.growthPlane = its == 0 ? 1 : 0; // the growth of another plane is shown
        QVERIFY(drawn(95) == before);
        segments.growthPlane = its;
        QVERIFY(drawn(95) == expected(95));
        m_fixture->edits.fields->hideTolerance();
        QVERIFY(drawn(95) == before);
    }
};

BURIN_TEST(SlicePassGlTest)

} // namespace slicePassGlTest

#include "SlicePassGlTest.moc"
