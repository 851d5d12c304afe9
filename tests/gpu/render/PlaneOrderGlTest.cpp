// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/SurfaceUpdate.h"
#include "tests/support/fixtures/frames/DemoHeadScene.h"
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/fixtures/frames/ViewRays.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SimplexShapes.h"
#include "tests/support/scenes/SlabScene.h"

#include <QDir>
#include <QTest>

#include <algorithm>
#include <cmath>

namespace planeOrderGlTest {

using namespace gpu;
using test::noMatter;
using test::plainLook;
using test::sceneAlongY;
using test::slabBetween;

namespace {

const glm::ivec2 size(150, 130);
constexpr double radiusMm = 22.0;

/// Across the view; air is dark grey on it, matter light.
ScenePlane planeAt(double y)
{
    ScenePlane plane;
    plane.centreLps = {0.0, y, 0.0};
    plane.downLps = {0.0, 0.0, -1.0};
    plane.halfSizeMm = {30.0, 24.0};
    plane.window = {1200.0, 4001.0};
    return plane;
}

/// Slanting, before the middle.
ScenePlane slanting()
{
    ScenePlane plane = planeAt(-14.0);
    plane.rightLps = glm::normalize(glm::dvec3(1.0, 0.8, 0.1));
    plane.downLps = glm::normalize(glm::cross(glm::dvec3(-0.3, 1.0, 0.2), plane.rightLps));
    plane.halfSizeMm = {40.0, 34.0};
    return plane;
}

double roomOn(const ScenePlane& plane, const test::PixelRay& ray)
{
    const glm::dvec3 from =
        ray.at(test::mmToPlane(ray, plane.centreLps, glm::cross(plane.rightLps, plane.downLps)))
        - plane.centreLps;
    return std::min(plane.halfSizeMm.x - std::abs(glm::dot(from, plane.rightLps)),
        plane.halfSizeMm.y - std::abs(glm::dot(from, plane.downLps)));
}

using Rule = std::function<glm::dvec3(glm::dvec3, glm::dvec3)>;

} // namespace

/// The cutting plane, matter and the surface that is being refined hide each other as they lie.
class PlaneOrderGlTest : public test::FrameTest {
    Q_OBJECT

    void open(const std::function<double(const glm::dvec3&)>& codeAt)
    {
        m_fixture->open(test::centredGeometry({70, 70, 70}), codeAt);
    }
    void showSphere(const glm::dvec3& centreLps, double radius)
    {
        m_fixture->scheduler.updateSurface(core::wholeUpdate(
            test::simplexMesh(test::moved(test::icosphere(radius, 5), centreLps))));
    }
    Frame draw(const VolumeScene& view) { return m_fixture->draw(view, size); }
    Frame drawWith(VolumeScene view, const ScenePlane& plane)
    {
        view.plane = plane;
        return draw(view);
    }
    /// The plane as if there were neither matter nor a surface.
    Frame alone(VolumeScene view, ScenePlane plane)
    {
        view.mode = RenderMode::Surface;
        view.surfaceThreshold = 65000.0;
        view.surface.reset();
        view.clip = {};
        plane.opacity = 1.0f;
        return drawWith(view, plane);
    }
    /// Where all of a plane is seen: the most that a rule on two pictures is off there.
    int mostOff(const Frame& seen, const Frame& one, const Frame& other, const VolumeScene& view,
        const ScenePlane& plane, const Rule& rule)
    {
        int most = 0;
        int compared = 0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                if (roomOn(plane, test::rayOf(view, size, x + 0.5, y + 0.5)) < 3.0)
                    continue;
                const glm::dvec3 expected =
                    rule(glm::dvec3(test::pixel(one, x, y)), glm::dvec3(test::pixel(other, x, y)));
                most = std::max(
                    most, test::apart(test::pixel(seen, x, y), glm::ivec3(glm::round(expected))));
                ++compared;
            }
        }
        if (compared < 1000)
            qFatal("the plane is not in the picture");
        return most;
    }
    static void addModes()
    {
        QTest::addColumn<int>("mode");
        QTest::newRow("surface") << int(RenderMode::Surface);
        QTest::newRow("volume rendering") << int(RenderMode::Dvr);
        QTest::newRow("MIP") << int(RenderMode::Mip);
        QTest::newRow("X-ray") << int(RenderMode::Xray);
    }
    static void addSolidModes()
    {
        QTest::addColumn<int>("mode");
        QTest::newRow("surface") << int(RenderMode::Surface);
        QTest::newRow("volume rendering") << int(RenderMode::Dvr);
    }

private Q_SLOTS:
    void nothingElseChanges_data() { addModes(); }
    void nothingElseChanges()
    {
        QFETCH(int, mode);
        open([](const glm::dvec3& lps) { return 1000.0 + 100.0 * (radiusMm - glm::length(lps)); });
        const VolumeScene view = sceneAlongY(RenderMode(mode));
        const Frame plain = draw(view);
        ScenePlane hidden = planeAt(-30.0);
        hidden.opacity = 0.0f;
        QVERIFY(*drawWith(view, hidden).rgba == *plain.rgba);
        // Pixels beside it.
        ScenePlane small = planeAt(-30.0);
        small.halfSizeMm = {9.0, 7.0};
        const Frame with = drawWith(view, small);
        int differing = 0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const bool same = test::pixel(with, x, y) == test::pixel(plain, x, y);
                differing += same ? 0 : 1;
                QVERIFY(same || roomOn(small, test::rayOf(view, size, x + 0.5, y + 0.5)) > -1.0);
            }
        }
        QVERIFY(differing > 150);
    }

    void matterAndItHideEachOther_data() { addSolidModes(); }
    void matterAndItHideEachOther()
    {
        QFETCH(int, mode);
        const VolumeScene view = sceneAlongY(RenderMode(mode));
        open(slabBetween(-20.0, 20.0));
        const Frame matter = draw(view);
        const auto first = [](glm::dvec3 one, glm::dvec3) { return one; };
        // Before, within and behind the slab.
        const ScenePlane before = planeAt(-30.0);
        const ScenePlane within = planeAt(0.0);
        const ScenePlane behind = planeAt(30.0);
        QVERIFY(
            mostOff(drawWith(view, before), alone(view, before), matter, view, before, first) <= 1);
        QVERIFY(mostOff(drawWith(view, within), matter, matter, view, within, first) <= 1);
        QVERIFY(mostOff(drawWith(view, behind), matter, matter, view, behind, first) <= 1);
        // It shines through what hides it as much as is asked.
        ScenePlane shining = within;
        shining.behindOpacity = 0.3f;
        QVERIFY(mostOff(drawWith(view, shining), matter, alone(view, within), view, within,
                    [](glm::dvec3 one, glm::dvec3 other) { return glm::mix(one, other, 0.3); })
            <= 2);
        // Without the front of the slab the plane in the cut hides the rest of it.
        VolumeScene clipped = view;
        clipped.clip.planes[0] = {
            .pointLps = {0.0, -5.0, 0.0}, .normalLps = {0.0, -1.0, 0.0}, .on = true};
        const ScenePlane open = planeAt(-12.0); // where the clip region hides
        QVERIFY(
            mostOff(drawWith(clipped, open), alone(view, open), matter, view, open, first) <= 1);
    }

    void translucentAsAsked_data() { addModes(); }
    void translucentAsAsked()
    {
        QFETCH(int, mode);
        const VolumeScene view = sceneAlongY(RenderMode(mode));
        open(slabBetween(0.0, 12.0));
        const Frame matter = draw(view);
        ScenePlane plane = planeAt(-20.0);
        plane.opacity = 0.4f;
        const int off = mostOff(drawWith(view, plane), matter, alone(view, plane), view, plane,
            [](glm::dvec3 one, glm::dvec3 other) { return glm::mix(one, other, 0.4); });
        // Volume rendering leaves off where less than 2 % comes through.
        QVERIFY2(off <= (mode == int(RenderMode::Dvr) ? 5 : 2), qPrintable(QString::number(off)));
    }

    void surfaceAndItCutThroughEachOther_data()
    {
        QTest::addColumn<int>("mode");
        QTest::addColumn<bool>("orthographic");
        QTest::addColumn<double>("surfaceOpacity");
        QTest::addColumn<double>("planeOpacity");
        for (const int mode :
            {int(RenderMode::Surface), int(RenderMode::Dvr), int(RenderMode::Mip)}) {
            for (const bool orthographic : {true, false}) {
                const char* camera = orthographic ? "orthographic" : "perspective";
                QTest::addRow("%d, %s, opaque", mode, camera) << mode << orthographic << 1.0 << 1.0;
                QTest::addRow("%d, %s, translucent", mode, camera)
                    << mode << orthographic << 0.5 << 0.4;
            }
        }
    }
    void surfaceAndItCutThroughEachOther()
    {
        QFETCH(int, mode);
        QFETCH(bool, orthographic);
        QFETCH(double, surfaceOpacity);
        QFETCH(double, planeOpacity);
        open(noMatter);
        const glm::dvec3 centre(3.0, -2.0, 4.0);
        showSphere(centre, radiusMm);
        VolumeScene view = sceneAlongY(RenderMode(mode));
        view.orthographic = orthographic;
        ScenePlane plane = slanting();
        plane.opacity = float(planeOpacity);
        plane.window = {100.0, 1001.0};
        const Frame planeAlone = alone(view, plane);
        view.surface = plainLook();
        const Frame surfaceAlone = draw(view);
        view.surface->opacity = float(surfaceOpacity);
        const Frame seen = drawWith(view, plane);
        const double mm = view.heightMm / size.y;
        const glm::dvec3 normal = glm::cross(plane.rightLps, plane.downLps);
        int surfaceFirst = 0;
        int planeFirst = 0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const test::PixelRay ray = test::rayOf(view, size, x + 0.5, y + 0.5);
                const double apart = test::mmToPlane(ray, plane.centreLps, normal)
                    - test::mmToSphere(ray, centre, radiusMm);
                // Both sheets are there, and all of the pixel has one order.
                if (test::gapToSphere(ray, centre, radiusMm) > -3.0 * mm
                    || roomOn(plane, ray) < 3.0 * mm || std::abs(apart) < 2.0)
                    continue;
                const glm::dvec3 surface(test::pixel(surfaceAlone, x, y));
                const glm::dvec3 slice(test::pixel(planeAlone, x, y));
                const glm::dvec3 expected = apart > 0.0
                    ? glm::mix(slice * planeOpacity, surface, surfaceOpacity)
                    : glm::mix(surface * surfaceOpacity, slice, planeOpacity);
                QVERIFY2(
                    test::apart(test::pixel(seen, x, y), glm::ivec3(glm::round(expected))) <= 2,
                    qPrintable(QStringLiteral("(%1, %2), %3 mm").arg(x).arg(y).arg(apart)));
                surfaceFirst += apart > 0.0 ? 1 : 0;
                planeFirst += apart < 0.0 ? 1 : 0;
            }
        }
        QVERIFY2(surfaceFirst > 500 && planeFirst > 500,
            qPrintable(QStringLiteral("%1, %2").arg(surfaceFirst).arg(planeFirst)));
    }

    /// All three, in every order that they can have along a ray.
    void allThreeAtOnce_data() { addSolidModes(); }
    void allThreeAtOnce()
    {
        QFETCH(int, mode);
        VolumeScene view = sceneAlongY(RenderMode(mode));
        open(slabBetween(-4.0, 4.0));
        const Frame matter = draw(view);
        const glm::ivec2 middle = size / 2 + 3;
        const auto at = [&](const Frame& frame) {
            return glm::dvec3(test::pixel(frame, middle.x, middle.y));
        };
        for (const double planeY : {-25.0, -12.0, 12.0, 25.0}) {
            for (const double sphereY : {-18.0, 18.0}) {
                showSphere({0.0, sphereY, 0.0}, 5.0);
                VolumeScene both = view;
                both.surface = plainLook();
                VolumeScene air = both;
                air.surfaceThreshold = 65000.0;
                air.transferFunction.points = {{64000.0, 0, 0.0}, {65000.0, 0, 0.0}};
                const glm::dvec3 surface = at(draw(air));
                both.surface->opacity = 0.5f;
                ScenePlane plane = planeAt(planeY);
                const glm::dvec3 slice = at(alone(view, plane));
                plane.opacity = 0.4f;
                struct Layer {
                    double y;
                    glm::dvec3 colour;
                    double opacity;
                };
                std::vector<Layer> layers{
                    {sphereY - 4.0, surface, 0.5}, {planeY, slice, 0.4}, {-4.5, at(matter), 1.0}};
                std::sort(layers.begin(), layers.end(),
                    [](const Layer& one, const Layer& other) { return one.y > other.y; });
                glm::dvec3 expected(0.0);
                for (const Layer& layer : layers)
                    expected = glm::mix(expected, layer.colour, layer.opacity);
                const glm::dvec3 seen = at(drawWith(both, plane));
                QVERIFY2(test::apart(glm::ivec3(seen), glm::ivec3(glm::round(expected))) <= 4,
                    qPrintable(QStringLiteral("plane at %1, sphere at %2: %3 instead of %4")
                                   .arg(planeY)
                                   .arg(sphereY)
                                   .arg(seen.b)
                                   .arg(expected.b)));
            }
        }
    }

    /// Through an opaque plane, which is to be read, no surface shines; it does through one that is
    /// before it.
    void whatShinesThroughWhat_data() { addSolidModes(); }
    void whatShinesThroughWhat()
    {
        QFETCH(int, mode);
        open(noMatter);
        VolumeScene view = sceneAlongY(RenderMode(mode));
        view.surface = plainLook();
        view.surface->behindOpacity = 0.5f;
        ScenePlane plane = planeAt(0.0);
        plane.behindOpacity = 0.25f;
        const Frame slice = alone(view, plane);
        showSphere({0.0, 20.0, 0.0}, 9.0);
        QVERIFY(mostOff(drawWith(view, plane), slice, slice, view, plane,
                    [](glm::dvec3 one, glm::dvec3) { return one; })
            <= 1);
        showSphere({0.0, -20.0, 0.0}, 9.0);
        const Frame surface = draw(view);
        const Frame seen = drawWith(view, plane);
        int covered = 0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                if (test::gapToSphere(
                        test::rayOf(view, size, x + 0.5, y + 0.5), {0.0, -20.0, 0.0}, 9.0)
                    > -1.5)
                    continue;
                const glm::dvec3 expected = glm::mix(glm::dvec3(test::pixel(surface, x, y)),
                    glm::dvec3(test::pixel(slice, x, y)), 0.25);
                QVERIFY(
                    test::apart(test::pixel(seen, x, y), glm::ivec3(glm::round(expected))) <= 2);
                ++covered;
            }
        }
        QVERIFY(covered > 400);
    }

    /// In matter that lets some light through it is as bright as what lies before it leaves.
    void withinTranslucentMatter()
    {
        // Black matter, 5 % of a millimetre, from y = -20 on.
        VolumeScene view = sceneAlongY(RenderMode::Dvr);
        view.transferFunction.points = {{1990.0, 0x000000, 0.0}, {1995.0, 0x000000, 0.05}};
        open(slabBetween(-20.0, 20.0));
        for (const double y : {-15.0, -5.0, 10.0}) {
            ScenePlane plane = planeAt(y);
            plane.window = {1000.0, 1000.0}; // matter is white
            const glm::ivec2 middle = size / 2;
            const Frame white = drawWith(view, plane);
            plane.inverted = true;
            const Frame black = drawWith(view, plane); // the gloss of the matter is there, too
            const double share = (test::pixel(white, middle.x, middle.y).g
                                     - test::pixel(black, middle.x, middle.y).g)
                / 255.0;
            const double before = y + 20.0;
            // Matter within two steps of 0.8 mm is behind it; a sample and the soft rim take the
            // rest.
            QVERIFY2(share > std::pow(0.95, before) && share < std::pow(0.95, before - 2.8),
                qPrintable(QStringLiteral("at %1: %2").arg(y).arg(share)));
        }
    }

    /// With all that needs another program: it is seen in each.
    void amongPiecesAndSeeds_data() { addModes(); }
    void amongPiecesAndSeeds()
    {
        QFETCH(int, mode);
        open(slabBetween(8.0, 14.0));
        reference::DenseFields fields(glm::ivec3(70));
        auto& coverage = fields.coverage(2);
        for (int z = 20; z < 50; ++z)
            for (int y = 43; y < 50; ++y)
                for (int x = 10; x < 60; ++x)
                    coverage.at({x, y, z}) = 255;
        m_fixture->put(fields);
        VolumeScene view = sceneAlongY(RenderMode(mode));
        ScenePiece lifted;
        lifted.id = 1;
        lifted.layer = 2;
        lifted.shownFromTrue[3] = glm::dvec4(4.0, 6.0, 9.0, 1.0);
        view.pieces = {lifted};
        const Frame pieces = draw(view);
        view.seeds = std::make_shared<const std::vector<SceneSeed>>(
            std::vector<SceneSeed>{{{20.5, -34.0, 20.5}, 1}});
        // Before all of it but the seed, which lies outside of the rectangle.
        ScenePlane plane = planeAt(-14.0);
        plane.halfSizeMm = {14.0, 12.0};
        plane.opacity = 0.6f;
        const Frame slice = alone(view, plane);
        const int off = mostOff(drawWith(view, plane), pieces, slice, view, plane,
            [](glm::dvec3 one, glm::dvec3 other) { return glm::mix(one, other, 0.6); });
        QVERIFY2(off <= (mode == int(RenderMode::Dvr) ? 5 : 2), qPrintable(QString::number(off)));
    }

    /// A plane where things are cut is seen whole and crisp before the cut face.
    void inTheCutFaceItIsWhole_data()
    {
        QTest::addColumn<int>("mode");
        QTest::addColumn<bool>("orthographic");
        for (const bool orthographic : {true, false}) {
            const char* camera = orthographic ? "orthographic" : "perspective";
            QTest::addRow("surface, %s", camera) << int(RenderMode::Surface) << orthographic;
            QTest::addRow("volume rendering, %s", camera) << int(RenderMode::Dvr) << orthographic;
        }
    }
    void inTheCutFaceItIsWhole()
    {
        QFETCH(int, mode);
        QFETCH(bool, orthographic);
        open([](const glm::dvec3& lps) {
            return glm::length(lps) < 26.0 ? 1500.0 + 400.0 * std::sin(0.4 * lps.x) : 100.0;
        });
        VolumeScene view = sceneAlongY(RenderMode(mode));
        view.eyeLps = {70.0, -210.0, 60.0};
        view.orthographic = orthographic;
        ScenePlane plane = slanting();
        const glm::dvec3 normal = glm::cross(plane.rightLps, plane.downLps);
        view.clip.planes[1] = {.pointLps = plane.centreLps,
            .normalLps = glm::dot(normal, view.eyeLps) > 0.0 ? normal : -normal,
            .on = true};
        const Frame seen = drawWith(view, plane);
        const Frame known = alone(view, plane);
        QVERIFY(mostOff(seen, known, known, view, plane, [](glm::dvec3 one, glm::dvec3) {
            return one;
        }) <= 1);
    }

    /// With BURIN_SCREENSHOTS: pictures to be looked at.
    void onTheDemonstrationHead()
    {
        const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS");
        if (folder.isEmpty())
            QSKIP("BURIN_SCREENSHOTS is not set");
        test::openDemoHead(*m_fixture);
        m_fixture->scheduler.updateSurface(core::wholeUpdate(test::demoBrain()));
        const auto keep = [&](const char* name, const Scene& scene) {
            const Frame frame = m_fixture->draw(scene, {656, 464});
            QVERIFY(test::imageOf(frame).save(QDir(folder).filePath(
                QStringLiteral("head-plane-%1.png").arg(QLatin1String(name)))));
        };
        VolumeScene view = test::demoHeadScene();
        view.orthographic = false;
        view.surface = SceneSurface{};
        view.surface->colours.rgb = 0xE0A080;
        ScenePlane plane;
        plane.centreLps = {0.0, -10.0, 0.0};
        plane.rightLps = glm::normalize(glm::dvec3(1.0, -0.6, 0.1));
        plane.downLps = glm::normalize(glm::cross(glm::dvec3(-0.8, -1.0, -0.25), plane.rightLps));
        plane.halfSizeMm = {100.0, 95.0};
        plane.window = {60.0, 400.0};
        plane.contour = SceneContour{};
        const glm::dvec3 normal = glm::cross(plane.rightLps, plane.downLps);
        const core::ClipPlane cut{.pointLps = plane.centreLps,
            .normalLps = glm::dot(normal, view.eyeLps) > 0.0 ? normal : -normal,
            .on = true};
        view.plane = plane;
        view.clip = {};
        keep("in-the-skull", view); // bone hides most of it
        view.surfaceThreshold = 65000.0;
        keep("surface", view); // they cut through each other
        view.plane->opacity = 0.5f;
        view.surface->opacity = 0.6f;
        keep("translucent", view);
        view.plane = plane;
        view.surface->opacity = 1.0f;
        view.surfaceThreshold = 300.0;
        view.clip.planes[0] = cut;
        keep("in-the-cut", view);
        view.surface->clip = cut;
        view.clip = {};
        view.plane->behindOpacity = 0.5f;
        keep("shining", view);
        view.clip.planes[0] = cut;
        view.mode = RenderMode::Dvr;
        keep("dvr", view);
        view.mode = RenderMode::Mip;
        view.plane->opacity = 0.7f;
        keep("mip", view);
        view.mode = RenderMode::Surface;
        view.plane->opacity = 0.0f;
        keep("contour-alone", view);
    }
};

BURIN_TEST(PlaneOrderGlTest)

} // namespace planeOrderGlTest

#include "PlaneOrderGlTest.moc"
