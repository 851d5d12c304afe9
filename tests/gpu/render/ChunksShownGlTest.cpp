// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/fixtures/frames/ViewRays.h"
#include "tests/support/program/TestProgram.h"

#include <QElapsedTimer>
#include <QTest>

#include <algorithm>
#include <array>
#include <ctime>
#include <functional>
#include <memory>

namespace chunksShownGlTest {

using namespace gpu;

namespace {

constexpr glm::ivec2 size(80, 60);
constexpr int grey = 128;
constexpr std::uint32_t red = 0xFFFF0000;
constexpr std::uint32_t blue = 0xFF0000FF;
constexpr std::uint32_t green = 0xFF00FF00;

/// Chunks of a box: the one that each of its voxels is in, one more.
std::shared_ptr<SceneChunks> chunksOf(
    const core::VoxelBox& box, const std::function<int(const glm::ivec3&)>& leafAt)
{
    auto chunks = std::make_shared<SceneChunks>();
    chunks->box = box;
    const glm::ivec3 sides = box.maximum - box.minimum;
    std::vector<std::uint16_t> leaves;
    for (int z = 0; z < sides.z; ++z)
        for (int y = 0; y < sides.y; ++y)
            for (int x = 0; x < sides.x; ++x)
                leaves.push_back(std::uint16_t(leafAt({x, y, z})));
    chunks->leaves = std::make_shared<const std::vector<std::uint16_t>>(std::move(leaves));
    chunks->argb = {red, blue};
    chunks->opacity = 0.25f;
    return chunks;
}

/// Two side by side, and a voxel of none in the first.
std::shared_ptr<SceneChunks> twoChunks()
{
    return chunksOf({.minimum = {10, 8, 2}, .maximum = {30, 22, 12}}, [](const glm::ivec3& at) {
        return at.x == 4 && at.y == 4 ? 0 : at.x < 8 ? 1 : 2;
    });
}

bool is(const glm::ivec3& seen, const glm::dvec3& wanted)
{
    const glm::dvec3 off = glm::abs(glm::dvec3(seen) - wanted);
    return off.x <= 2.0 && off.y <= 2.0 && off.z <= 2.0;
}

bool isRed(const glm::ivec3& seen)
{
    return seen.r > 30 && seen.r > 3 * seen.b;
}

bool isBlue(const glm::ivec3& seen)
{
    return seen.b > 30 && seen.b > 3 * seen.r;
}

// The 3D view: 48³ voxels of 1 mm, two pixels each, seen from the front (−y).
constexpr int side = 48;
constexpr glm::ivec2 size3d(96, 96);
const core::VoxelBox box3d{.minimum = {8, 10, 12}, .maximum = {40, 34, 36}};

VolumeScene fromFront(std::shared_ptr<const SceneChunks> chunks)
{
    VolumeScene scene;
    scene.eyeLps = {0, -300, 0};
    scene.heightMm = side;
    scene.surfaceThreshold = 1000.0;
    scene.mipWindow = scene.xrayWindow = {2000.0, 1000.0};
    scene.transferFunction.points = {{990.0, 0xFFFFFF, 0.0}, {1000.0, 0xFFFFFF, 0.9}};
    scene.chunks = std::move(chunks);
    return scene;
}

/// Where a voxel is seen.
glm::ivec3 at3d(const Frame& frame, int i, int k)
{
    return test::pixel(frame, 2 * i + 1, size3d.y - 2 * k - 1);
}

/// A ball of the second chunk in the first one.
int ballOrRest(const glm::ivec3& at)
{
    const glm::dvec3 from = glm::dvec3(at) - glm::dvec3(16.0, 12.0, 12.0);
    return glm::dot(from, from) < 64.0 ? 2 : 1;
}

} // namespace

/// Chunks in the pictures: areas on slices with a line where two meet, bodies in the 3D view.
class ChunksShownGlTest : public test::FrameTest {
    Q_OBJECT

    [[nodiscard]] Frame drawn(
        const std::shared_ptr<const SceneChunks>& chunks, const SegmentDisplay& segments = {})
    {
        SliceScene scene;
        scene.mmPerPixel = 0.5; // a voxel is two pixels wide
        scene.window = {.centre = 1000.0, .width = 1000.0};
        scene.chunks = chunks;
        return m_fixture->draw(scene, size, segments);
    }
    /// In the middle of a voxel's pixels.
    [[nodiscard]] static glm::ivec3 at(const Frame& frame, int i, int j)
    {
        return test::pixel(frame, 2 * i, 2 * j);
    }
    void openEmpty()
    {
        m_fixture->open(
            test::centredGeometry(glm::ivec3(side)), [](const glm::dvec3&) { return 0.0; });
    }
    [[nodiscard]] Frame drawn3d(const std::shared_ptr<const SceneChunks>& chunks)
    {
        return m_fixture->draw(fromFront(chunks), size3d);
    }

private Q_SLOTS:
    void colouredInTheirBox()
    {
        m_fixture->open(
            test::centredGeometry({40, 30, 20}), [](const glm::dvec3&) { return 1000.0; });
        const Frame plain = drawn(nullptr);
        const glm::ivec3 own = at(plain, 5, 5);
        QVERIFY(std::abs(own.r - grey) <= 1 && own.r == own.b);
        const auto chunks = twoChunks();
        const Frame frame = drawn(chunks);
        const auto mixed = [&own](const glm::ivec3& colour, double share) {
            return glm::dvec3(own) * (1.0 - share) + glm::dvec3(colour) * share;
        };
        QVERIFY(is(at(frame, 12, 16), mixed({255, 0, 0}, 0.25)));
        QVERIFY(is(at(frame, 25, 16), mixed({0, 0, 255}, 0.25)));
        // On either side of x = 18 a line.
        QVERIFY(is(test::pixel(frame, 35, 32), mixed({204, 0, 0}, 0.5)));
        QVERIFY(is(test::pixel(frame, 36, 32), mixed({0, 0, 204}, 0.5)));
        QCOMPARE(at(frame, 14, 12), own); // of none
        for (const glm::ivec2& outside : {glm::ivec2(8, 16), {32, 16}, {15, 6}, {15, 24}})
            QCOMPARE(at(frame, outside.x, outside.y), own);
        // Others are weaker, or not there at all.
        auto weaker = std::make_shared<SceneChunks>(*chunks);
        weaker->argb = {0x80FF0000, 0x000000FF};
        const Frame weak = drawn(weaker);
        QVERIFY(is(at(weak, 12, 16), mixed({255, 0, 0}, 0.25 * 128.0 / 255.0)));
        QCOMPARE(at(weak, 25, 16), own);
    }

    void whatChangesIsSeenAtOnce()
    {
        m_fixture->open(
            test::centredGeometry({40, 30, 20}), [](const glm::dvec3&) { return 1000.0; });
        const Frame plain = drawn(nullptr);
        const glm::dvec3 own(at(plain, 5, 5));
        const auto chunks = twoChunks();
        static_cast<void>(drawn(chunks));
        auto recoloured = std::make_shared<SceneChunks>(*chunks);
        recoloured->argb = {green, green};
        const Frame one = drawn(recoloured);
        const glm::dvec3 tinted = 0.75 * own + 0.25 * glm::dvec3(0.0, 255.0, 0.0);
        QVERIFY(is(at(one, 12, 16), tinted));
        QVERIFY(is(test::pixel(one, 35, 32), tinted)); // one chunk now: no line
        auto moved = std::make_shared<SceneChunks>(*chunks);
        moved->box.minimum.x -= 5;
        moved->box.maximum.x -= 5;
        QVERIFY(is(at(drawn(moved), 7, 16), 0.75 * own + 0.25 * glm::dvec3(255.0, 0.0, 0.0)));
        auto other = std::make_shared<SceneChunks>(*chunks);
        other->leaves = std::make_shared<const std::vector<std::uint16_t>>(
            chunks->leaves->size(), std::uint16_t(2));
        QVERIFY(is(at(drawn(other), 12, 16), 0.75 * own + 0.25 * glm::dvec3(0.0, 0.0, 255.0)));
        QVERIFY(*drawn(nullptr).rgba == *plain.rgba);
    }

    /// On a slice a rim lies inside of its chunk, in full, whatever the opacity.
    void aRimOnASlice()
    {
        m_fixture->open(
            test::centredGeometry({40, 30, 20}), [](const glm::dvec3&) { return 1000.0; });
        const auto chunks = twoChunks();
        const Frame before = drawn(chunks);
        auto rimmed = std::make_shared<SceneChunks>(*chunks);
        rimmed->rims = {0, green};
        const Frame frame = drawn(rimmed);
        const glm::dvec3 full(0.0, 255.0, 0.0);
        // The second chunk begins at x = 18, which is pixel 36, and ends before pixel 60.
        QVERIFY(is(test::pixel(frame, 36, 32), full));
        QVERIFY(is(test::pixel(frame, 59, 32), full));
        QCOMPARE(test::pixel(frame, 35, 32), test::pixel(before, 35, 32));
        QCOMPARE(test::pixel(frame, 60, 32), test::pixel(before, 60, 32));
        for (const int i : {12, 21, 24, 27})
            QCOMPARE(at(frame, i, 16), at(before, i, 16));
        // Two that touch have a line between them if their rims differ, and none if they are the
        // same one: the chunk of a coarser division.
        rimmed = std::make_shared<SceneChunks>(*chunks);
        rimmed->rims = {green, green + 1};
        const Frame both = drawn(rimmed);
        QVERIFY(is(test::pixel(both, 35, 32), full) && is(test::pixel(both, 36, 32), full));
        rimmed = std::make_shared<SceneChunks>(*chunks);
        rimmed->rims = {green, green};
        const Frame one = drawn(rimmed);
        QCOMPARE(test::pixel(one, 35, 32), test::pixel(before, 35, 32));
        QVERIFY(is(test::pixel(one, 20, 32), full)); // the first begins at x = 10
        // Without rims all is as before.
        rimmed = std::make_shared<SceneChunks>(*chunks);
        rimmed->rims = {0, 0};
        QVERIFY(*drawn(rimmed).rgba == *before.rgba);
    }

    /// Where a chunk ends, its segment often ends, too: the rim lies over the segment's line.
    void aRimOverTheLineOfASegment()
    {
        m_fixture->open(
            test::centredGeometry({40, 30, 20}), [](const glm::dvec3&) { return 1000.0; });
        m_fixture->fill(VolumeField::Labels, {.minimum = {18, 8, 2}, .maximum = {30, 22, 12}}, 3);
        SegmentDisplay segments;
        segments.rgb[3] = 0xC000C0;
        segments.visible[3] = true;
        const auto chunks = twoChunks();
        const Frame before = drawn(chunks, segments);
        QVERIFY(is(test::pixel(before, 36, 32), {192.0, 0.0, 192.0})); // the segment's line
        auto rimmed = std::make_shared<SceneChunks>(*chunks);
        rimmed->rims = {0, green};
        const Frame frame = drawn(rimmed, segments);
        QVERIFY(is(test::pixel(frame, 36, 32), {0.0, 255.0, 0.0}));
        QVERIFY(is(test::pixel(frame, 59, 32), {0.0, 255.0, 0.0}));
        QCOMPARE(at(frame, 24, 16), at(before, 24, 16));
    }

    /// In the 3D view the rim of a body is where it is seen obliquely, and nowhere else.
    void aRimOfABody()
    {
        openEmpty();
        auto alone = chunksOf(box3d, ballOrRest);
        alone->argb = {0, blue};
        const Frame before = drawn3d(alone);
        auto rimmed = std::make_shared<SceneChunks>(*alone);
        rimmed->rims = {0, green};
        const Frame frame = drawn3d(rimmed);
        const auto isGreen = [](const glm::ivec3& seen) {
            return seen.g > 40 && seen.g > 2 * seen.b && seen.g > 2 * seen.r;
        };
        const auto greens = [&](const Frame& in) {
            int count = 0;
            for (int y = 0; y < size3d.y; ++y) {
                for (int x = 0; x < size3d.x; ++x)
                    count += isGreen(test::pixel(in, x, y)) ? 1 : 0;
            }
            return count;
        };
        QCOMPARE(greens(before), 0);
        // A ring around a ball of 32 pixels' diameter, about an eighth of a radius wide.
        const int ring = greens(frame);
        QVERIFY2(ring > 30 && ring < 500, qPrintable(QString::number(ring)));
        for (const glm::ivec2& middle : {glm::ivec2(24, 24), {22, 25}, {26, 23}})
            QCOMPARE(at3d(frame, middle.x, middle.y), at3d(before, middle.x, middle.y));
    }

    void whatMakesNoSenseIsNotDrawn()
    {
        openEmpty();
        const Frame slice = drawn(nullptr);
        const Frame view = drawn3d(nullptr);
        const auto good = chunksOf(box3d, [](const glm::ivec3&) { return 1; });
        std::vector<std::shared_ptr<SceneChunks>> all;
        const auto wrong = [&]() -> SceneChunks& {
            return *all.emplace_back(std::make_shared<SceneChunks>(*good));
        };
        wrong().box.maximum.x += 1; // does not fit its list
        SceneChunks& empty = wrong();
        empty.box.maximum = empty.box.minimum;
        wrong().leaves.reset();
        wrong().argb.clear();
        wrong().opacity = 0.0f;
        wrong().argb = {0x00FF0000};
        for (const auto& chunks : all) {
            QVERIFY(*drawn(chunks).rgba == *slice.rgba);
            QVERIFY(*drawn3d(chunks).rgba == *view.rgba);
        }
        QVERIFY(*drawn3d(good).rgba != *view.rgba);
    }

    void bodiesAreWhereTheirVoxelsAre_data()
    {
        QTest::addColumn<int>("mode");
        QTest::newRow("surface") << int(RenderMode::Surface);
        QTest::newRow("DVR") << int(RenderMode::Dvr);
        QTest::newRow("MIP") << int(RenderMode::Mip);
        QTest::newRow("X-ray") << int(RenderMode::Xray);
    }
    void bodiesAreWhereTheirVoxelsAre()
    {
        QFETCH(int, mode);
        openEmpty();
        // The left half is red, the right half blue, the upper third empty.
        const auto chunks = chunksOf(box3d, [](const glm::ivec3& at) {
            return at.z >= 16 ? 0 : at.x < 16 ? 1 : 2;
        });
        VolumeScene scene = fromFront(nullptr);
        scene.mode = RenderMode(mode);
        const Frame plain = m_fixture->draw(scene, size3d);
        scene.chunks = chunks;
        const Frame frame = m_fixture->draw(scene, size3d);
        for (const int i : {9, 14, 21})
            QVERIFY2(isRed(at3d(frame, i, 20)), qPrintable(QString::number(i)));
        for (const int i : {26, 33, 38})
            QVERIFY2(isBlue(at3d(frame, i, 20)), qPrintable(QString::number(i)));
        for (const int k : {13, 25})
            QVERIFY2(isRed(at3d(frame, 14, k)), qPrintable(QString::number(k)));
        for (const glm::ivec2& none : {glm::ivec2(5, 20), {43, 20}, {20, 9}, {20, 31}, {20, 40}})
            QCOMPARE(at3d(frame, none.x, none.y), at3d(plain, none.x, none.y));
    }

    void aBodyIsSeenInAnother()
    {
        openEmpty();
        const auto both = chunksOf(box3d, ballOrRest);
        const glm::ivec3 beside = at3d(drawn3d(both), 12, 16);
        const glm::ivec3 over = at3d(drawn3d(both), 24, 24);
        QVERIFY2(isRed(beside), qPrintable(QString::number(beside.b)));
        QVERIFY(over.b > beside.b + 20 && over.r > 20);
        // Alone it is round: as wide on all sides, and not a corner of its box.
        auto alone = std::make_shared<SceneChunks>(*both);
        alone->argb = {0, blue};
        const Frame frame = drawn3d(alone);
        for (const glm::ivec2& in : {glm::ivec2(24, 24), {18, 24}, {30, 24}, {24, 18}, {24, 30}})
            QVERIFY2(isBlue(at3d(frame, in.x, in.y)), qPrintable(QString::number(in.x)));
        for (const glm::ivec2& out : {glm::ivec2(14, 24), {34, 24}, {18, 18}, {30, 30}})
            QVERIFY2(at3d(frame, out.x, out.y).b < 10, qPrintable(QString::number(out.x)));
    }

    void whatIsClippedIsNotSeen()
    {
        openEmpty();
        // One before the other.
        const auto chunks = chunksOf(box3d, [](const glm::ivec3& at) { return at.y < 12 ? 1 : 2; });
        VolumeScene scene = fromFront(chunks);
        const glm::ivec3 whole = at3d(m_fixture->draw(scene, size3d), 20, 20);
        QVERIFY(whole.r > whole.b);
        // All before the middle of the second one goes; what is left is cut there.
        scene.clip.planes[0].on = true;
        scene.clip.planes[0].normalLps = {0, -1, 0};
        scene.clip.planes[0].pointLps = {0, 5, 0};
        const glm::ivec3 clipped = at3d(m_fixture->draw(scene, size3d), 20, 20);
        QVERIFY2(isBlue(clipped), qPrintable(QString::number(clipped.r)));
        // Beyond it all is gone.
        scene.clip.planes[0].pointLps = {0, 12, 0};
        const glm::ivec3 none = at3d(m_fixture->draw(scene, size3d), 20, 20);
        QVERIFY(none.r < 5 && none.b < 5);
    }

    void matterHidesThemNearly()
    {
        // A wall at y from 20 on in index, and chunks before or behind it.
        m_fixture->open(test::centredGeometry(glm::ivec3(side)),
            [](const glm::dvec3& lps) { return lps.y > -4 && lps.y < 2 ? 2000.0 : 0.0; });
        const Frame plain = drawn3d(nullptr);
        const auto before = chunksOf(
            {.minimum = {8, 4, 12}, .maximum = {40, 14, 36}}, [](const glm::ivec3&) { return 1; });
        const auto behind = chunksOf(
            {.minimum = {8, 32, 12}, .maximum = {40, 42, 36}}, [](const glm::ivec3&) { return 1; });
        const glm::ivec3 wall = at3d(plain, 20, 20);
        QVERIFY(wall.r > 60 && wall.b > 40);
        const glm::ivec3 over = at3d(drawn3d(before), 20, 20);
        const glm::ivec3 through = at3d(drawn3d(behind), 20, 20);
        QVERIFY(over.b < wall.b * 8 / 10);
        QVERIFY2(through.b < wall.b && through.b > wall.b * 8 / 10,
            qPrintable(QString("%1 of %2").arg(through.b).arg(wall.b)));
    }

    /// The cutting plane shows them as a slice does, with everything above it clipped.
    void thePlaneShowsThemAsASlice_data()
    {
        QTest::addColumn<int>("mode");
        QTest::newRow("surface") << int(RenderMode::Surface);
        QTest::newRow("DVR") << int(RenderMode::Dvr);
        QTest::newRow("X-ray") << int(RenderMode::Xray);
    }
    void thePlaneShowsThemAsASlice()
    {
        QFETCH(int, mode);
        // Grey values that differ from place to place, and nothing that the 3D view would show.
        m_fixture->open(test::centredGeometry(glm::ivec3(side)),
            [](const glm::dvec3& lps) { return 400.0 + 6.0 * lps.x; });
        const auto leafAt = [](const glm::ivec3& at) {
            return at.x < 6 ? 0 : 1 + (at.x / 10 + at.z / 9) % 2;
        };
        const auto chunks = chunksOf(box3d, leafAt);
        chunks->argb = {0xFFE6553C, 0x5A3F7FE0};
        ScenePlane plane;
        plane.downLps = {0.0, 0.0, -1.0};
        plane.halfSizeMm = {20.0, 20.0};
        plane.window = {400.0, 500.0};
        plane.rimWidthPixels = 0.0f;
        VolumeScene view = fromFront(chunks);
        view.mode = RenderMode(mode);
        view.plane = plane;
        view.clip.planes[0] = {.pointLps = plane.centreLps, .normalLps = {0, -1, 0}, .on = true};
        const Frame seen = m_fixture->draw(view, size3d);
        const Frame slice = m_fixture->draw(SliceScene{.centreLps = plane.centreLps,
                                                .rightLps = plane.rightLps,
                                                .downLps = plane.downLps,
                                                .mmPerPixel = 0.5,
                                                .window = plane.window,
                                                .chunks = chunks},
            size3d);
        int compared = 0;
        int tinted = 0;
        int beside = 0; // by more than one of the eight pictures that are averaged
        int inside = 0;
        double worst = 0.0;
        for (int y = 9; y < size3d.y - 9; ++y) {
            for (int x = 9; x < size3d.x - 9; ++x) {
                const glm::ivec3 expected = test::pixel(slice, x, y);
                const glm::ivec3 rgb = test::pixel(seen, x, y);
                beside += test::apart(rgb, expected) > 5 ? 1 : 0;
                tinted += expected.r != expected.b ? 1 : 0;
                ++compared;
                // Well inside of a chunk: its colour over the grey value, as told.
                const glm::ivec3 voxel(x / 2, side / 2, (size3d.y - 1 - y) / 2);
                const glm::ivec3 at = voxel - box3d.minimum;
                const auto leafOr = [&](const glm::ivec3& place) {
                    const bool isOut = glm::any(glm::lessThan(place, glm::ivec3(0)))
                        || glm::any(glm::greaterThanEqual(place, box3d.maximum - box3d.minimum));
                    return isOut ? 0 : leafAt(place);
                };
                const int leaf = leafOr(at);
                bool isInside = true;
                for (int dz = -1; dz <= 1; ++dz)
                    for (int dx = -1; dx <= 1; ++dx)
                        isInside = isInside && leafOr(at + glm::ivec3(dx, 0, dz)) == leaf;
                if (!isInside)
                    continue;
                const double lps = (x + 0.5 - size3d.x / 2.0) * 0.5;
                const double greyThere = 255.0 * (6.0 * lps + 250.0) / 499.0;
                const std::uint32_t argb = leaf == 0 ? 0 : chunks->argb[std::size_t(leaf - 1)];
                const double share = 0.25 * double(argb >> 24) / 255.0;
                const glm::dvec3 wanted = glm::dvec3(greyThere) * (1.0 - share)
                    + share * glm::dvec3(argb >> 16 & 255, argb >> 8 & 255, argb & 255);
                const glm::dvec3 off = glm::abs(glm::dvec3(rgb) - wanted);
                worst = std::max({worst, off.x, off.y, off.z});
                ++inside;
            }
        }
        qInfo("%d pixels, %d tinted, %d unlike the slice's; %d inside of chunks, off by %.2f",
            compared, tinted, beside, inside, worst);
        QVERIFY(compared > 5000 && tinted > 1500 && inside > 3000);
        QVERIFY2(beside <= compared / 200, qPrintable(QString::number(beside)));
        QVERIFY2(worst < 3.0, qPrintable(QString::number(worst)));
    }

    /// What lies before a plane is seen before it, what lies behind an opaque one is not.
    void thePlaneHidesWhatLiesBehind()
    {
        openEmpty();
        VolumeScene view = fromFront(nullptr);
        ScenePlane plane;
        plane.downLps = {0.0, 0.0, -1.0};
        plane.halfSizeMm = {20.0, 20.0};
        plane.window = {0.0, 1000.0};
        view.plane = plane;
        const glm::ivec3 own = at3d(m_fixture->draw(view, size3d), 20, 20);
        QVERIFY(own.r > 100 && own.r == own.b);
        view.chunks = chunksOf(
            {.minimum = {8, 30, 12}, .maximum = {40, 42, 36}}, [](const glm::ivec3&) { return 1; });
        QVERIFY(test::apart(at3d(m_fixture->draw(view, size3d), 20, 20), own) <= 1);
        view.plane->opacity = 0.4f;
        const glm::ivec3 through = at3d(m_fixture->draw(view, size3d), 20, 20);
        QVERIFY2(through.r > through.b + 8, qPrintable(QString::number(through.r - through.b)));
        view.plane->opacity = 1.0f;
        view.chunks = chunksOf(
            {.minimum = {8, 4, 12}, .maximum = {40, 14, 36}}, [](const glm::ivec3&) { return 1; });
        const glm::ivec3 before = at3d(m_fixture->draw(view, size3d), 20, 20);
        QVERIFY2(before.r > before.b + 30, qPrintable(QString::number(before.r - before.b)));
    }

    void atTheVolumesBorder()
    {
        openEmpty();
        const core::VoxelBox all{.minimum = glm::ivec3(0), .maximum = glm::ivec3(side)};
        const Frame frame =
            drawn3d(chunksOf(all, [](const glm::ivec3& at) { return at.x < 24 ? 1 : 2; }));
        for (const int k : {0, 20, 47}) {
            QVERIFY2(isRed(at3d(frame, 0, k)), qPrintable(QString::number(k)));
            QVERIFY2(isBlue(at3d(frame, 47, k)), qPrintable(QString::number(k)));
        }
        // One voxel is a box, too.
        const Frame one = drawn3d(chunksOf({.minimum = glm::ivec3(24), .maximum = glm::ivec3(25)},
            [](const glm::ivec3&) { return 2; }));
        QVERIFY(isBlue(at3d(one, 24, 24)));
        QVERIFY(at3d(one, 26, 24).b < 5);
    }

    /// How long pictures take after a click, with all of them wanted at once; decides nothing.
    void howLongAClickTakes_data()
    {
        QTest::addColumn<int>("leaves");
        QTest::newRow("coarse") << 20;
        QTest::newRow("fine") << 5000;
    }
    void howLongAClickTakes()
    {
        QFETCH(int, leaves);
        constexpr int wide = 80; // 512 000 voxels
        constexpr glm::ivec2 viewSize(600, 400);
        m_fixture->open(test::centredGeometry({112, 96, 88}),
            [](const glm::dvec3& lps) { return glm::dot(lps, lps) < 900.0 ? 1200.0 : 100.0; });
        auto chunks = chunksOf({.minimum = {16, 8, 4}, .maximum = {16 + wide, 8 + wide, 4 + wide}},
            [leaves](const glm::ivec3& at) {
                const int along = leaves == 20 ? 3 : 17;
                const glm::ivec3 cell = at * along / wide;
                return 1 + std::min(leaves - 1, (cell.z * along + cell.y) * along + cell.x);
            });
        chunks->argb.assign(std::size_t(leaves), 0);
        for (std::size_t leaf = 0; leaf < chunks->argb.size(); ++leaf)
            chunks->argb[leaf] = 0x5A000000U | (std::uint32_t(leaf) * 0x3FA91BU & 0xFFFFFFU);
        std::vector<int> shown; // views whose picture came
        m_fixture->scheduler.setListener(
            [&shown](const Frame& frame) { shown.push_back(frame.view); });
        const auto request = [&] {
            for (int view = 0; view < 4; ++view) {
                FrameRequest wanted{.view = view, .sizePixels = viewSize};
                if (view == 3) {
                    VolumeScene scene = fromFront(chunks);
                    scene.heightMm = 130.0;
                    wanted.scene = scene;
                } else {
                    SliceScene scene;
                    scene.mmPerPixel = 0.25;
                    scene.window = {.centre = 1000.0, .width = 1000.0};
                    scene.chunks = chunks;
                    wanted.scene = scene;
                }
                wanted.interacting = true;
                m_fixture->scheduler.request(wanted);
            }
        };
        request();
        while (std::count(shown.begin(), shown.end(), 3) == 0)
            static_cast<void>(m_fixture->scheduler.work(false));
        static constexpr std::array slices{0, 1, 2};
        const auto median = [](std::vector<double> all) {
            std::sort(all.begin(), all.end());
            return all[all.size() / 2];
        };
        const auto isShown = [&shown](int view) {
            return std::find(shown.begin(), shown.end(), view) != shown.end();
        };
        // Until the first slice, until the last one, until the 3D view, in the way of a clock; and
        // the processor's time until the last slice, which other programs take no part in.
        std::array<std::vector<double>, 4> times;
        for (int click = 0; click < 12; ++click) {
            auto clicked = std::make_shared<SceneChunks>(*chunks);
            clicked->argb[std::size_t(click * 37 % leaves)] |= 0xFF000000U;
            chunks = clicked;
            shown.clear();
            QElapsedTimer clock;
            clock.start();
            const std::clock_t begun = std::clock();
            request();
            while (times[0].size() <= std::size_t(click) || times[1].size() <= std::size_t(click)
                || times[2].size() <= std::size_t(click)) {
                static_cast<void>(m_fixture->scheduler.work(false));
                const double now = double(clock.nsecsElapsed()) / 1e6;
                const auto note = [&](std::size_t which, bool there) {
                    if (there && times[which].size() <= std::size_t(click))
                        times[which].push_back(now);
                };
                note(0, std::any_of(slices.begin(), slices.end(), isShown));
                note(1, std::all_of(slices.begin(), slices.end(), isShown));
                note(2, isShown(3));
                if (times[3].size() <= std::size_t(click) && times[1].size() > std::size_t(click))
                    times[3].push_back(1e3 * double(std::clock() - begun) / CLOCKS_PER_SEC);
            }
        }
        qInfo("%d chunks of %d voxels: of three slices of %d x %d the first shows a click after "
              "%.1f ms, the last after %.1f ms (%.1f ms of processor time), the 3D view coarsely "
              "after %.1f ms",
            leaves, wide * wide * wide, viewSize.x, viewSize.y, median(times[0]), median(times[1]),
            median(times[3]), median(times[2]));
    }

    /// Only what is of another colour is worked out anew; it comes to what all of it does.
    void recolouredIsAsDrawnAnew()
    {
        openEmpty();
        const auto leafAt = [](const glm::ivec3& at) {
            return 1 + (at.x / 7 + 3 * (at.y / 6) + 5 * (at.z / 9)) % 11;
        };
        const auto first = chunksOf(box3d, leafAt);
        first->argb.clear();
        for (std::uint32_t i = 0; i < 11; ++i)
            first->argb.push_back(0xFF000000 | (0x3FA91B * (i + 1) & 0xFFFFFF));
        auto second = std::make_shared<SceneChunks>(*first);
        second->argb[3] = 0x40FFFFFF;
        second->argb[7] = 0;
        static_cast<void>(drawn3d(first));
        const Frame changed = drawn3d(second);
        auto fresh = std::make_shared<SceneChunks>(*second);
        fresh->leaves = std::make_shared<const std::vector<std::uint16_t>>(*second->leaves);
        QVERIFY(*drawn3d(fresh).rgba == *changed.rgba);
        QVERIFY(*drawn3d(first).rgba != *changed.rgba);
    }
};

BURIN_TEST(ChunksShownGlTest)

} // namespace chunksShownGlTest

#include "ChunksShownGlTest.moc"
