// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/SurfaceUpdate.h"
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/fixtures/frames/ViewRays.h"
#include "tests/support/fixtures/frames/VoxelNoise.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SimplexShapes.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace planePassGlTest {

using namespace gpu;

namespace {

const glm::ivec2 size(150, 130);

/// Nothing of the volume itself is seen.
VolumeScene scene(bool orthographic)
{
    VolumeScene result;
    result.eyeLps = {60.0, -190.0, 80.0};
    result.targetLps = {1.0, -0.5, 0.7};
    result.heightMm = 30.0;
    result.orthographic = orthographic;
    result.surfaceThreshold = 65000.0;
    return result;
}

/// Oblique to the view and to the volume.
ScenePlane plane()
{
    ScenePlane result;
    result.centreLps = {0.6, 0.3, -0.4};
    result.rightLps = glm::normalize(glm::dvec3(1.0, 0.4, 0.2));
    result.downLps = glm::normalize(glm::cross(result.rightLps, glm::dvec3(0.3, -1.0, 0.5)));
    result.halfSizeMm = {11.0, 9.0};
    result.window = {2000.0, 4001.0};
    return result;
}

glm::dvec3 normalOf(const ScenePlane& plane)
{
    return glm::cross(plane.rightLps, plane.downLps);
}

/// Where a pixel's ray meets the plane.
glm::dvec3 placeOn(const ScenePlane& plane, const test::PixelRay& ray)
{
    return ray.at(test::mmToPlane(ray, plane.centreLps, normalOf(plane)));
}

/// Millimetres inside of the rectangle's border.
double roomOn(const ScenePlane& plane, const glm::dvec3& lps)
{
    const glm::dvec3 from = lps - plane.centreLps;
    return std::min(plane.halfSizeMm.x - std::abs(glm::dot(from, plane.rightLps)),
        plane.halfSizeMm.y - std::abs(glm::dot(from, plane.downLps)));
}

/// A view straight onto a plane, of the same scale as a slice of it.
VolumeScene facing(const ScenePlane& plane)
{
    VolumeScene result = scene(true);
    result.targetLps = plane.centreLps;
    result.eyeLps = plane.centreLps - 200.0 * normalOf(plane);
    result.up = -plane.downLps;
    return result;
}

SliceScene sliceOf(const ScenePlane& plane, double mmPerPixel)
{
    SliceScene result;
    result.centreLps = plane.centreLps;
    result.rightLps = plane.rightLps;
    result.downLps = plane.downLps;
    result.mmPerPixel = mmPerPixel;
    result.window = plane.window;
    result.inverted = plane.inverted;
    result.showCarved = plane.showCarved;
    return result;
}

} // namespace

/// What the cutting plane shows in the 3D view.
class PlanePassGlTest : public test::FrameTest {
    Q_OBJECT

    void openNoise()
    {
        const test::VoxelNoise noise(test::tiltedGeometry({40, 30, 24}));
        m_fixture->open(noise.geometry(), noise.codes());
    }
    Frame drawWith(VolumeScene view, const ScenePlane& plane, const SegmentDisplay& segments = {})
    {
        view.plane = plane;
        return m_fixture->draw(view, size, segments);
    }
    /// The pictures of one request, the finest of each quality.
    std::array<std::optional<Frame>, 3> drawAll(
        const Scene& scene, const glm::ivec2& frameSize, const SegmentDisplay& segments = {})
    {
        m_fixture->scheduler.request(
            {.view = 5, .sizePixels = frameSize, .scene = scene, .segments = segments});
        std::array<std::optional<Frame>, 3> frames;
        for (Frame& frame : m_fixture->settle())
            frames[std::size_t(frame.quality)] = std::move(frame);
        m_fixture->scheduler.forget(5);
        (void)m_fixture->settle();
        return frames;
    }

private Q_SLOTS:
    void valuesAreThoseOfTheVolume_data()
    {
        QTest::addColumn<bool>("orthographic");
        QTest::addColumn<bool>("tilted");
        QTest::addColumn<double>("shift");
        QTest::addColumn<Interpolation>("interpolation");
        QTest::newRow("orthographic") << true << false << 0.0 << Interpolation::Cubic;
        QTest::newRow("perspective") << false << false << 0.0 << Interpolation::Cubic;
        QTest::newRow("orthographic, tilted gantry") << true << true << 0.0 << Interpolation::Cubic;
        QTest::newRow("perspective, tilted gantry") << false << true << 0.0 << Interpolation::Cubic;
        QTest::newRow("orthographic, right eye") << true << true << 14.0 << Interpolation::Cubic;
        QTest::newRow("perspective, left eye") << false << true << -14.0 << Interpolation::Cubic;
        QTest::newRow("linear") << false << true << 0.0 << Interpolation::Linear;
        QTest::newRow("nearest voxels") << false << true << 0.0 << Interpolation::Nearest;
    }
    void valuesAreThoseOfTheVolume()
    {
        QFETCH(bool, orthographic);
        QFETCH(bool, tilted);
        QFETCH(double, shift);
        QFETCH(Interpolation, interpolation);
        // Until nothing moves.
        const Interpolation first =
            interpolation == Interpolation::Cubic ? Interpolation::Linear : interpolation;
        const test::VoxelNoise noise(tilted ? test::tiltedGeometry({40, 30, 24})
                                            : test::centredGeometry({40, 30, 24}, {0.7, 1.1, 2.0}));
        m_fixture->open(noise.geometry(), noise.codes());
        VolumeScene view = scene(orthographic);
        view.eyeShiftMm = shift;
        view.plane = plane();
        view.plane->interpolation = interpolation;
        const auto frames = drawAll(view, size);
        const auto& full = frames[std::size_t(Frame::Quality::Full)];
        const auto& refined = frames[std::size_t(Frame::Quality::Refined)];
        QVERIFY(full && refined);
        const double pixelMm = view.heightMm / size.y;
        int compared = 0;
        int differing = 0;
        double worstFull = 0.0;
        double worstRefined = 0.0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                double least = 1e9;
                double sum = 0.0;
                for (int picture = 0; picture < test::samplingPoints; ++picture) {
                    const glm::dvec2 at = glm::dvec2(x, y) + 0.5 + test::samplingPoint(picture);
                    const glm::dvec3 lps =
                        placeOn(*view.plane, test::rayOf(view, size, at.x, at.y));
                    least = std::min({least, roomOn(*view.plane, lps) - 4.0 * pixelMm,
                        noise.depthOf(lps) - 1e-3});
                    if (interpolation == Interpolation::Nearest)
                        least = std::min(least, noise.besideBorder(lps) - 1e-3);
                    sum += test::greyOf(noise.at(lps, interpolation), view.plane->window);
                }
                if (least < 0.0)
                    continue;
                const glm::dvec3 lps =
                    placeOn(*view.plane, test::rayOf(view, size, x + 0.5, y + 0.5));
                const double once = test::greyOf(noise.at(lps, first), view.plane->window);
                const double mean = sum / test::samplingPoints;
                worstFull = std::max(worstFull, std::abs(test::pixel(*full, x, y).g - once));
                worstRefined =
                    std::max(worstRefined, std::abs(test::pixel(*refined, x, y).g - mean));
                differing += std::abs(once - mean) > 8.0 ? 1 : 0;
                ++compared;
            }
        }
        qInfo("%d pixels, off by %.2f (full) and %.2f (refined) of 255; the two differ in %d",
            compared, worstFull, worstRefined, differing);
        QVERIFY(compared > 3000);
        QVERIFY(interpolation != Interpolation::Cubic || differing > compared / 4);
        // Half a grey level; and what eight pictures lose that are added up in half floats.
        QVERIFY(worstFull < 0.6);
        QVERIFY(worstRefined < 1.6);
    }

    /// Seen straight on it is the slice to the bit of a grey level: segments, outlines, cuts.
    void isTheSlice_data()
    {
        QTest::addColumn<bool>("inverted");
        QTest::addColumn<bool>("showCarved");
        QTest::newRow("as it is") << false << true;
        QTest::newRow("inverted") << true << true;
        QTest::newRow("without the outline of cuts") << false << false;
    }
    void isTheSlice()
    {
        QFETCH(bool, inverted);
        QFETCH(bool, showCarved);
        m_fixture->open(test::centredGeometry({40, 40, 40}),
            [](const glm::dvec3& lps) { return 2000.0 + 30.0 * lps.x - 40.0 * lps.z; });
        m_fixture->fill(VolumeField::Labels, {{12, 5, 12}, {22, 35, 25}}, 3);
        m_fixture->fill(VolumeField::Radiation, {{24, 8, 15}, {32, 30, 28}}, 255);
        SegmentDisplay segments;
        segments.rgb[3] = 0x64C832;
        segments.visible[3] = true;
        ScenePlane shown = plane();
        shown.rimWidthPixels = 0.0f;
        shown.inverted = inverted;
        shown.showCarved = showCarved;
        VolumeScene view = facing(shown);
        view.plane = shown;
        const auto frames = drawAll(view, size, segments);
        const auto& seen = frames[std::size_t(Frame::Quality::Full)];
        QVERIFY(seen);
        const Frame slice = m_fixture->draw(sliceOf(shown, view.heightMm / size.y), size, segments);
        int compared = 0;
        int tinted = 0;
        int beside = 0; // nearest voxels change between two pixels: one of them may be another's
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::dvec3 lps = placeOn(shown, test::rayOf(view, size, x + 0.5, y + 0.5));
                if (roomOn(shown, lps) < view.heightMm / size.y)
                    continue;
                const glm::ivec3 expected = test::pixel(slice, x, y);
                beside += test::apart(test::pixel(*seen, x, y), expected) > 1 ? 1 : 0;
                tinted += expected.r != expected.g ? 1 : 0;
                ++compared;
            }
        }
        QVERIFY(compared > 5000 && tinted > (showCarved ? 1500 : 500));
        QVERIFY2(beside <= 8, qPrintable(QString::number(beside)));
    }

    void hasARim()
    {
        openNoise();
        ScenePlane shown = plane();
        shown.centreLps = {14.0, 0.3, -0.4}; // beyond the volume somewhere
        shown.halfSizeMm = {13.0, 13.0};
        shown.rimRgb = 0xFF8000;
        shown.rimWidthPixels = 3.0f;
        VolumeScene view = facing(shown);
        const double mm = view.heightMm / size.y;
        const Frame frame = drawWith(view, shown);
        int rim = 0;
        int outside = 0;
        const test::VoxelNoise noise(test::tiltedGeometry({40, 30, 24}));
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::dvec3 lps = placeOn(shown, test::rayOf(view, size, x + 0.5, y + 0.5));
                const double room = roomOn(shown, lps) / mm;
                const glm::ivec3 rgb = test::pixel(frame, x, y);
                if (room < -1.0) {
                    QCOMPARE(rgb, glm::ivec3(0));
                } else if (room > 1.0 && room < 2.0) {
                    QVERIFY(test::apart(rgb, {255, 128, 0}) <= 1);
                    ++rim;
                } else if (room > 5.0 && noise.depthOf(lps) < -0.5) {
                    QCOMPARE(rgb, glm::ivec3(0));
                    ++outside;
                }
            }
        }
        QVERIFY(rim > 200);
        QVERIFY(outside > 200);
        // A hidden plane has none.
        shown.opacity = 0.0f;
        const Frame hidden = drawWith(view, shown);
        QCOMPARE(*hidden.rgba, *m_fixture->draw(view, size).rgba);
    }

    void contourLiesOnTheCircle_data()
    {
        QTest::addColumn<bool>("orthographic");
        QTest::addColumn<bool>("straightOn");
        QTest::addColumn<double>("shift");
        QTest::newRow("straight on") << true << true << 0.0;
        QTest::newRow("orthographic") << true << false << 0.0;
        QTest::newRow("perspective") << false << false << 0.0;
        QTest::newRow("perspective, right eye") << false << false << 12.0;
    }
    void contourLiesOnTheCircle()
    {
        QFETCH(bool, orthographic);
        QFETCH(bool, straightOn);
        QFETCH(double, shift);
        m_fixture->open(test::centredGeometry({60, 60, 60}), [](const glm::dvec3&) { return 0.0; });
        constexpr double radius = 11.0;
        const glm::dvec3 centre(2.0, -1.0, 1.5);
        m_fixture->scheduler.updateSurface(
            core::wholeUpdate(test::simplexMesh(test::moved(test::icosphere(radius, 5), centre))));
        ScenePlane shown = plane();
        shown.halfSizeMm = {40.0, 40.0};
        shown.opacity = 0.0f; // the contour alone
        shown.contour = SceneContour{};
        shown.contour->colours = {.rgb = 0xFFFFFF, .markOpacity = 0.0f};
        VolumeScene view = straightOn ? facing(shown) : scene(orthographic);
        view.eyeLps = straightOn ? view.eyeLps : glm::dvec3(30.0, -60.0, 25.0);
        view.eyeShiftMm = shift;
        const Frame frame = drawWith(view, shown);
        const double height = glm::dot(centre - shown.centreLps, normalOf(shown));
        const glm::dvec3 middle = centre - height * normalOf(shown);
        const double circle = std::sqrt(radius * radius - height * height);
        const auto beyond = [&](double x, double y) {
            return glm::length(placeOn(shown, test::rayOf(view, size, x, y)) - middle) - circle;
        };
        int covered = 0;
        double worst = 0.0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const double gap = beyond(x + 0.5, y + 0.5);
                const glm::dvec2 slope(beyond(x + 1.0, y + 0.5) - beyond(x, y + 0.5),
                    beyond(x + 0.5, y + 1.0) - beyond(x + 0.5, y));
                // Pixels, but for the circle's bend.
                const double pixels = std::abs(gap) / glm::length(slope);
                if (pixels > 4.0) {
                    QVERIFY(!test::isLit(frame, x, y));
                    continue;
                }
                const double expected = std::clamp(0.75 + 0.5 - pixels, 0.0, 1.0);
                const double seen = test::pixel(frame, x, y).g / 255.0;
                worst = std::max(worst, std::abs(seen - expected));
                covered += seen >= 0.5 ? 1 : 0;
            }
        }
        qInfo("%d pixels of the line, off by %.3f at most", covered, worst);
        QVERIFY(covered > 150);
        QVERIFY(worst < 0.08);
    }

    /// Seed B, figure 8: the mask on the plane is reddish while its surface is refined.
    void theMaskIsReddish()
    {
        const core::VolumeGeometry geometry = test::centredGeometry({40, 40, 40});
        m_fixture->open(geometry, [](const glm::dvec3&) { return 2000.0; });
        m_fixture->fill(VolumeField::Labels, {{0, 0, 0}, {20, 40, 40}}, 1);
        m_fixture->fill(VolumeField::Labels, {{20, 0, 0}, {40, 40, 40}}, 2);
        SegmentDisplay segments;
        segments.rgb[1] = segments.rgb[2] = 0x30A050;
        segments.visible[1] = segments.visible[2] = true;
        ScenePlane shown = plane();
        shown.centreLps = {};
        shown.rightLps = {1.0, 0.0, 0.0};
        shown.downLps = {0.0, 1.0, 0.0};
        const VolumeScene view = facing(shown);
        const glm::ivec2 middle = size / 2;
        const glm::ivec2 first = middle - glm::ivec2(size.x / 8, 0);
        const glm::ivec2 second = middle + glm::ivec2(size.x / 8, 0);
        const Frame before = drawWith(view, shown, segments);
        QVERIFY(test::pixel(before, first.x, first.y).g > test::pixel(before, first.x, first.y).r);
        ScenePlane refining = shown;
        refining.mask = 1;
        const Frame refined = drawWith(view, refining, segments);
        const glm::ivec3 mask = test::pixel(refined, first.x, first.y);
        QVERIFY2(mask.r > mask.g + 30 && mask.r > mask.b + 30,
            qPrintable(QStringLiteral("%1 %2 %3").arg(mask.r).arg(mask.g).arg(mask.b)));
        QVERIFY(
            test::pixel(refined, second.x, second.y) == test::pixel(before, second.x, second.y));
    }

    /// When the surface moves the line does, in views that see it.
    void contourIsInStepWithTheSurface()
    {
        m_fixture->open(test::centredGeometry({60, 60, 60}), [](const glm::dvec3&) { return 0.0; });
        const auto show = [this](double radius) {
            m_fixture->scheduler.updateSurface(
                core::wholeUpdate(test::simplexMesh(test::icosphere(radius, 3))));
        };
        show(9.0);
        VolumeScene view = scene(false);
        view.plane = plane();
        view.plane->contour = SceneContour{};
        m_fixture->scheduler.request({.view = 1, .sizePixels = size, .scene = view});
        const Frame first = m_fixture->settle().back();
        show(7.0);
        const std::vector<Frame> frames = m_fixture->settle();
        QVERIFY(!frames.empty());
        QVERIFY(test::mostApart(frames.back(), first) > 60);
        QVERIFY(*m_fixture->draw(view, size).rgba == *frames.back().rgba);
        view.plane->contour.reset();
        m_fixture->scheduler.request({.view = 1, .sizePixels = size, .scene = view});
        (void)m_fixture->settle();
        show(9.0);
        QVERIFY(m_fixture->settle().empty());
    }

    void changesOnItAreDrawn()
    {
        m_fixture->open(
            test::centredGeometry({40, 40, 40}), [](const glm::dvec3&) { return 100.0; });
        VolumeScene view = scene(false);
        view.plane = plane();
        view.plane->rightLps = {1.0, 0.0, 0.0};
        view.plane->downLps = {0.0, 0.0, -1.0}; // y = 0.3: between voxels 19 and 20
        SegmentDisplay segments;
        segments.rgb[1] = 0x00FF00;
        segments.visible[1] = true;
        m_fixture->scheduler.request(
            {.view = 1, .sizePixels = size, .scene = view, .segments = segments});
        const Frame before = m_fixture->settle().back();
        m_fixture->fill(VolumeField::Labels, {{10, 2, 10}, {30, 9, 30}}, 1);
        QVERIFY(m_fixture->settle().empty());
        m_fixture->fill(VolumeField::Labels, {{10, 2, 10}, {30, 30, 30}}, 1);
        const std::vector<Frame> frames = m_fixture->settle();
        QVERIFY(!frames.empty());
        QVERIFY(test::mostApart(frames.back(), before) > 60);
    }

    /// Nowhere to be seen, it leaves the picture as it was.
    void edgeOnAndBehindTheEyeItIsNotSeen()
    {
        openNoise();
        for (const bool orthographic : {true, false}) {
            VolumeScene view = scene(orthographic);
            view.surfaceThreshold = 2600.0;
            const Frame without = m_fixture->draw(view, size);
            QVERIFY(test::isLit(without, size.x / 2, size.y / 2));
            const glm::dvec3 forward = glm::normalize(view.targetLps - view.eyeLps);
            ScenePlane shown = plane();
            // Through the eye, along the view.
            shown.centreLps = view.targetLps;
            shown.rightLps = forward;
            shown.downLps = glm::normalize(glm::cross(forward, glm::dvec3(0.2, 0.3, 1.0)));
            QVERIFY(*drawWith(view, shown).rgba == *without.rgba);
            if (orthographic)
                continue;
            // Behind it.
            shown = plane();
            shown.centreLps = view.eyeLps - 60.0 * forward;
            QVERIFY(*drawWith(view, shown).rgba == *without.rgba);
            // About it: a part is behind the eye, the rest before.
            shown.halfSizeMm = {900.0, 900.0};
            shown.centreLps = view.eyeLps + 3.0 * normalOf(shown);
            (void)drawWith(view, shown);
        }
    }
};

BURIN_TEST(PlanePassGlTest)

} // namespace planePassGlTest

#include "PlanePassGlTest.moc"
