// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/fixtures/frames/ViewRays.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace clippingGlTest {

using namespace gpu;
using test::isLit;
using test::PixelRay;
using test::rayOf;

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
    result.heightMm = 70.0;
    result.surfaceThreshold = 1000.0;
    result.mipWindow = {2000.0, 4001.0};
    result.xrayWindow = {2000.0, 4001.0};
    result.transferFunction.points = {{990.0, 0xFFFFFF, 0.0}, {1000.0, 0xFFFFFF, 0.9}};
    return result;
}

/// Millimetres of the ray that are both in the sphere and not hidden; negative: by how much they
/// miss each other.
double visibleMm(
    const PixelRay& ray, const core::ClipRegion& clip, const core::VolumeGeometry& geometry)
{
    const double middle = glm::dot(sphereLps - ray.origin, ray.direction);
    const double apart = glm::length(ray.origin + middle * ray.direction - sphereLps);
    if (apart >= radiusMm)
        return radiusMm - apart;
    const double half = std::sqrt(radiusMm * radiusMm - apart * apart);
    const glm::dvec3 origin = geometry.toIndex(ray.origin);
    const glm::dvec3 way = glm::dmat3(geometry.worldToIndex()) * ray.direction;
    double from = middle - half;
    double to = middle + half;
    for (const core::HalfSpace& space : core::halfSpaces(clip, geometry)) {
        const double room = space.offset - glm::dot(space.normal, origin);
        const double approach = glm::dot(space.normal, way);
        if (approach > 0.0)
            to = std::min(to, room / approach);
        else
            from = std::max(from, room / approach);
    }
    return to - from;
}

} // namespace

/// What a clip region hides is not seen, what it leaves is, and its faces show what they cut.
class ClippingGlTest : public test::FrameTest {
    Q_OBJECT

    static core::ClipRegion region(const core::VolumeGeometry& geometry, bool box, bool planes)
    {
        core::ClipRegion clip = core::wholeVolume(geometry);
        clip.box = {{20.0, 12.0, 16.0}, {51.0, 60.0, 45.0}, box};
        clip.planes[0] = {{2.0, -8.0, 5.0}, glm::normalize(glm::dvec3(0.5, -1.0, 0.3)), planes};
        clip.planes[2] = {{9.0, 0.0, 0.0}, glm::normalize(glm::dvec3(1.0, 0.4, -0.2)), planes};
        return clip;
    }

private Q_SLOTS:
    void silhouetteOfWhatIsLeft_data()
    {
        QTest::addColumn<int>("mode");
        QTest::addColumn<bool>("orthographic");
        QTest::addColumn<bool>("box");
        QTest::addColumn<bool>("planes");
        for (const int mode : {int(RenderMode::Surface), int(RenderMode::Dvr)}) {
            const char* name = mode == int(RenderMode::Surface) ? "surface" : "DVR";
            QTest::addRow("%s, box", name) << mode << true << true << false;
            QTest::addRow("%s, planes", name) << mode << true << false << true;
            QTest::addRow("%s, both, perspective", name) << mode << false << true << true;
        }
    }

    void silhouetteOfWhatIsLeft()
    {
        QFETCH(int, mode);
        QFETCH(bool, orthographic);
        QFETCH(bool, box);
        QFETCH(bool, planes);
        const core::VolumeGeometry geometry = test::centredGeometry({70, 70, 60}, {1.0, 1.0, 1.2});
        m_fixture->open(geometry, sphere);
        VolumeScene view = scene(RenderMode(mode));
        view.orthographic = orthographic;
        view.clip = region(geometry, box, planes);
        const glm::ivec2 size(110, 96);
        const Frame frame = m_fixture->draw(view, size);
        int inside = 0;
        int hidden = 0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                // All of a pixel is averaged: it must lie on one side, by more than a step.
                double least = 1e9;
                double most = -1e9;
                for (int corner = 0; corner < 4; ++corner) {
                    const PixelRay ray = rayOf(view, size, x + (corner & 1), y + (corner >> 1));
                    const double mm = visibleMm(ray, view.clip, geometry);
                    least = std::min(least, mm);
                    most = std::max(most, mm);
                }
                if (least < 2.0 && most > -0.1)
                    continue;
                QVERIFY2(isLit(frame, x, y) == (most > 0.0),
                    qPrintable(QStringLiteral("(%1, %2): %3 mm").arg(x).arg(y).arg(most)));
                const double whole = visibleMm(rayOf(view, size, x, y), {}, geometry);
                inside += most > 0.0 ? 1 : 0;
                hidden += most < 0.0 && whole > 3.5 ? 1 : 0;
            }
        }
        QVERIFY2(inside > 400, qPrintable(QString::number(inside)));
        QVERIFY2(hidden > 100, qPrintable(QString::number(hidden)));
    }

    /// A hidden half is not in the mean, nor in the maximum.
    void projectionsKnowOnlyWhatIsLeft()
    {
        // 3000 at y from -2 to 6, else 1000; 41 cells from -20.5 to 20.5.
        const auto geometry = test::centredGeometry({64, 41, 64});
        m_fixture->open(geometry,
            [](const glm::dvec3& lps) { return lps.y > -2.5 && lps.y < 6.5 ? 3000.0 : 1000.0; });
        VolumeScene view = scene(RenderMode::Xray);
        view.eyeLps = {60, -300, -40};
        view.heightMm = 24.0;
        view.clip.planes[1] = {{0.0, 2.0, 0.0}, {0.0, -1.0, 0.0}, true};
        const glm::ivec2 size(24, 24);
        const auto off = [&](double value) {
            return std::abs(test::pixel(m_fixture->draw(view, size), 12, 12).r
                - (value + 0.5) / 4000.0 * 255.0);
        };
        // From 2 to 20.5: the slab until 6, the linear step until 7.
        QVERIFY(off(1000.0 + 2000.0 * 4.5 / 18.5) <= 1.0);
        view.clip.box = {{-0.5, 0.0, -0.5}, {63.5, 32.5, 63.5}, true}; // y up to 12.5
        QVERIFY(off(1000.0 + 2000.0 * 4.5 / 10.5) <= 1.0);
        view.mode = RenderMode::Mip;
        QVERIFY(off(3000.0) <= 1.0);
        view.clip.planes[1].pointLps.y = 8.0;
        QVERIFY(off(1000.0) <= 1.0);
        view.clip.planes[0] = {{0.0, 5.0, 0.0}, {0.0, 1.0, 0.0}, true}; // nothing between
        QCOMPARE(test::pixel(m_fixture->draw(view, size), 12, 12), glm::ivec3(0));
        view.mode = RenderMode::Xray;
        QCOMPARE(test::pixel(m_fixture->draw(view, size), 12, 12), glm::ivec3(0));
    }

    /// Grey cut faces look like the slice through the same plane, seen straight on: to 3 of 255,
    /// since a slice shows the middle of a pixel and a refined picture its mean.
    void greyFacesAreTheSlice_data()
    {
        QTest::addColumn<bool>("box");
        QTest::newRow("plane") << false;
        QTest::newRow("face of the box") << true;
    }

    void greyFacesAreTheSlice()
    {
        QFETCH(bool, box);
        const auto geometry = test::centredGeometry({60, 60, 50}, {1.0, 1.0, 1.2});
        m_fixture->open(geometry, [](const glm::dvec3& lps) {
            const double wave = std::sin(0.25 * lps.x + 0.1 * lps.y) * std::cos(0.2 * lps.z);
            return glm::length(lps) < 24.0 ? 2000.0 + 600.0 * wave : 100.0;
        });
        VolumeScene view = scene(RenderMode::Surface);
        const glm::dvec3 normal =
            box ? glm::dvec3(0.0, -1.0, 0.0) : glm::normalize(glm::dvec3(0.4, -1.0, 0.3));
        view.targetLps = {1.0, -4.0, 2.0};
        view.eyeLps = view.targetLps + 300.0 * normal;
        view.heightMm = 48.0;
        view.cutFaces = CutFaces::GreyValues;
        view.faceWindow = {2000.0, 1600.0};
        if (box) {
            view.clip = core::wholeVolume(geometry);
            view.clip.box.minimum.y = geometry.toIndex(view.targetLps).y;
            view.clip.box.on = true;
        } else {
            view.clip.planes[0] = {view.targetLps, normal, true};
        }
        const glm::ivec2 size(80, 80);
        const Frame face = m_fixture->draw(view, size);
        SliceScene slice;
        slice.centreLps = view.targetLps;
        slice.rightLps = glm::normalize(glm::cross(-normal, view.up));
        slice.downLps = glm::cross(-normal, slice.rightLps);
        slice.mmPerPixel = view.heightMm / size.y;
        slice.window = view.faceWindow;
        const Frame known = m_fixture->draw(slice, size);
        int compared = 0;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::dvec3 at = slice.centreLps
                    + slice.mmPerPixel
                        * ((x + 0.5 - size.x / 2.0) * slice.rightLps
                            + (y + 0.5 - size.y / 2.0) * slice.downLps);
                if (glm::length(at) > 22.0)
                    continue;
                ++compared;
                const glm::ivec3 seen = test::pixel(face, x, y);
                const glm::ivec3 expected = test::pixel(known, x, y);
                const glm::ivec3 apart = glm::abs(seen - expected);
                QVERIFY2(std::max({apart.r, apart.g, apart.b}) <= 3,
                    qPrintable(QStringLiteral("(%1, %2): %3 instead of %4")
                                   .arg(x)
                                   .arg(y)
                                   .arg(seen.r)
                                   .arg(expected.r)));
            }
        }
        QVERIFY(compared > 2000);
    }

    /// A segment that is cut through shows its colour on the cut, evenly lit.
    void segmentsAreCutToo_data()
    {
        QTest::addColumn<int>("mode");
        QTest::newRow("surface") << int(RenderMode::Surface);
        QTest::newRow("DVR") << int(RenderMode::Dvr);
    }

    void segmentsAreCutToo()
    {
        QFETCH(int, mode);
        const auto geometry = test::centredGeometry({60, 60, 60});
        m_fixture->open(geometry, [](const glm::dvec3&) { return 100.0; });
        const core::VoxelBox box{{15, 15, 15}, {45, 45, 45}};
        m_fixture->fill(VolumeField::Labels, box, 7);
        m_fixture->fill(VolumeField::Segmentation, box, 255);
        SegmentDisplay segments;
        segments.rgb[7] = 0x00C000;
        segments.visible[7] = true;
        VolumeScene view = scene(RenderMode(mode));
        view.eyeLps = {0.0, -300.0, 0.0};
        view.heightMm = 60.0;
        view.clip.planes[0] = {{0.0, 0.0, 0.0}, {0.0, -1.0, 0.0}, true};
        const Frame frame = m_fixture->draw(view, {60, 60}, segments);
        const glm::ivec3 middle = test::pixel(frame, 30, 30);
        QVERIFY(middle.g > 120 && middle.r < 60);
        for (const int at : {20, 26, 38})
            QVERIFY(std::abs(test::pixel(frame, at, 30).g - middle.g) <= 2);
        view.clip.planes[0].pointLps.y = 20.0; // all of it hidden
        QVERIFY(!isLit(m_fixture->draw(view, {60, 60}, segments), 30, 30));
    }

    /// Flat faces of one material are one brightness in every picture: no rings, no specks.
    void facesAreEven_data()
    {
        QTest::addColumn<int>("mode");
        QTest::addColumn<bool>("grey");
        for (const bool grey : {false, true}) {
            QTest::addRow("surface%s", grey ? ", grey" : "") << int(RenderMode::Surface) << grey;
            QTest::addRow("DVR%s", grey ? ", grey" : "") << int(RenderMode::Dvr) << grey;
        }
    }

    void facesAreEven()
    {
        QFETCH(int, mode);
        QFETCH(bool, grey);
        const auto geometry = test::centredGeometry({60, 60, 60});
        m_fixture->open(geometry,
            [](const glm::dvec3& lps) { return glm::length(lps) < 26.0 ? 2000.0 : 100.0; });
        VolumeScene view = scene(RenderMode(mode));
        view.heightMm = 40.0;
        view.faceWindow = {2000.0, 1600.0};
        view.cutFaces = grey ? CutFaces::GreyValues : CutFaces::Material;
        const glm::dvec3 towards = glm::normalize(view.eyeLps - view.targetLps);
        view.clip.planes[2] = {
            {0, 0, 0}, glm::normalize(towards + glm::dvec3(0.2, 0.1, -0.1)), true};
        const Frame frame = m_fixture->draw(view, {60, 60});
        int least = 255;
        int most = 0;
        for (int y = 14; y < 46; ++y) {
            for (int x = 14; x < 46; ++x) {
                least = std::min(least, test::pixel(frame, x, y).g);
                most = std::max(most, test::pixel(frame, x, y).g);
            }
        }
        QVERIFY2(most - least <= 4 && least > 100,
            qPrintable(QStringLiteral("%1 … %2").arg(least).arg(most)));
    }
};

BURIN_TEST(ClippingGlTest)

} // namespace clippingGlTest

#include "ClippingGlTest.moc"
