// SPDX-License-Identifier: Apache-2.0
#include "core/refine/mesh/SurfaceUpdate.h"
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SimplexShapes.h"
#include "tests/support/scenes/SlabScene.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace contextGlTest {

using namespace gpu;

namespace {

const glm::ivec2 size(96, 96);
constexpr int label = 1;
// Seen along +y: the middle of the picture meets the segment, 12 mm behind the slab's face; the
// place beside it meets the slab alone.
const glm::ivec2 onSegment(48, 48);
const glm::ivec2 beside(20, 48);
const glm::ivec2 outside(3, 3); ///< past the volume

SegmentDisplay blue()
{
    SegmentDisplay display;
    display.rgb[label] = 0x2060FF;
    display.visible[label] = true;
    return display;
}

int apart(const glm::ivec3& a, const glm::ivec3& b)
{
    const glm::ivec3 off = glm::abs(a - b);
    return std::max({off.r, off.g, off.b});
}

bool isBlue(const glm::ivec3& rgb)
{
    return rgb.b > 60 && rgb.b > 2 * rgb.r;
}

QString text(const glm::ivec3& rgb)
{
    return QStringLiteral("%1 %2 %3").arg(rgb.r).arg(rgb.g).arg(rgb.b);
}

} // namespace

/// What the 3D view shows of the volume beside its segments.
class ContextGlTest : public test::FrameTest {
    Q_OBJECT

    void openSlab()
    {
        m_fixture->open(test::centredGeometry({64, 64, 64}), test::slabBetween(-20.0, 20.0));
        const core::VoxelBox box{{26, 24, 26}, {38, 36, 38}};
        m_fixture->fill(VolumeField::Labels, box, label);
        m_fixture->fill(VolumeField::Segmentation, box, 255);
    }
    static VolumeScene sceneIn(RenderMode mode, Context context, float opacity = 0.25f)
    {
        VolumeScene scene = test::sceneAlongY(mode);
        scene.context = context;
        scene.contextOpacity = opacity;
        return scene;
    }
    Frame draw(const VolumeScene& scene) { return m_fixture->draw(scene, size, blue()); }
    static glm::ivec3 at(const Frame& frame, const glm::ivec2& place)
    {
        return test::pixel(frame, place.x, place.y);
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
    void segmentsAlone_data() { addModes(); }
    void segmentsAlone()
    {
        QFETCH(int, mode);
        openSlab();
        const Frame opaque = draw(sceneIn(RenderMode(mode), Context::Opaque));
        QVERIFY2(at(opaque, beside).g > 60, qPrintable(text(at(opaque, beside))));
        const Frame alone = draw(sceneIn(RenderMode(mode), Context::Hidden));
        QCOMPARE(at(alone, beside), glm::ivec3(0));
        QVERIFY2(isBlue(at(alone, onSegment)), qPrintable(text(at(alone, onSegment))));
        // The same picture in every mode.
        const Frame first = draw(sceneIn(RenderMode::Surface, Context::Hidden));
        QVERIFY(*first.rgba == *alone.rgba);
        // Nothing is left if no segment is visible.
        m_fixture->fill(VolumeField::Segmentation, {{0, 0, 0}, {64, 64, 64}}, 0);
        const Frame none = draw(sceneIn(RenderMode(mode), Context::Hidden));
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                QCOMPARE(test::pixel(none, x, y), glm::ivec3(0));
    }

    /// A part of a segment that is clipped away does not shade what is beside the cut.
    void whatIsClippedShadesNothing_data()
    {
        QTest::addColumn<int>("context");
        QTest::newRow("hidden") << int(Context::Hidden);
        QTest::newRow("cut away") << int(Context::CutAway);
    }
    void whatIsClippedShadesNothing()
    {
        QFETCH(int, context);
        VolumeScene scene = sceneIn(RenderMode::Surface, Context(context));
        const core::VoxelBox floor{{16, 30, 16}, {48, 40, 48}};
        const core::VoxelBox plate{{16, 18, 16}, {48, 25, 48}}; // 5 mm in front of it
        const auto brightness = [&](bool withPlate, bool clipped) {
            m_fixture->open(test::centredGeometry({64, 64, 64}), test::noMatter);
            m_fixture->fill(VolumeField::Labels, floor, label);
            m_fixture->fill(VolumeField::Segmentation, floor, 255);
            if (withPlate) {
                m_fixture->fill(VolumeField::Labels, plate, label);
                m_fixture->fill(VolumeField::Segmentation, plate, 255);
            }
            scene.clip.planes[0].on = clipped;
            scene.clip.planes[0].normalLps = {0, -1, 0};
            scene.clip.planes[0].pointLps = {0, -4.5, 0};
            const Frame frame = draw(scene);
            glm::ivec3 sum(0);
            for (int y = 44; y < 52; ++y)
                for (int x = 44; x < 52; ++x)
                    sum += at(frame, {x, y});
            return sum / 64;
        };
        const glm::ivec3 bare = brightness(false, true);
        QVERIFY2(isBlue(bare), qPrintable(text(bare)));
        // There is nothing to clip; then there is.
        QVERIFY(apart(brightness(false, false), bare) <= 1);
        const glm::ivec3 cut = brightness(true, true);
        QVERIFY2(
            apart(cut, bare) <= 1, qPrintable(text(cut) + QStringLiteral(" and ") + text(bare)));
    }

    void aSegmentIsSeenThroughTheContext_data() { addModes(); }
    void aSegmentIsSeenThroughTheContext()
    {
        QFETCH(int, mode);
        openSlab();
        const bool inOrder =
            RenderMode(mode) == RenderMode::Surface || RenderMode(mode) == RenderMode::Dvr;
        const Frame opaque = draw(sceneIn(RenderMode(mode), Context::Opaque));
        const Frame alone = draw(sceneIn(RenderMode(mode), Context::Hidden));
        if (inOrder)
            QVERIFY2(!isBlue(at(opaque, onSegment)), qPrintable(text(at(opaque, onSegment))));
        for (const float opacity : {0.0f, 0.25f, 0.6f}) {
            const Frame both = draw(sceneIn(RenderMode(mode), Context::Translucent, opacity));
            const glm::ivec3 seen = at(both, onSegment);
            if (opacity < 0.5f)
                QVERIFY2(isBlue(seen), qPrintable(text(seen)));
            QCOMPARE(at(both, outside), glm::ivec3(0));
            const glm::ivec3 context(glm::round(glm::dvec3(at(opaque, beside)) * double(opacity)));
            QVERIFY2(apart(at(both, beside), context) <= 2, qPrintable(text(at(both, beside))));
            if (!inOrder)
                continue;
            // Seen at right angles a layer of the opacity that is asked for.
            const glm::ivec3 expected(glm::round(glm::mix(glm::dvec3(at(alone, onSegment)),
                glm::dvec3(at(opaque, onSegment)), double(opacity))));
            QVERIFY2(apart(seen, expected) <= 4,
                qPrintable(text(seen) + QStringLiteral(" instead of ") + text(expected)));
        }
    }

    void fullOpacityIsTheVolume_data() { addModes(); }
    void fullOpacityIsTheVolume()
    {
        QFETCH(int, mode);
        openSlab();
        const Frame opaque = draw(sceneIn(RenderMode(mode), Context::Opaque));
        const Frame full = draw(sceneIn(RenderMode(mode), Context::Translucent, 1.0f));
        QVERIFY(*opaque.rgba == *full.rgba);
    }

    void theContextIsCutAwayBeforeSegments_data() { addModes(); }
    void theContextIsCutAwayBeforeSegments()
    {
        QFETCH(int, mode);
        openSlab();
        const Frame opaque = draw(sceneIn(RenderMode(mode), Context::Opaque));
        const Frame alone = draw(sceneIn(RenderMode(mode), Context::Hidden));
        const Frame cut = draw(sceneIn(RenderMode(mode), Context::CutAway));
        QVERIFY2(
            apart(at(cut, beside), at(opaque, beside)) <= 1, qPrintable(text(at(cut, beside))));
        QVERIFY2(isBlue(at(cut, onSegment)), qPrintable(text(at(cut, onSegment))));
        const bool shaded =
            RenderMode(mode) == RenderMode::Surface || RenderMode(mode) == RenderMode::Dvr;
        if (shaded)
            QVERIFY2(apart(at(cut, onSegment), at(alone, onSegment)) <= 3,
                qPrintable(text(at(cut, onSegment))));
    }

    /// The surface that is refined lies inside matter: the ghost that it was becomes a body.
    void theSurfaceIsNoGhost_data()
    {
        QTest::addColumn<int>("mode");
        QTest::addColumn<int>("context");
        for (const RenderMode mode : {RenderMode::Surface, RenderMode::Dvr}) {
            const char* name = mode == RenderMode::Surface ? "isosurface" : "volume rendering";
            QTest::addRow("%s, hidden", name) << int(mode) << int(Context::Hidden);
            QTest::addRow("%s, cut away", name) << int(mode) << int(Context::CutAway);
            QTest::addRow("%s, translucent", name) << int(mode) << int(Context::Translucent);
        }
    }
    void theSurfaceIsNoGhost()
    {
        QFETCH(int, mode);
        QFETCH(int, context);
        const core::SimplexMesh mesh = test::simplexMesh(test::icosphere(9.0, 3));
        const auto drawIn = [&](Context with,
                                const std::function<double(const glm::dvec3&)>& code) {
            m_fixture->open(test::centredGeometry({64, 64, 64}), code);
            m_fixture->scheduler.updateSurface(core::wholeUpdate(mesh));
            VolumeScene scene = sceneIn(RenderMode(mode), with);
            scene.surface = test::plainLook();
            return draw(scene);
        };
        const glm::ivec3 bare = at(drawIn(Context::Opaque, test::noMatter), onSegment);
        const auto slab = test::slabBetween(-20.0, 20.0);
        const glm::ivec3 hidden = at(drawIn(Context::Opaque, slab), onSegment);
        QVERIFY2(apart(hidden, bare) > 40, qPrintable(text(hidden))); // the slab is in front
        const glm::ivec3 seen = at(drawIn(Context(context), slab), onSegment);
        const bool through = Context(context) == Context::Translucent;
        const glm::ivec3 expected = through
            ? glm::ivec3(glm::round(glm::mix(glm::dvec3(bare), glm::dvec3(hidden), 0.25)))
            : bare;
        QVERIFY2(apart(seen, expected) <= (through ? 4 : 1),
            qPrintable(text(seen) + QStringLiteral(" instead of ") + text(expected)));
    }

    /// A segment whose surface is drawn has no body; slices do not bring it back.
    void aSegmentWithASurfaceHasNoBody()
    {
        openSlab();
        VolumeScene scene = sceneIn(RenderMode::Surface, Context::Hidden);
        draw(scene);
        QVERIFY(m_fixture->edits.shown.test(label));
        scene.bodiless = label;
        draw(scene);
        QVERIFY(!m_fixture->edits.shown.test(label));
        m_fixture->draw(SliceScene{}, size, blue());
        QVERIFY(!m_fixture->edits.shown.test(label));
        scene.bodiless = 0;
        draw(scene);
        QVERIFY(m_fixture->edits.shown.test(label));
    }

    /// A yellow mark, which is where nothing was judged, may leave the segment's colour as it is.
    void unjudgedSurfaceHasItsSegmentsColour()
    {
        m_fixture->open(test::centredGeometry({64, 64, 64}), test::noMatter);
        m_fixture->scheduler.updateSurface(
            core::wholeUpdate(test::simplexMesh(test::icosphere(9.0, 3))));
        VolumeScene scene = sceneIn(RenderMode::Surface, Context::Opaque);
        scene.surface = test::plainLook();
        const glm::ivec3 plain = at(draw(scene), onSegment);
        scene.surface->colours.markOpacity = 0.8f;
        const glm::ivec3 yellow = at(draw(scene), onSegment);
        QVERIFY2(yellow.r > plain.r + 40, qPrintable(text(yellow)));
        scene.surface->colours.yellowShare = 0.0f;
        QCOMPARE(at(draw(scene), onSegment), plain);
    }
};

BURIN_TEST(ContextGlTest)

} // namespace contextGlTest

#include "ContextGlTest.moc"
