// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace raycastPassGlTest {

using namespace gpu;

namespace {

constexpr double radiusMm = 22.0;
const glm::dvec3 sphereLps(3.0, -2.0, 4.0);

/// Code 1000 on the sphere's surface, rising inwards.
double sphere(const glm::dvec3& lps)
{
    return 1000.0 + 100.0 * (radiusMm - glm::length(lps - sphereLps));
}

VolumeScene scene(RenderMode mode)
{
    VolumeScene result;
    result.mode = mode;
    result.eyeLps = {120.0, -230.0, 90.0};
    result.targetLps = {0.0, 0.0, 0.0};
    result.heightMm = 90.0;
    result.surfaceThreshold = 1000.0;
    result.mipWindow = {2000.0, 4001.0};
    result.xrayWindow = {2000.0, 4001.0};
    return result;
}

bool isLit(const Frame& frame, int x, int y)
{
    const glm::ivec3 rgb = test::pixel(frame, x, y);
    return rgb.r + rgb.g + rgb.b > 0;
}

/// Distance of a point from the ray of a pixel's centre; negative: inside the sphere.
double gapToSphere(const VolumeScene& view, const glm::ivec2& size, int x, int y)
{
    const glm::dvec3 forward = glm::normalize(view.targetLps - view.eyeLps);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, view.up));
    const glm::dvec3 down = glm::cross(forward, right);
    const double mm = view.heightMm / size.y;
    const glm::dvec3 onPlane = view.targetLps + right * ((x + 0.5 - size.x / 2.0) * mm)
        + down * ((y + 0.5 - size.y / 2.0) * mm);
    const glm::dvec3 direction =
        view.orthographic ? forward : glm::normalize(onPlane - view.eyeLps);
    const glm::dvec3 offset = sphereLps - onPlane;
    return glm::length(offset - direction * glm::dot(offset, direction)) - radiusMm;
}

core::VolumeGeometry skewed()
{
    core::VolumeGeometry geometry;
    geometry.size = {90, 80, 50};
    geometry.indexToWorld[0] = glm::dvec4(0.0, 0.8, 0.1, 0.0);
    geometry.indexToWorld[1] = glm::dvec4(-0.9, 0.1, 0.0, 0.0);
    geometry.indexToWorld[2] = glm::dvec4(0.1, 0.5, -1.6, 0.0);
    const glm::dvec3 middle(44.5, 39.5, 24.5);
    const glm::dvec3 shift = -(glm::dmat3(geometry.indexToWorld) * middle) + sphereLps;
    geometry.indexToWorld[3] = glm::dvec4(shift, 1.0);
    return geometry;
}

} // namespace

class RaycastPassGlTest : public test::FrameTest {
    Q_OBJECT

private Q_SLOTS:
    void silhouetteOfASphere_data()
    {
        QTest::addColumn<bool>("orthographic");
        QTest::addColumn<bool>("skew");
        QTest::newRow("orthographic") << true << false;
        QTest::newRow("perspective") << false << false;
        QTest::newRow("orthographic, sheared grid") << true << true;
        QTest::newRow("perspective, sheared grid") << false << true;
    }

    void silhouetteOfASphere()
    {
        QFETCH(bool, orthographic);
        QFETCH(bool, skew);
        m_fixture->open(skew ? skewed() : test::centredGeometry({70, 70, 70}), sphere);
        VolumeScene view = scene(RenderMode::Surface);
        view.orthographic = orthographic;
        const glm::ivec2 size(150, 130);
        const Frame frame = m_fixture->draw(view, size);
        // Refined pictures average over a pixel: its diagonal decides nothing.
        const double undecided = view.heightMm / size.y + 0.1;
        int inside = 0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const double gap = gapToSphere(view, size, x, y);
                if (std::abs(gap) < undecided)
                    continue;
                QVERIFY2(isLit(frame, x, y) == (gap < 0.0),
                    qPrintable(QStringLiteral("(%1, %2), gap %3 mm").arg(x).arg(y).arg(gap)));
                inside += gap < 0.0 ? 1 : 0;
            }
        }
        QVERIFY(inside > 1500);
    }

    void nothingDarkOnALitSphere()
    {
        m_fixture->open(test::centredGeometry({70, 70, 70}), sphere);
        const VolumeScene view = scene(RenderMode::Surface);
        const glm::ivec2 size(150, 130);
        const Frame frame = m_fixture->draw(view, size);
        int darkest = 255;
        int brightest = 0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                if (gapToSphere(view, size, x, y) > -1.5)
                    continue;
                const glm::ivec3 rgb = test::pixel(frame, x, y);
                darkest = std::min(darkest, rgb.r);
                brightest = std::max(brightest, rgb.r);
                QVERIFY(rgb.r >= rgb.b); // bone is warm
            }
        }
        QVERIFY2(darkest > 40, qPrintable(QString::number(darkest)));
        QVERIFY2(brightest > 200, qPrintable(QString::number(brightest)));
        QVERIFY2(brightest - darkest > 60, qPrintable(QString::number(darkest))); // round, not flat
    }

    void maximaHaveKnownGreys()
    {
        // Blocks of 5³ voxels: however a ray passes, it meets their plateau.
        m_fixture->open(test::centredGeometry({64, 64, 64}), [](const glm::dvec3& lps) {
            const auto near = [&](const glm::dvec3& at) {
                const glm::dvec3 apart = glm::abs(lps - at);
                return std::max({apart.x, apart.y, apart.z}) < 3.0;
            };
            return near({-15, 0, 0}) ? 1000.0
                : near({15, 10, 0})  ? 3000.0
                : near({15, -10, 0}) ? 2000.0
                                     : 100.0;
        });
        VolumeScene view = scene(RenderMode::Mip);
        view.eyeLps = {0, -300, 0};
        view.heightMm = 64.0;
        const glm::ivec2 size(64, 64);
        const Frame frame = m_fixture->draw(view, size);
        const auto grey = [](double value) {
            return int(std::lround((value + 0.5) / 4000.0 * 255.0));
        };
        QVERIFY(std::abs(test::pixel(frame, 32 - 15, 32).r - grey(1000)) <= 1);
        QVERIFY(std::abs(test::pixel(frame, 32 + 15, 32).r - grey(3000)) <= 1);
        QVERIFY(std::abs(test::pixel(frame, 32, 50).r - grey(100)) <= 1);
        // The greater one hides behind the lesser, then is carved away.
        m_fixture->fill(VolumeField::Radiation, {{0, 36, 0}, {64, 64, 64}}, 255);
        const Frame carved = m_fixture->draw(view, size);
        QVERIFY(std::abs(test::pixel(carved, 32 + 15, 32).r - grey(2000)) <= 1);
        QVERIFY(std::abs(test::pixel(carved, 32 - 15, 32).r - grey(1000)) <= 1);
    }

    /// A slab of 3000 in 1000, seen along its normal and aslant: the mean of the interpolated
    /// values over the whole path, to 1 of 255 (15.7 of 4000).
    void meansHaveKnownGreys_data()
    {
        QTest::addColumn<bool>("orthographic");
        QTest::addColumn<glm::dvec3>("eye");
        for (const bool orthographic : {true, false}) {
            const char* how = orthographic ? "orthographic" : "perspective";
            QTest::addRow("%s, along", how) << orthographic << glm::dvec3(0, -300, 0);
            QTest::addRow("%s, aslant", how) << orthographic << glm::dvec3(90, -300, -70);
        }
    }

    void meansHaveKnownGreys()
    {
        QFETCH(bool, orthographic);
        QFETCH(glm::dvec3, eye);
        // Voxel centres from -20 to 20 mm in y; the slab's, from -2 to 6, weigh one cell each.
        const auto geometry = test::centredGeometry({80, 41, 80}, {1.0, 1.0, 1.25});
        m_fixture->open(geometry,
            [](const glm::dvec3& lps) { return lps.y > -2.5 && lps.y < 6.5 ? 3000.0 : 1000.0; });
        VolumeScene view = scene(RenderMode::Xray);
        view.eyeLps = eye;
        view.orthographic = orthographic;
        view.heightMm = 30.0;
        const glm::ivec2 size(40, 40);
        const auto grey = [](double value) { return (value + 0.5) / 4000.0 * 255.0; };
        const auto everywhere = [&](const Frame& frame, double value) {
            for (const int at : {8, 20, 31}) {
                const double seen = test::pixel(frame, at, 39 - at).r;
                if (std::abs(seen - grey(value)) > 1.0)
                    return QStringLiteral("%1 for %2").arg(seen).arg(grey(value));
            }
            return QString();
        };
        QString wrong = everywhere(m_fixture->draw(view, size), 1000.0 + 2000.0 * 9.0 / 41.0);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        // What is carved away counts neither above nor below the line: the front 20 voxels.
        m_fixture->fill(VolumeField::Radiation, {{0, 0, 0}, {80, 20, 80}}, 255);
        // The cut lies half-way between centres; the interpolated step there, too.
        wrong = everywhere(m_fixture->draw(view, size), 1000.0 + 2000.0 * 7.0 / 21.0);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        m_fixture->fill(VolumeField::Radiation, {{0, 0, 0}, {80, 41, 80}}, 255);
        QCOMPARE(test::pixel(m_fixture->draw(view, size), 20, 20), glm::ivec3(0));
    }

    void opacityGrowsWithThePath()
    {
        m_fixture->open(
            test::centredGeometry({40, 40, 40}), [](const glm::dvec3&) { return 500.0; });
        VolumeScene view = scene(RenderMode::Dvr);
        view.eyeLps = {0, 0, 300};
        view.up = {0, -1, 0};
        view.heightMm = 40.0;
        view.transferFunction.points = {{0.0, 0xFF8040, 0.02}, {1000.0, 0xFF8040, 0.02}};
        const Frame frame = m_fixture->draw(view, {40, 40});
        const double seen = 1.0 - std::pow(1.0 - 0.02, 40.0);
        // Matter without a surface is lit evenly (0.82 of its colour).
        QVERIFY(std::abs(test::pixel(frame, 20, 20).r - 255.0 * 0.82 * seen) < 4.0);
        QVERIFY(std::abs(test::pixel(frame, 20, 20).g - 128.0 * 0.82 * seen) < 3.0);
        // Half of it carved away: the path is half as long.
        m_fixture->fill(VolumeField::Radiation, {{0, 0, 20}, {40, 40, 40}}, 255);
        const Frame carved = m_fixture->draw(view, {40, 40});
        const double half = 1.0 - std::pow(1.0 - 0.02, 20.0);
        QVERIFY(std::abs(test::pixel(carved, 20, 20).r - 255.0 * 0.82 * half) < 5.0);
    }

    void carvingUncoversAndSegmentsStayWhole_data()
    {
        QTest::addColumn<int>("mode");
        QTest::addColumn<double>("target"); // y; before and behind what is seen
        for (const double target : {-60.0, 60.0}) {
            const char* where = target < 0.0 ? "before" : "behind";
            QTest::addRow("surface, target %s", where) << int(RenderMode::Surface) << target;
            QTest::addRow("DVR, target %s", where) << int(RenderMode::Dvr) << target;
            QTest::addRow("MIP, target %s", where) << int(RenderMode::Mip) << target;
            QTest::addRow("X-ray, target %s", where) << int(RenderMode::Xray) << target;
        }
    }

    void carvingUncoversAndSegmentsStayWhole()
    {
        QFETCH(int, mode);
        QFETCH(double, target);
        m_fixture->open(test::centredGeometry({64, 64, 64}), sphere);
        VolumeScene view = scene(RenderMode(mode));
        view.eyeLps = {0, -300, 0};
        view.targetLps = {0, target, 0};
        view.heightMm = 64.0;
        view.mipWindow = {2400.0, 1000.0};
        view.transferFunction.points = {{990.0, 0xFFFFFF, 0.0}, {1000.0, 0xFFFFFF, 0.9}};
        const glm::ivec2 size(64, 64);
        const int x = 32 + 3 + 8;
        const int y = 32 - 4;
        QVERIFY(isLit(m_fixture->draw(view, size), x, y));
        // Everything on the left half (x ≥ 35) is carved away.
        m_fixture->fill(VolumeField::Radiation, {{35, 0, 0}, {64, 64, 64}}, 255);
        const Frame carved = m_fixture->draw(view, size);
        QVERIFY(!isLit(carved, x, y));
        QVERIFY(mode == int(RenderMode::Mip) || isLit(carved, 32 - 5, y));
        // A segment where nothing is left, in pure green.
        const core::VoxelBox box{{40, 30, 33}, {46, 36, 39}};
        m_fixture->fill(VolumeField::Labels, box, 7);
        m_fixture->fill(VolumeField::Segmentation, box, 255);
        SegmentDisplay segments;
        segments.rgb[7] = 0x00FF00;
        segments.visible[7] = true;
        const glm::ivec3 green = test::pixel(m_fixture->draw(view, size, segments), x, y);
        QVERIFY2(green.g > 90 && green.g > 3 * green.r && green.g > 3 * green.b,
            qPrintable(QStringLiteral("%1 %2 %3").arg(green.r).arg(green.g).arg(green.b)));
    }

    void allViewsAgreeAboutAVoxel()
    {
        const core::VolumeGeometry geometry = skewed();
        const glm::ivec3 voxel(61, 22, 30);
        const glm::dvec3 there = geometry.toWorld(glm::dvec3(voxel));
        m_fixture->open(geometry,
            [&](const glm::dvec3& lps) { return glm::length(lps - there) < 0.05 ? 3000.0 : 50.0; });
        const glm::ivec2 size(101, 101);
        const auto brightest = [&](const Frame& frame) {
            glm::dvec2 sum(0.0);
            double weight = 0.0;
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x) {
                    const double w = std::max(test::pixel(frame, x, y).r - 20, 0);
                    sum += w * glm::dvec2(x + 0.5, y + 0.5);
                    weight += w;
                }
            return weight > 0.0 ? sum / weight : glm::dvec2(-1.0);
        };
        // The voxel is shown off centre by a known shift, in every plane and in 3D.
        const glm::dvec3 axes[3][2] = {
            {{1, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {0, 0, -1}}, {{0, 1, 0}, {0, 0, -1}}};
        for (const auto& plane : axes) {
            SliceScene slice;
            slice.rightLps = plane[0];
            slice.downLps = plane[1];
            slice.centreLps = there - slice.rightLps * 3.0 + slice.downLps * 2.0;
            slice.mmPerPixel = 0.25;
            slice.window = {1500.0, 3000.0};
            const glm::dvec2 seen = brightest(m_fixture->draw(slice, size));
            QVERIFY2(glm::length(seen - glm::dvec2(50.5 + 12.0, 50.5 - 8.0)) < 1.0,
                qPrintable(QStringLiteral("%1 %2").arg(seen.x).arg(seen.y)));
        }
        VolumeScene view = scene(RenderMode::Mip);
        view.targetLps = there + glm::dvec3(-3.0, 0.0, 2.0);
        view.eyeLps = view.targetLps + glm::dvec3(0.0, -300.0, 0.0);
        view.heightMm = 101 * 0.25;
        view.mipWindow = {1500.0, 3000.0};
        const glm::dvec2 seen = brightest(m_fixture->draw(view, size));
        QVERIFY2(glm::length(seen - glm::dvec2(50.5 + 12.0, 50.5 + 8.0)) < 1.0,
            qPrintable(QStringLiteral("%1 %2").arg(seen.x).arg(seen.y)));
    }
};

BURIN_TEST(RaycastPassGlTest)

} // namespace raycastPassGlTest

#include "RaycastPassGlTest.moc"
