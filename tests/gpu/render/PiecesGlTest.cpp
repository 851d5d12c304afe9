// SPDX-License-Identifier: Apache-2.0
#include "core/document/Piece.h"
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/program/TestProgram.h"

#include <QDir>
#include <QTest>

#include <algorithm>
#include <cmath>

namespace piecesGlTest {

using namespace gpu;

namespace {

const glm::ivec2 frameSize(128, 112);

/// A ball with a bump and a dent, none of them in its middle: it looks different from every side.
/// Code 1000 on its surface, rising inwards to a plateau.
double potato(const glm::dvec3& lps)
{
    const auto ball = [&](const glm::dvec3& at, double radius) {
        return radius - glm::length(lps - at);
    };
    double depth = std::max(ball({0, 0, 0}, 20.0), ball({14, -6, 9}, 11.0));
    depth = std::min(depth, -ball({-12, -12, 8}, 9.0));
    return std::clamp(1000.0 + 100.0 * depth, 0.0, 2200.0);
}

VolumeScene scene(RenderMode mode)
{
    VolumeScene result;
    result.mode = mode;
    result.eyeLps = {0.0, -300.0, 0.0};
    result.heightMm = 112.0;
    result.surfaceThreshold = 1000.0;
    result.mipWindow = {1000.0, 2400.0};
    result.xrayWindow = {500.0, 1800.0};
    result.transferFunction.points = {
        {900.0, 0xC07050, 0.0}, {1100.0, 0xE0B090, 0.15}, {2200.0, 0xFFFFFF, 0.4}};
    return result;
}

void fillBox(reference::DenseArray<std::uint8_t>& field, const core::VoxelBox& box, int value)
{
    for (int z = box.minimum.z; z < box.maximum.z; ++z)
        for (int y = box.minimum.y; y < box.maximum.y; ++y)
            for (int x = box.minimum.x; x < box.maximum.x; ++x)
                field.at({x, y, z}) = std::uint8_t(value);
}

struct Difference {
    int far = 0; ///< pixels
    int most = 0; ///< of 255
    int lit = 0; ///< pixels of the first that show something
};

/// @param shift pixels that the second picture is displaced by
Difference compare(const Frame& a, const Frame& b, int tolerance, glm::ivec2 shift = {0, 0})
{
    Difference result;
    for (int y = 0; y < a.sizePixels.y; ++y) {
        for (int x = 0; x < a.sizePixels.x; ++x) {
            const glm::ivec2 to = glm::ivec2(x, y) + shift;
            if (to.x < 0 || to.y < 0 || to.x >= b.sizePixels.x || to.y >= b.sizePixels.y)
                continue;
            const glm::ivec3 here = test::pixel(a, x, y);
            const glm::ivec3 apart = glm::abs(here - test::pixel(b, to.x, to.y));
            const int worst = std::max({apart.r, apart.g, apart.b});
            result.far += worst > tolerance ? 1 : 0;
            result.most = std::max(result.most, worst);
            result.lit += here.r + here.g + here.b > 30 ? 1 : 0;
        }
    }
    return result;
}

QByteArray told(const Difference& difference)
{
    return QStringLiteral("%1 pixels off, by up to %2, of %3 lit")
        .arg(difference.far)
        .arg(difference.most)
        .arg(difference.lit)
        .toUtf8();
}

void keep(const Frame& frame, const QString& name)
{
    const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS");
    if (!folder.isEmpty())
        test::imageOf(frame).scaled(512, 448).save(QDir(folder).filePath(name));
}

glm::dmat4 pose(const glm::dvec3& offset, const glm::dvec3& degrees = glm::dvec3(0.0),
    double zoom = 1.0, const glm::dvec3& pivot = glm::dvec3(0.0))
{
    core::Piece piece;
    piece.pivotLps = pivot;
    piece.pose = {.offsetMm = offset, .rotationDegrees = degrees, .zoom = zoom};
    return core::shownFromTrue(piece, {});
}

} // namespace

class PiecesGlTest : public test::FrameTest {
    Q_OBJECT

    static void addModes()
    {
        QTest::addColumn<int>("mode");
        QTest::newRow("surface") << int(RenderMode::Surface);
        QTest::newRow("DVR") << int(RenderMode::Dvr);
        QTest::newRow("MIP") << int(RenderMode::Mip);
        QTest::newRow("X-ray") << int(RenderMode::Xray);
    }

    void openPotato(const glm::ivec3& size = {64, 64, 64})
    {
        m_fixture->open(test::centredGeometry(size), potato);
        m_state = reference::DenseFields(size);
    }
    void cover(int layer, const core::VoxelBox& box)
    {
        fillBox(m_state.coverage(std::uint8_t(layer)), box, 255);
        m_fixture->put(m_state);
    }

    reference::DenseFields m_state;

private Q_SLOTS:
    void atHomeNothingShows_data()
    {
        QTest::addColumn<int>("mode");
        QTest::addColumn<bool>("orthographic");
        QTest::addColumn<bool>("clipped");
        const char* names[] = {"surface", "DVR", "MIP", "X-ray"};
        for (int mode = 0; mode < 4; ++mode) {
            QTest::addRow("%s", names[mode]) << mode << true << false;
            QTest::addRow("%s, perspective, clipped", names[mode]) << mode << false << true;
        }
    }

    /// The picture of a piece at home is that of the volume before it was cut. Tolerance: 3 of 255,
    /// but for 1 % of what is seen: two halves of a translucent voxel are not quite the whole.
    void atHomeNothingShows()
    {
        QFETCH(int, mode);
        QFETCH(bool, orthographic);
        QFETCH(bool, clipped);
        openPotato();
        VolumeScene view = scene(RenderMode(mode));
        view.eyeLps = {90.0, -250.0, 60.0};
        view.heightMm = 60.0;
        view.orthographic = orthographic;
        view.clip.planes[0] = {
            .pointLps = {0, -9, 0}, .normalLps = {0.1, -0.99, 0.1}, .on = clipped};
        const Frame whole = m_fixture->draw(view, frameSize);
        cover(2, {{10, 0, 12}, {36, 40, 50}});
        const Frame cut = m_fixture->draw(view, frameSize);
        const Difference hole = compare(whole, cut, 3);
        QVERIFY2(hole.far > 500, told(hole).constData());
        view.pieces = {{.id = 1, .layer = 2}};
        const Frame home = m_fixture->draw(view, frameSize);
        keep(home, QStringLiteral("piece_home_%1_%2.png").arg(mode).arg(clipped));
        const Difference seam = compare(whole, home, 3);
        QVERIFY2(seam.lit > 2000 && seam.far <= seam.lit / 100 && seam.most <= 40,
            told(seam).constData());
    }

    /// A slice shows where a piece lies in truth, wherever the 3D view shows it.
    void slicesOutlineIt()
    {
        openPotato();
        cover(1, {{4, 4, 4}, {60, 60, 60}});
        SliceScene slice;
        slice.window = {1500.0, 3000.0};
        const Frame plain = m_fixture->draw(slice, {64, 64});
        VolumeScene view = scene(RenderMode::Surface);
        view.pieces = {{.id = 1, .layer = 1, .shownFromTrue = pose({30, -17, 21})}};
        m_fixture->draw(view, frameSize);
        const Frame outlined = m_fixture->draw(slice, {64, 64});
        keep(outlined, QStringLiteral("piece_slice.png"));
        const auto differs = [&](int x, int y) {
            const glm::ivec3 here = test::pixel(outlined, x, y);
            const glm::ivec3 before = test::pixel(plain, x, y);
            const glm::ivec3 apart = glm::abs(here - before);
            return std::max({apart.r, apart.g, apart.b});
        };
        // Voxel i is seen in pixel i. Inside there is a tint, at the border a line, and beyond it
        // nothing has changed.
        QVERIFY(differs(30, 30) > 5 && differs(30, 30) < 70);
        QVERIFY(test::pixel(outlined, 4, 30).b > 200);
        QVERIFY(test::pixel(outlined, 59, 30).b > 200);
        for (int i = 0; i < 64; ++i)
            QCOMPARE(differs(i, 1), 0);
        // Without pieces it is as before, and what hides carving hides this too.
        view.pieces.clear();
        m_fixture->draw(view, frameSize);
        QCOMPARE(*m_fixture->draw(slice, {64, 64}).rgba, *plain.rgba);
        slice.showCarved = false;
        const Frame hidden = m_fixture->draw(slice, {64, 64});
        view.pieces = {{.id = 1, .layer = 1}};
        m_fixture->draw(view, frameSize);
        QCOMPARE(*m_fixture->draw(slice, {64, 64}).rgba, *hidden.rgba);
    }

    /// A slice outlines all of them, however many.
    void slicesOutlineSeventeen()
    {
        openPotato();
        VolumeScene view = scene(RenderMode::Surface);
        const auto cornerOf = [](int i) { return glm::ivec3(2 + i % 5 * 12, 2 + i / 5 * 12, 28); };
        for (int i = 0; i < 17; ++i) {
            const glm::ivec3 corner = cornerOf(i);
            fillBox(m_state.coverage(std::uint8_t(i + 1)), {corner, corner + 9}, 255);
            view.pieces.push_back(
                {.id = i + 1, .layer = i + 1, .shownFromTrue = pose({0, -200, 0})});
        }
        m_fixture->put(m_state);
        SliceScene slice;
        slice.window = {1500.0, 3000.0};
        const Frame plain = m_fixture->draw(slice, {64, 64});
        m_fixture->draw(view, frameSize);
        const Frame outlined = m_fixture->draw(slice, {64, 64});
        for (int i = 0; i < 17; ++i) {
            const glm::ivec3 corner = cornerOf(i);
            QVERIFY2(test::pixel(outlined, corner.x, corner.y + 4).b > 200,
                qPrintable(QString::number(i)));
            QVERIFY(test::pixel(outlined, corner.x + 4, corner.y + 4)
                != test::pixel(plain, corner.x + 4, corner.y + 4));
            QVERIFY(test::pixel(outlined, corner.x + 10, corner.y + 4)
                == test::pixel(plain, corner.x + 10, corner.y + 4));
        }
    }

    void aMoveIsADisplacement_data() { addModes(); }

    /// What is moved by so many pixels is found so many pixels away.
    void aMoveIsADisplacement()
    {
        QFETCH(int, mode);
        openPotato();
        VolumeScene view = scene(RenderMode(mode));
        view.cutFaces = CutFaces::Material;
        const Frame whole = m_fixture->draw(view, frameSize); // a millimetre a pixel
        cover(1, {{0, 0, 0}, {64, 64, 64}});
        const Difference nothing = compare(m_fixture->draw(view, frameSize), whole, 3);
        QCOMPARE(nothing.lit, 0);
        // Right in the picture is +x, up is +z, and all of it has moved half out of the volume.
        view.pieces = {{.id = 1, .layer = 1, .shownFromTrue = pose({30, -17, 21})}};
        const Frame moved = m_fixture->draw(view, frameSize);
        keep(moved, QStringLiteral("piece_moved_%1.png").arg(mode));
        const Difference shifted = compare(whole, moved, mode == 2 ? 1 : 8, {30, -21});
        QVERIFY2(shifted.lit > 1000 && shifted.far <= shifted.lit / 50, told(shifted).constData());
        // One pixel beside it is not the same picture.
        const Difference beside = compare(whole, moved, mode == 2 ? 1 : 8, {31, -21});
        QVERIFY2(beside.far > 3 * std::max(shifted.far, 20), told(beside).constData());
    }

    void aTurnTurnsLightToo_data() { addModes(); }

    /// A piece that is turned looks like a volume that was scanned turned, under the same light.
    void aTurnTurnsLightToo()
    {
        QFETCH(int, mode);
        // x to y to z: voxels go to voxels, and the four corners that a gradient is taken from to
        // each other.
        const glm::dvec3 degrees(120.0 / std::sqrt(3.0));
        const glm::dmat3 back = glm::transpose(core::rotationMatrix(degrees));
        m_fixture->open(test::centredGeometry({64, 64, 64}),
            [&](const glm::dvec3& lps) { return potato(back * lps); });
        VolumeScene view = scene(RenderMode(mode));
        const Frame truth = m_fixture->draw(view, frameSize);
        openPotato();
        const Frame unturned = m_fixture->draw(view, frameSize);
        const Difference other = compare(truth, unturned, 8);
        QVERIFY2(other.far > 200, told(other).constData());
        cover(1, {{0, 0, 0}, {64, 64, 64}});
        view.pieces = {{.id = 1, .layer = 1, .shownFromTrue = pose({}, degrees)}};
        const Frame turned = m_fixture->draw(view, frameSize);
        const Difference same = compare(truth, turned, 8);
        QVERIFY2(same.lit > 1000 && same.far <= same.lit / 50, told(same).constData());
    }

    void aZoomMagnifies_data() { addModes(); }

    void aZoomMagnifies()
    {
        QFETCH(int, mode);
        openPotato();
        VolumeScene view = scene(RenderMode(mode));
        view.heightMm = 56.0;
        const Frame near = m_fixture->draw(view, frameSize); // half a millimetre a pixel
        view.heightMm = 112.0;
        cover(1, {{0, 0, 0}, {64, 64, 64}});
        view.pieces = {{.id = 1, .layer = 1, .shownFromTrue = pose({}, {}, 2.0)}};
        const Frame zoomed = m_fixture->draw(view, frameSize);
        keep(zoomed, QStringLiteral("piece_zoomed_%1.png").arg(mode));
        // Open places and steps are measured where it is shown: light differs a little.
        const Difference same = compare(near, zoomed, mode == 0 ? 40 : 12);
        QVERIFY2(same.lit > 2000 && same.far <= same.lit / 25, told(same).constData());
    }

    /// Two translucent slabs of known colours before each other, and the other way round.
    void translucencyFollowsTheRay_data()
    {
        QTest::addColumn<bool>("swapped");
        QTest::newRow("red before green") << false;
        QTest::newRow("green before red") << true;
    }
    void translucencyFollowsTheRay()
    {
        QFETCH(bool, swapped);
        m_fixture->open(
            test::centredGeometry({64, 64, 64}), [](const glm::dvec3&) { return 500.0; });
        m_state = reference::DenseFields({64, 64, 64});
        VolumeScene view = scene(RenderMode::Dvr);
        view.transferFunction.points = {{0.0, 0xFFFFFF, 0.05}, {1000.0, 0xFFFFFF, 0.05}};
        cover(1, {{20, 20, 20}, {44, 30, 44}}); // 10 mm thick each
        cover(2, {{20, 34, 20}, {44, 44, 44}});
        cover(3, {{0, 0, 0}, {64, 64, 64}}); // all the rest is gone
        // The first lies before the second from here, unless they change places.
        const double apart = 14.0;
        view.pieces = {{.id = 1,
                           .layer = 1,
                           .shownFromTrue = pose({0, swapped ? apart : 0.0, 0}),
                           .rgb = 0xFF0000},
            {.id = 2,
                .layer = 2,
                .shownFromTrue = pose({0, swapped ? -apart : 0.0, 0}),
                .rgb = 0x00FF00}};
        const Frame frame = m_fixture->draw(view, frameSize);
        keep(frame, QStringLiteral("piece_slabs_%1.png").arg(swapped));
        const double one = 1.0 - std::pow(0.95, 10.0);
        const glm::ivec3 seen = test::pixel(frame, 64, 56);
        // Gloss is white. Light is that of the front faces: their ratio is what matters.
        const double front = (swapped ? seen.g : seen.r) - seen.b;
        const double behind = (swapped ? seen.r : seen.g) - seen.b;
        QVERIFY2(std::abs(behind / front - (1.0 - one)) < 0.04,
            qPrintable(QStringLiteral("%1 behind %2").arg(behind).arg(front)));
        QVERIFY2(front > 60, qPrintable(QString::number(front)));
        // The list's order decides nothing, nor which of them has which number.
        std::swap(view.pieces[0], view.pieces[1]);
        QVERIFY(*m_fixture->draw(view, frameSize).rgba == *frame.rgba);
        std::swap(view.pieces[0].id, view.pieces[1].id);
        const Difference renamed = compare(m_fixture->draw(view, frameSize), frame, 1);
        QVERIFY2(renamed.far == 0, told(renamed).constData());
    }

    /// The same of surfaces: a translucent front lets its share of what is behind through.
    void surfacesAreTranslucent()
    {
        openPotato();
        VolumeScene view = scene(RenderMode::Surface);
        cover(1, {{0, 0, 0}, {64, 64, 64}});
        cover(2, {{0, 0, 0}, {1, 1, 1}});
        const ScenePiece far{.id = 1, .layer = 1, .shownFromTrue = pose({0, 40, 0})};
        ScenePiece green{.id = 2,
            .layer = 1,
            .shownFromTrue = pose({0, -40, 0}),
            .opacity = 0.25f,
            .rgb = 0x00FF00};
        view.pieces = {far};
        const Frame alone = m_fixture->draw(view, frameSize);
        ScenePiece opaque = green;
        opaque.opacity = 1.0f;
        view.pieces = {opaque};
        const Frame before = m_fixture->draw(view, frameSize);
        view.pieces = {green, far};
        const Frame both = m_fixture->draw(view, frameSize);
        int checked = 0;
        for (int y = 30; y < 80; ++y) {
            for (int x = 40; x < 88; ++x) {
                const glm::dvec3 front(test::pixel(before, x, y));
                const glm::dvec3 back(test::pixel(alone, x, y));
                if (front.g < 60.0 || back.r < 60.0 || back.r > 253.0 || front.g > 253.0)
                    continue; // beside one of them, or brighter than bytes can say
                const glm::dvec3 wrong =
                    glm::abs(glm::dvec3(test::pixel(both, x, y)) - 0.25 * front - 0.75 * back);
                QVERIFY2(std::max({wrong.r, wrong.g, wrong.b}) < 3.0,
                    qPrintable(QStringLiteral("%1 %2 at %3 %4: %5 of %6 and %7")
                                   .arg(wrong.r)
                                   .arg(wrong.g)
                                   .arg(x)
                                   .arg(y)
                                   .arg(test::pixel(both, x, y).r)
                                   .arg(front.r)
                                   .arg(back.r)));
                ++checked;
            }
        }
        QVERIFY(checked > 500);
    }

    void eightPiecesAtOnce_data() { addModes(); }

    /// Eight corners of the body, each moved outwards: what is seen of them lies where it should.
    void eightPiecesAtOnce()
    {
        QFETCH(int, mode);
        openPotato();
        VolumeScene view = scene(RenderMode(mode));
        view.eyeLps = {0.0, -300.0, 0.0};
        for (int i = 0; i < 8; ++i) {
            const glm::ivec3 corner(i & 1, i >> 1 & 1, i >> 2);
            cover(i + 1, {corner * 32, corner * 32 + 32});
            const glm::dvec3 away = (glm::dvec3(corner) * 2.0 - 1.0) * 15.0;
            view.pieces.push_back(
                {.id = i + 1, .layer = i + 1, .shownFromTrue = pose(away * glm::dvec3(1, 0, 1))});
        }
        const Frame apart = m_fixture->draw(view, frameSize);
        keep(apart, QStringLiteral("piece_eight_%1.png").arg(mode));
        QCOMPARE(apart.pieces.size(), std::size_t(8));
        const auto isLit = [&](int x, int y) {
            const glm::ivec3 rgb = test::pixel(apart, x, y);
            return rgb.r + rgb.g + rgb.b > 30;
        };
        // A cross of nothing runs between them; 15 mm from it they begin.
        for (int at = 20; at < 90; ++at)
            QVERIFY(!isLit(64, at) && !isLit(at, 56) && !isLit(52, at) && !isLit(at, 68));
        for (const int x : {64 - 22, 64 + 22})
            for (const int y : {56 - 22, 56 + 22})
                QVERIFY2(isLit(x, y), qPrintable(QStringLiteral("%1 %2").arg(x).arg(y)));
        for (ScenePiece& piece : view.pieces)
            piece.opacity = 0.0f;
        QCOMPARE(compare(m_fixture->draw(view, frameSize), apart, 3).lit, 0);
    }

    /// A segment's piece is seen where nothing of its values is.
    void segmentsArePastedWhole_data()
    {
        QTest::addColumn<int>("mode");
        QTest::newRow("surface") << int(RenderMode::Surface);
        QTest::newRow("DVR") << int(RenderMode::Dvr);
        QTest::newRow("MIP") << int(RenderMode::Mip);
    }
    void segmentsArePastedWhole()
    {
        QFETCH(int, mode);
        m_fixture->open(
            test::centredGeometry({64, 64, 64}), [](const glm::dvec3&) { return 100.0; });
        m_state = reference::DenseFields({64, 64, 64});
        fillBox(m_state.labels(0), {{26, 26, 26}, {38, 38, 38}}, 5);
        m_fixture->put(m_state);
        VolumeScene view = scene(RenderMode(mode));
        view.pieces = {{.id = 3,
            .segment = 5,
            .shownFromTrue = pose({40, 0, 0}, {}, 2.0),
            .rgb = 0x2040FF,
            .solid = true}};
        const Frame frame = m_fixture->draw(view, frameSize);
        const glm::ivec3 inside = test::pixel(frame, 64 + 40 + 10, 56 - 10);
        QVERIFY(inside.b > 80 && inside.b > 2 * inside.r);
        QVERIFY(test::pixel(frame, 64, 56).b < 40);
        QVERIFY(test::pixel(frame, 64 + 40 - 14, 56).b < 40);
        QCOMPARE(frame.pieces.size(), std::size_t(1));
        QCOMPARE(frame.pieces.front().id, 3);
    }
};

BURIN_TEST(PiecesGlTest)

} // namespace piecesGlTest

#include "PiecesGlTest.moc"
