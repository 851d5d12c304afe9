// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/SurfaceUpdate.h"
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/fixtures/frames/ViewRays.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SimplexShapes.h"

#include <QTest>

#include <cmath>

namespace stereoGlTest {

using namespace gpu;

namespace {

const glm::ivec2 size(160, 120);
constexpr double eyeShiftMm = 15.0;
constexpr double distanceMm = 240.0;

VolumeScene scene(bool orthographic)
{
    VolumeScene result;
    result.targetLps = {2.0, 1.0, -3.0};
    result.eyeLps = result.targetLps + distanceMm * glm::normalize(glm::dvec3(0.5, -1.0, 0.4));
    result.heightMm = 90.0;
    result.orthographic = orthographic;
    result.surfaceThreshold = 1000.0;
    result.transferFunction.points = {{990.0, 0xFFFFFF, 0.0}, {1000.0, 0xFFFFFF, 0.9}};
    return result;
}

/// A place so far to the right of the target, below and behind it.
glm::dvec3 placeIn(const VolumeScene& view, const glm::dvec3& mm)
{
    const glm::dvec3 forward = glm::normalize(view.targetLps - view.eyeLps);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, view.up));
    return view.targetLps + right * mm.x + glm::cross(forward, right) * mm.y + forward * mm.z;
}

/// The middle of all that is lit. @param evenly by how much: it looks the same everywhere
glm::dvec2 middleOf(const Frame& frame, bool evenly)
{
    glm::dvec2 sum(0.0);
    double weight = 0.0;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            // What is lit from one side counts where it is lit at all.
            const double lit = evenly      ? test::pixel(frame, x, y).g
                : test::isLit(frame, x, y) ? 1.0
                                           : 0.0;
            sum += lit * glm::dvec2(x + 0.5, y + 0.5);
            weight += lit;
        }
    }
    if (weight < 20.0)
        qFatal("nothing is seen");
    return sum / weight;
}

} // namespace

/// Pictures of two eyes: what lies in the target's plane is at one place in both, the rest is moved
/// as it lies, and all that is drawn agrees.
class StereoGlTest : public test::FrameTest {
    Q_OBJECT

    enum What { Matter, Volume, Surface, Plane };

    /// The middle of a thing at a place, drawn alone.
    glm::dvec2 seen(VolumeScene view, What what, const glm::dvec3& lps)
    {
        const bool matter = what == Matter || what == Volume;
        m_fixture->open(test::centredGeometry({96, 96, 96}), [=](const glm::dvec3& at) {
            return matter ? 1000.0 + 200.0 * (4.0 - glm::length(at - lps)) : 0.0;
        });
        view.mode = what == Volume ? RenderMode::Dvr : RenderMode::Surface;
        if (what == Surface) {
            m_fixture->scheduler.updateSurface(
                core::wholeUpdate(test::simplexMesh(test::moved(test::icosphere(4.0, 4), lps))));
            view.surface = SceneSurface{};
        }
        if (what == Plane) {
            ScenePlane plane;
            const glm::dvec3 forward = glm::normalize(view.targetLps - view.eyeLps);
            plane.rightLps = glm::normalize(glm::cross(forward, view.up));
            plane.downLps = glm::cross(forward, plane.rightLps);
            plane.centreLps = lps;
            plane.halfSizeMm = {4.0, 4.0};
            plane.window = {0.5, 2.0}; // all of it is lit
            view.plane = plane;
        }
        return middleOf(m_fixture->draw(view, size), what == Plane);
    }

private Q_SLOTS:
    void placesAreMovedAsTheyLie_data()
    {
        QTest::addColumn<int>("what");
        QTest::addColumn<bool>("orthographic");
        for (const bool orthographic : {true, false}) {
            const char* camera = orthographic ? "orthographic" : "perspective";
            QTest::addRow("matter, %s", camera) << int(Matter) << orthographic;
            QTest::addRow("volume rendering, %s", camera) << int(Volume) << orthographic;
            QTest::addRow("surface, %s", camera) << int(Surface) << orthographic;
            QTest::addRow("plane, %s", camera) << int(Plane) << orthographic;
        }
    }
    void placesAreMovedAsTheyLie()
    {
        QFETCH(int, what);
        QFETCH(bool, orthographic);
        VolumeScene left = scene(orthographic);
        VolumeScene right = left;
        left.eyeShiftMm = -eyeShiftMm;
        right.eyeShiftMm = eyeShiftMm;
        const double mmPerPixel = left.heightMm / size.y;
        for (const double behind : {0.0, -30.0, 26.0}) {
            const glm::dvec3 lps = placeIn(left, {6.0, -5.0, behind});
            const glm::dvec2 one = seen(left, What(what), lps);
            const glm::dvec2 other = seen(right, What(what), lps);
            const double depth = orthographic ? distanceMm : distanceMm + behind;
            const double moved = 2.0 * eyeShiftMm * behind / depth / mmPerPixel;
            const QString text = QStringLiteral("%1 mm behind: moved by %2, %3 pixels, not %4")
                                     .arg(behind)
                                     .arg(other.x - one.x)
                                     .arg(other.y - one.y)
                                     .arg(moved);
            // Balls are drawn out a little, each to its side.
            QVERIFY2(std::abs(other.x - one.x - moved) < 0.25, qPrintable(text));
            QVERIFY2(std::abs(other.y - one.y) < 0.25, qPrintable(text));
            // And where a plain eye sees it is the middle of both.
            const glm::dvec2 between = seen(scene(orthographic), What(what), lps);
            QVERIFY2(glm::length(between - 0.5 * (one + other)) < 0.25, qPrintable(text));
        }
    }

    /// Silhouettes in one eye's picture are those of its rays.
    void silhouettesAreThoseOfTheRays_data()
    {
        QTest::addColumn<bool>("surface");
        QTest::addColumn<bool>("orthographic");
        for (const bool surface : {false, true}) {
            const char* what = surface ? "surface" : "matter";
            QTest::addRow("%s, orthographic", what) << surface << true;
            QTest::addRow("%s, perspective", what) << surface << false;
        }
    }
    void silhouettesAreThoseOfTheRays()
    {
        QFETCH(bool, surface);
        QFETCH(bool, orthographic);
        const glm::dvec3 centre(7.0, -12.0, 6.0);
        constexpr double radius = 24.0;
        m_fixture->open(test::centredGeometry({96, 96, 96}), [=](const glm::dvec3& at) {
            return surface ? 0.0 : 1000.0 + 100.0 * (radius - glm::length(at - centre));
        });
        VolumeScene view = scene(orthographic);
        view.eyeShiftMm = 4.0 * eyeShiftMm; // more than any head has
        if (surface) {
            m_fixture->scheduler.updateSurface(core::wholeUpdate(
                test::simplexMesh(test::moved(test::icosphere(radius, 5), centre))));
            view.surface = SceneSurface{};
        }
        const Frame frame = m_fixture->draw(view, size);
        int inside = 0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const double gap =
                    test::gapToSphere(test::rayOf(view, size, x + 0.5, y + 0.5), centre, radius);
                if (std::abs(gap) < view.heightMm / size.y)
                    continue;
                QVERIFY2(test::isLit(frame, x, y) == (gap < 0.0),
                    qPrintable(QStringLiteral("(%1, %2): %3 mm").arg(x).arg(y).arg(gap)));
                inside += gap < 0.0 ? 1 : 0;
            }
        }
        QVERIFY(inside > 2000);
    }

    /// Matter and a surface of the same place tie in every pixel, in any eye.
    void waysAreOfOneEye_data()
    {
        QTest::addColumn<bool>("orthographic");
        QTest::newRow("orthographic") << true;
        QTest::newRow("perspective") << false;
    }
    void waysAreOfOneEye()
    {
        QFETCH(bool, orthographic);
        constexpr double radius = 24.0;
        m_fixture->open(test::centredGeometry({96, 96, 96}),
            [=](const glm::dvec3& at) { return 1000.0 + 100.0 * (radius - glm::length(at)); });
        VolumeScene view = scene(orthographic);
        view.eyeShiftMm = 3.0 * eyeShiftMm;
        SceneSurface look;
        look.colours = {.rgb = 0x0000FF, .markOpacity = 0.0f};
        look.behindOpacity = 0.0f;
        view.surface = look;
        // Four millimetres before the matter, and four behind its face.
        for (const double apart : {4.0, -4.0}) {
            m_fixture->scheduler.updateSurface(
                core::wholeUpdate(test::simplexMesh(test::icosphere(radius + apart, 5))));
            const Frame frame = m_fixture->draw(view, size);
            int compared = 0;
            for (int y = 0; y < size.y; ++y) {
                for (int x = 0; x < size.x; ++x) {
                    if (test::gapToSphere(
                            test::rayOf(view, size, x + 0.5, y + 0.5), glm::dvec3(0.0), radius)
                        > -7.0)
                        continue;
                    const glm::ivec3 rgb = test::pixel(frame, x, y);
                    QCOMPARE(rgb.b > rgb.r + 20, apart > 0.0);
                    ++compared;
                }
            }
            QVERIFY(compared > 800);
        }
    }
};

BURIN_TEST(StereoGlTest)

} // namespace stereoGlTest

#include "StereoGlTest.moc"
