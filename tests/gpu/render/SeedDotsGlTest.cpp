// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SlabScene.h"

#include <QDir>
#include <QTest>

#include <cmath>
#include <numbers>

namespace seedDotsGlTest {

using namespace gpu;

namespace {

const glm::ivec2 size(180, 160);
constexpr double radiusMm = 24.0;

/// Code 1000 on the surface of a sphere around the origin, rising inwards.
double sphere(const glm::dvec3& lps)
{
    return 1000.0 + 100.0 * (radiusMm - glm::length(lps));
}

VolumeScene scene(RenderMode mode)
{
    VolumeScene result;
    result.mode = mode;
    result.eyeLps = {0.0, -200.0, 0.0};
    result.heightMm = 60.0;
    result.surfaceThreshold = 1000.0;
    result.transferFunction.points = {{900.0, 0x808080, 0.0}, {1000.0, 0x808080, 0.9}};
    result.mipWindow = {2000.0, 4001.0};
    result.xrayWindow = {2000.0, 4001.0};
    return result;
}

void setSeeds(VolumeScene& view, std::vector<SceneSeed> seeds)
{
    view.seeds = std::make_shared<const std::vector<SceneSeed>>(std::move(seeds));
}

/// Label 1 is green, 2 is blue.
SegmentDisplay colours()
{
    SegmentDisplay display;
    display.rgb[1] = 0x20D020;
    display.rgb[2] = 0x2040F0;
    display.visible[1] = true;
    display.visible[2] = true;
    return display;
}

/// Pixels in which a channel stands out.
struct Spot {
    int pixels = 0;
    glm::dvec2 centre{0.0};
};

Spot spotOf(const Frame& frame, int channel, int by = 60)
{
    Spot spot;
    for (int y = 0; y < frame.sizePixels.y; ++y) {
        for (int x = 0; x < frame.sizePixels.x; ++x) {
            const glm::ivec3 rgb = test::pixel(frame, x, y);
            if (rgb[channel] < std::max(rgb[(channel + 1) % 3], rgb[(channel + 2) % 3]) + by)
                continue;
            ++spot.pixels;
            spot.centre += glm::dvec2(x + 0.5, y + 0.5);
        }
    }
    if (spot.pixels > 0)
        spot.centre /= spot.pixels;
    return spot;
}

glm::dvec2 pixelOf(const VolumeScene& view, const glm::dvec3& lps)
{
    const double mm = view.heightMm / size.y; // the view along +y: x to the right, z up
    return {size.x / 2.0 + lps.x / mm, size.y / 2.0 - lps.z / mm};
}

} // namespace

class SeedDotsGlTest : public test::FrameTest {
    Q_OBJECT

    void addModes()
    {
        QTest::addColumn<int>("mode");
        QTest::newRow("surface") << int(RenderMode::Surface);
        QTest::newRow("volume rendering") << int(RenderMode::Dvr);
        QTest::newRow("MIP") << int(RenderMode::Mip);
        QTest::newRow("X-ray") << int(RenderMode::Xray);
    }

private Q_SLOTS:
    void aSeedIsARoundDot_data() { addModes(); }
    void aSeedIsARoundDot()
    {
        QFETCH(int, mode);
        m_fixture->open(test::centredGeometry({60, 60, 60}), test::noMatter);
        VolumeScene view = scene(RenderMode(mode));
        // At the corner of four bricks, in its voxel's centre.
        const glm::dvec3 place(2.5, 0.5, 1.5);
        setSeeds(view, {{place, 1}});
        const Spot spot = spotOf(m_fixture->draw(view, size, colours()), 1);
        // One half of a Gaussian with σ = 1.2 voxels lies at σ·√(2 ln 2).
        const double radius = 1.2 * std::sqrt(2.0 * std::numbers::ln2) * size.y / view.heightMm;
        const double area = std::numbers::pi * radius * radius;
        QVERIFY2(std::abs(spot.pixels - area) < 0.3 * area,
            qPrintable(QStringLiteral("%1 pixels, not %2").arg(spot.pixels).arg(area)));
        QVERIFY(glm::length(spot.centre - pixelOf(view, place)) < 0.8);
    }

    void nothingElseChanges_data() { addModes(); }
    void nothingElseChanges()
    {
        QFETCH(int, mode);
        m_fixture->open(test::centredGeometry({60, 60, 60}), sphere);
        VolumeScene view = scene(RenderMode(mode));
        const auto plain = m_fixture->draw(view, size, colours()).rgba;
        setSeeds(view, {});
        QCOMPARE(*m_fixture->draw(view, size, colours()).rgba, *plain);
        // Seeds outside the volume are none.
        setSeeds(view, {{{500.0, 0.0, 0.0}, 1}});
        QCOMPARE(*m_fixture->draw(view, size, colours()).rgba, *plain);
        // And where there are some, pixels away from them stay.
        const glm::dvec3 place(10.5, -radiusMm, 8.5);
        setSeeds(view, {{place, 1}});
        const Frame seeded = m_fixture->draw(view, size, colours());
        const glm::dvec2 at = pixelOf(view, place);
        int differing = 0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const auto i = std::size_t(4 * (y * size.x + x));
                const bool same = (*seeded.rgba)[i] == (*plain)[i]
                    && (*seeded.rgba)[i + 1] == (*plain)[i + 1]
                    && (*seeded.rgba)[i + 2] == (*plain)[i + 2];
                differing += same ? 0 : 1;
                const bool near = glm::length(glm::dvec2(x + 0.5, y + 0.5) - at) < 8.0;
                QVERIFY2(near || mode != int(RenderMode::Mip) || same, "a pixel far from the seed");
            }
        }
        QVERIFY(differing > 20);
    }

    void tissueHidesWhatIsBehindIt_data()
    {
        QTest::addColumn<int>("mode");
        QTest::newRow("surface") << int(RenderMode::Surface);
        QTest::newRow("volume rendering") << int(RenderMode::Dvr);
    }
    void tissueHidesWhatIsBehindIt()
    {
        QFETCH(int, mode);
        m_fixture->open(test::centredGeometry({60, 60, 60}), sphere);
        VolumeScene view = scene(RenderMode(mode));
        setSeeds(view, {{{0.5, -23.5, 0.5}, 1}}); // on the side that is seen
        const Spot before = spotOf(m_fixture->draw(view, size, colours()), 1);
        QVERIFY(before.pixels > 20);
        setSeeds(view, {{{0.5, 23.5, 0.5}, 1}}); // on the other
        const Frame behind = m_fixture->draw(view, size, colours());
        QCOMPARE(spotOf(behind, 1).pixels, 0);
        QVERIFY(spotOf(behind, 1, 3).pixels > 10); // it shines through
    }

    void eachHasItsSegmentsColour()
    {
        core::VolumeGeometry geometry = test::centredGeometry({50, 60, 20}, {1.0, 0.8, 3.0});
        geometry.indexToWorld[2].x = 0.6; // sheared
        m_fixture->open(geometry, test::noMatter);
        VolumeScene view = scene(RenderMode::Surface);
        const glm::dvec3 first = geometry.toWorld({12, 30, 12});
        const glm::dvec3 second = geometry.toWorld({36, 20, 8});
        setSeeds(view, {{first, 1}, {second, 2}});
        const Frame frame = m_fixture->draw(view, size, colours());
        const Spot green = spotOf(frame, 1);
        const Spot blue = spotOf(frame, 2);
        QVERIFY(green.pixels > 20 && blue.pixels > 20);
        QVERIFY(glm::length(green.centre - pixelOf(view, first)) < 1.5);
        QVERIFY(glm::length(blue.centre - pixelOf(view, second)) < 1.5);
    }

    void pieceAndClipLeaveThemWhereTheyAre()
    {
        m_fixture->open(test::centredGeometry({60, 60, 60}), sphere);
        reference::DenseFields fields(glm::ivec3(60));
        auto& coverage = fields.coverage(2);
        for (int z = 40; z < 50; ++z)
            for (int y = 0; y < 30; ++y)
                for (int x = 20; x < 40; ++x)
                    coverage.at({x, y, z}) = 255;
        m_fixture->put(fields);
        for (int mode = 0; mode < int(renderModes); ++mode) {
            VolumeScene view = scene(RenderMode(mode));
            view.clip.box.on = true;
            view.clip.box.minimum = glm::dvec3(2.0);
            view.clip.box.maximum = glm::dvec3(57.0);
            ScenePiece lifted;
            lifted.id = 1;
            lifted.layer = 2;
            lifted.shownFromTrue[3] = glm::dvec4(0.0, -10.0, 20.0, 1.0);
            view.pieces = {lifted};
            const glm::dvec3 place(-10.5, -23.5, -6.5);
            setSeeds(view, {{place, 2}});
            const Spot spot = spotOf(m_fixture->draw(view, size, colours()), 2);
            QVERIFY2(spot.pixels > 20, qPrintable(QString::number(mode)));
            QVERIFY(glm::length(spot.centre - pixelOf(view, place)) < 1.0);
        }
    }

    void strokesLookLikeStrokes()
    {
        m_fixture->open(test::centredGeometry({60, 60, 60}), sphere);
        VolumeScene view = scene(RenderMode::Surface);
        std::vector<SceneSeed> seeds;
        const auto onSphere = [](double along, double up) {
            const glm::dvec3 way = glm::normalize(glm::dvec3(along, -1.0, up));
            return glm::floor(way * radiusMm) + 0.5;
        };
        for (int i = 0; i < 40; ++i)
            seeds.push_back({onSphere(-0.6 + 0.03 * i, 0.2 * std::sin(0.2 * i) + 0.2), 1});
        for (int i = 0; i < 12; ++i)
            seeds.push_back({onSphere(-0.5 + 0.1 * i, -0.4), 2}); // apart
        setSeeds(view, seeds);
        const Frame frame = m_fixture->draw(view, glm::ivec2(720, 640), colours());
        QVERIFY(spotOf(frame, 1).pixels > 3000);
        QVERIFY(spotOf(frame, 2).pixels > 1500);
        const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS");
        if (!folder.isEmpty())
            QVERIFY(test::imageOf(frame).save(QDir(folder).filePath(QStringLiteral("seeds.png"))));
    }
};

BURIN_TEST(SeedDotsGlTest)

} // namespace seedDotsGlTest

#include "SeedDotsGlTest.moc"
