// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/SurfaceUpdate.h"
#include "gpu/render/SurfaceContour.h"
#include "gpu/render/parts/SurfaceBuffers.h"
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SimplexShapes.h"

#include <QDir>
#include <QTest>

#include <algorithm>
#include <cmath>

namespace surfaceContourGlTest {

using namespace gpu;

namespace {

const glm::ivec2 size(240, 200);
constexpr double radiusMm = 20.0;
const glm::dvec3 sphereLps(3.0, -2.0, 4.0);

core::SimplexMesh sphere(double radius, int cuts)
{
    return test::simplexMesh(test::moved(test::icosphere(radius, cuts), sphereLps));
}

SceneContour plainContour()
{
    SceneContour contour;
    contour.colours.rgb = 0xFFFFFF;
    contour.colours.markOpacity = 0.0f;
    return contour;
}

/// Planes through the sphere, some millimetres off its middle.
std::vector<SliceScene> planes()
{
    std::vector<SliceScene> scenes(4);
    scenes[0].centreLps = {0.0, 0.0, 11.3};
    scenes[1].centreLps = {0.0, 5.2, 0.0};
    scenes[1].downLps = {0.0, 0.0, -1.0};
    scenes[2].centreLps = {2.0, 1.0, -3.0};
    scenes[2].rightLps = glm::normalize(glm::dvec3(1.0, 0.4, 0.2));
    scenes[2].downLps = glm::normalize(glm::cross(scenes[2].rightLps, glm::dvec3(0.3, 0.2, 1.0)));
    scenes[3] = scenes[2]; // magnified
    scenes[3].centreLps += scenes[3].rightLps * 15.0;
    for (SliceScene& scene : scenes) {
        scene.mmPerPixel = 0.25;
        scene.window = {1000.0, 2000.0};
        scene.contour = plainContour();
    }
    scenes[3].mmPerPixel = 0.04;
    return scenes;
}

/// The circle in which a plane cuts the sphere, in pixels.
struct Circle {
    glm::dvec2 middle{0.0};
    double radius = 0.0;
};

Circle circleIn(const SliceScene& scene)
{
    const glm::dvec3 from = sphereLps - scene.centreLps;
    const double height = glm::dot(from, glm::cross(scene.rightLps, scene.downLps));
    const glm::dvec2 mm(glm::dot(from, scene.rightLps), glm::dot(from, scene.downLps));
    return {glm::dvec2(size) * 0.5 + mm / scene.mmPerPixel,
        std::sqrt(radiusMm * radiusMm - height * height) / scene.mmPerPixel};
}

} // namespace

/// The line where the surface that is being refined meets a slice's plane.
class SurfaceContourGlTest : public test::FrameTest {
    Q_OBJECT

    void open(double code)
    {
        m_fixture->open(
            test::centredGeometry({70, 70, 70}), [=](const glm::dvec3&) { return code; });
    }
    void show(const core::SimplexMesh& mesh)
    {
        m_fixture->scheduler.updateSurface(core::wholeUpdate(mesh));
    }
    Frame draw(const SliceScene& scene) { return m_fixture->draw(scene, size); }

private Q_SLOTS:
    void liesOnTheCircle_data()
    {
        QTest::addColumn<int>("plane");
        QTest::newRow("axial") << 0;
        QTest::newRow("coronal") << 1;
        QTest::newRow("oblique") << 2;
        QTest::newRow("oblique, magnified") << 3;
    }
    void liesOnTheCircle()
    {
        QFETCH(int, plane);
        open(0.0);
        show(sphere(radiusMm, 5));
        const SliceScene scene = planes()[std::size_t(plane)];
        const Circle circle = circleIn(scene);
        const Frame frame = draw(scene);
        // 1.5 pixels wide: half of a pixel 0.75 beside it is covered. The mesh is within 0.01 mm.
        const double tolerance = 0.02 + 0.012 / scene.mmPerPixel;
        int covered = 0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const double apart =
                    glm::length(glm::dvec2(x + 0.5, y + 0.5) - circle.middle) - circle.radius;
                const double expected = std::clamp(0.75 + 0.5 - std::abs(apart), 0.0, 1.0);
                const double seen = test::pixel(frame, x, y).g / 255.0;
                QVERIFY2(std::abs(seen - expected) < tolerance + 0.01,
                    qPrintable(QStringLiteral("(%1, %2), %3 pixels off: %4, not %5")
                                   .arg(x)
                                   .arg(y)
                                   .arg(apart)
                                   .arg(seen)
                                   .arg(expected)));
                covered += seen >= 0.5 ? 1 : 0;
            }
        }
        QVERIFY2(covered > 150, qPrintable(QString::number(covered)));
    }

    void hasARimOnWhite()
    {
        open(4000.0); // all white
        show(sphere(radiusMm, 5));
        const SliceScene scene = planes()[0];
        const Circle circle = circleIn(scene);
        const Frame frame = draw(scene);
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const double apart = std::abs(
                    glm::length(glm::dvec2(x + 0.5, y + 0.5) - circle.middle) - circle.radius);
                const int grey = test::pixel(frame, x, y).g;
                if (apart < 0.2 || apart > 2.4)
                    QCOMPARE(grey, 255);
                if (apart > 1.26 && apart < 1.6)
                    QVERIFY2(grey < 190, qPrintable(QString::number(grey)));
            }
        }
    }

    void closedHoweverTheMeshLies()
    {
        // Vertices in the plane, edges in the plane, a coarse mesh and a fine one.
        for (const int cuts : {0, 1, 3}) {
            SurfaceBuffers buffers;
            buffers.apply(core::wholeUpdate(test::simplexSphere(radiusMm, cuts)));
            buffers.upload();
            for (const double z : {0.0, 1e-13, 3.7}) {
                SliceScene scene;
                scene.centreLps = {0.0, 0.0, z};
                scene.mmPerPixel = 0.25;
                const auto lines = contourOf(buffers, SeenPlane::of(scene, {400, 400}), {400, 400});
                QVERIFY(lines.size() > 4);
                std::vector<std::pair<float, float>> ends;
                for (const ContourLine& line : lines)
                    for (const glm::vec2& pixel : line.pixels)
                        ends.emplace_back(pixel.x, pixel.y);
                std::sort(ends.begin(), ends.end());
                for (std::size_t i = 0; i < ends.size();) {
                    std::size_t same = i;
                    while (same < ends.size() && ends[same] == ends[i])
                        ++same;
                    QVERIFY((same - i) % 2 == 0);
                    i = same;
                }
            }
        }
    }

    void colouredByMark()
    {
        open(0.0);
        core::SimplexMesh mesh = sphere(radiusMm, 4);
        core::SimplexMeshEdit edit(mesh);
        for (const core::VertexId id : mesh.vertexIds()) {
            const double x = mesh.position(id).x - sphereLps.x;
            edit.setMark(id,
                x < -6.0      ? core::SurfaceMark::Green
                    : x > 6.0 ? core::SurfaceMark::Red
                              : core::SurfaceMark::Yellow);
        }
        (void)edit.commit();
        show(mesh);
        SliceScene scene = planes()[0];
        scene.contour = SceneContour{};
        const Circle circle = circleIn(scene);
        const Frame frame = draw(scene);
        const auto rgbAt = [&](double angle) {
            const glm::dvec2 at =
                circle.middle + circle.radius * glm::dvec2(std::cos(angle), std::sin(angle));
            return test::pixel(frame, int(at.x), int(at.y));
        };
        const auto& colours = scene.contour->colours.markRgb;
        const auto colourOf = [&](core::SurfaceMark mark) {
            const std::uint32_t rgb = colours[std::size_t(mark)];
            return glm::ivec3(rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255);
        };
        const auto near = [](const glm::ivec3& one, const glm::ivec3& other) {
            const glm::dvec3 by =
                glm::dvec3(one) / std::max(1.0, double(glm::length(glm::dvec3(one))))
                - glm::dvec3(other) / glm::length(glm::dvec3(other));
            return glm::length(by) < 0.12; // covered in part: the hue
        };
        QVERIFY(near(rgbAt(0.0), colourOf(core::SurfaceMark::Red)));
        QVERIFY(near(rgbAt(1.5708), colourOf(core::SurfaceMark::Yellow)));
        QVERIFY(near(rgbAt(3.1416), colourOf(core::SurfaceMark::Green)));
    }

    void followsAndRedrawsWhatSeesIt()
    {
        open(0.0);
        core::SimplexMesh mesh = sphere(radiusMm, 4);
        show(mesh);
        const auto request = [](ViewId view, double z, bool contour) {
            FrameRequest result;
            result.view = view;
            result.sizePixels = size;
            SliceScene scene;
            scene.centreLps = {0.0, 0.0, z};
            scene.mmPerPixel = 0.25;
            scene.window = {1000.0, 2000.0};
            if (contour)
                scene.contour = plainContour();
            result.scene = scene;
            return result;
        };
        FrameRequest volume;
        volume.view = 4;
        volume.sizePixels = {60, 60};
        VolumeScene scene3d;
        scene3d.surface = SceneSurface{};
        volume.scene = scene3d;
        FrameRequest without = volume;
        without.view = 5;
        without.scene = VolumeScene{};
        m_fixture->scheduler.request(request(1, 20.0, true));
        m_fixture->scheduler.request(request(2, -10.0, true));
        m_fixture->scheduler.request(request(3, 20.0, false));
        m_fixture->scheduler.request(volume);
        m_fixture->scheduler.request(without);
        (void)m_fixture->settle();
        const auto views = [](const std::vector<Frame>& frames) {
            QList<int> ids;
            for (const Frame& frame : frames)
                if (frame.quality == Frame::Quality::Refined)
                    ids.append(frame.view);
            std::sort(ids.begin(), ids.end());
            return ids;
        };
        // The top moves.
        core::SimplexMeshEdit edit(mesh);
        for (const core::VertexId id : mesh.vertexIds()) {
            if (mesh.position(id).z > sphereLps.z + 12.0)
                edit.move(id, mesh.position(id) + glm::dvec3(0.0, 0.0, 3.0));
        }
        const int wakeUps = m_fixture->wakeUps;
        m_fixture->scheduler.updateSurface(core::updateOf(mesh, edit.takeWritten()));
        QVERIFY(m_fixture->wakeUps > wakeUps);
        QCOMPARE(views(m_fixture->settle()), QList<int>({1, 4}));
        QVERIFY(m_fixture->settle().empty());
        edit.rollback();
        show(mesh);
        QCOMPARE(views(m_fixture->settle()), QList<int>({1, 2, 4}));
        // It goes.
        m_fixture->scheduler.updateSurface({.isWhole = true});
        const std::vector<Frame> gone = m_fixture->settle();
        QCOMPARE(views(gone), QList<int>({1, 2, 4}));
        for (const Frame& frame : gone) {
            const auto bytes = *frame.rgba;
            for (std::size_t i = 0; i < bytes.size(); i += 4)
                QVERIFY(bytes[i] == 0 && bytes[i + 1] == 0 && bytes[i + 2] == 0);
        }
    }

    void slicesWithoutItStay()
    {
        open(900.0);
        SliceScene scene = planes()[2];
        scene.contour.reset();
        const Frame plain = draw(scene);
        show(sphere(radiusMm, 3));
        QVERIFY(*draw(scene).rgba == *plain.rgba);
        scene.contour = plainContour();
        scene.centreLps += 60.0 * glm::cross(scene.rightLps, scene.downLps);
        SliceScene away = scene;
        away.contour.reset();
        QVERIFY(*draw(scene).rgba == *draw(away).rgba);
    }

    void looksAsItShould()
    {
        const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS");
        if (folder.isEmpty())
            QSKIP("BURIN_SCREENSHOTS is not set");
        m_fixture->open(test::centredGeometry({70, 70, 70}), [](const glm::dvec3& lps) {
            const double r = glm::length(lps - sphereLps + glm::dvec3(1.5, 0.0, 0.0));
            return r < 19.0 ? 1500.0 : 600.0 + 8.0 * lps.x;
        });
        core::SimplexMesh mesh = sphere(radiusMm, 3);
        core::SimplexMeshEdit edit(mesh);
        for (const core::VertexId id : mesh.vertexIds()) {
            const glm::dvec3 from = mesh.position(id) - sphereLps;
            edit.setMark(id,
                from.x < -6.0       ? core::SurfaceMark::Green
                    : from.y > 10.0 ? core::SurfaceMark::Red
                                    : core::SurfaceMark::Yellow);
        }
        (void)edit.commit();
        show(mesh);
        SliceScene scene = planes()[2];
        scene.contour = SceneContour{};
        QVERIFY(test::imageOf(m_fixture->draw(scene, {480, 400}))
                    .save(QDir(folder).filePath(QStringLiteral("contour.png"))));
        scene.mmPerPixel = 0.03;
        scene.centreLps += 14.0 * scene.rightLps + 10.0 * scene.downLps;
        QVERIFY(test::imageOf(m_fixture->draw(scene, {480, 400}))
                    .save(QDir(folder).filePath(QStringLiteral("contour-near.png"))));
    }
};

BURIN_TEST(SurfaceContourGlTest)

} // namespace surfaceContourGlTest

#include "SurfaceContourGlTest.moc"
