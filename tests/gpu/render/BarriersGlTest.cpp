// SPDX-License-Identifier: Apache-2.0
#include "core/growth/SeedWord.h"
#include "gpu/fields/BrickImages.h"
#include "gpu/fields/bricks/BarrierBricks.h"
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <optional>

namespace barriersGlTest {

using namespace gpu;

namespace {

constexpr int side = 48;
constexpr std::uint32_t label = 7;
const core::VoxelBox body{{14, 18, 14}, {34, 30, 34}}; ///< a green segment, all dense
const core::VoxelBox before{{8, 4, 18}, {40, 7, 30}}; ///< plates: one before it as seen from −y
const core::VoxelBox behind{{8, 40, 18}, {40, 43, 30}};

void shut(reference::DenseFields& state, const core::VoxelBox& box, std::uint8_t plane = 0)
{
    for (int z = box.minimum.z; z < box.maximum.z; ++z)
        for (int y = box.minimum.y; y < box.maximum.y; ++y)
            for (int x = box.minimum.x; x < box.maximum.x; ++x)
                state.seedWords(plane).at({x, y, z}) = core::seedWord::barrier;
}

reference::DenseFields withPlate(const std::optional<core::VoxelBox>& plate)
{
    reference::DenseFields state(glm::ivec3{side});
    for (int z = body.minimum.z; z < body.maximum.z; ++z)
        for (int y = body.minimum.y; y < body.maximum.y; ++y)
            for (int x = body.minimum.x; x < body.maximum.x; ++x) {
                state.labels(0).at({x, y, z}) = std::uint8_t(label);
                state.seedWords(0).at({x, y, z}) = core::seedWord::member(2, label, 0);
            }
    if (plate)
        shut(state, *plate);
    return state;
}

SegmentDisplay greenSegment()
{
    SegmentDisplay segments;
    segments.rgb[label] = 0x00C000;
    segments.visible[label] = true;
    return segments;
}

VolumeScene fromFront(RenderMode mode)
{
    VolumeScene scene;
    scene.eyeLps = {0, -300, 0};
    scene.heightMm = side;
    scene.mode = mode;
    scene.surfaceThreshold = 1000.0;
    scene.mipWindow = scene.xrayWindow = {2000.0, 1000.0};
    scene.transferFunction.points = {{990.0, 0xFFFFFF, 0.0}, {1000.0, 0xFFFFFF, 0.9}};
    return scene;
}

constexpr glm::ivec2 size{96, 96}; ///< two pixels a voxel
constexpr glm::ivec2 overBody{48, 48};
constexpr glm::ivec2 beside{22, 48}; ///< of the body: the plates only

bool isRed(const glm::ivec3& colour)
{
    return colour.r > 60 && colour.r > 2 * colour.g && colour.r > colour.b;
}

glm::ivec3 at(const Frame& frame, const glm::ivec2& place)
{
    return test::pixel(frame, place.x, place.y);
}

} // namespace

/// What is shut to growth is seen in the 3D view: translucent, and where it lies.
class BarriersGlTest : public test::FrameTest {
    Q_OBJECT

private:
    void open(const std::optional<core::VoxelBox>& plate)
    {
        m_fixture->open(
            test::centredGeometry(glm::ivec3(side)), [](const glm::dvec3&) { return 0.0; });
        m_fixture->put(withPlate(plate));
        m_fixture->fill(VolumeField::Segmentation, body, 255);
        m_fixture->settle();
    }
    Frame draw(RenderMode mode, const SegmentDisplay& segments = greenSegment())
    {
        return m_fixture->draw(fromFront(mode), size, segments);
    }

private Q_SLOTS:
    void aBarrierIsSeenWhereItLies_data()
    {
        QTest::addColumn<int>("mode");
        QTest::addColumn<bool>("hasDepth"); // else what lies behind is seen as what lies before
        QTest::newRow("surface") << int(RenderMode::Surface) << true;
        QTest::newRow("DVR") << int(RenderMode::Dvr) << true;
        QTest::newRow("MIP") << int(RenderMode::Mip) << false;
        QTest::newRow("X-ray") << int(RenderMode::Xray) << false;
    }
    void aBarrierIsSeenWhereItLies()
    {
        QFETCH(int, mode);
        QFETCH(bool, hasDepth);
        open({});
        const Frame plain = draw(RenderMode(mode));
        QVERIFY(!isRed(at(plain, beside)));
        const int green = at(plain, overBody).g;
        QVERIFY(green > 60 && !isRed(at(plain, overBody)));

        open(before);
        const Frame front = draw(RenderMode(mode));
        QVERIFY(isRed(at(front, beside)));
        // The segment shows through.
        const glm::ivec3 over = at(front, overBody);
        QVERIFY2(over.r > at(plain, overBody).r + 60, qPrintable(QString::number(over.r)));
        QVERIFY2(over.g > green / 5 && over.g < green, qPrintable(QString::number(over.g)));
        QCOMPARE(at(front, {48, 6}), at(plain, {48, 6})); // far from it

        open(behind);
        const Frame back = draw(RenderMode(mode));
        QVERIFY(isRed(at(back, beside)));
        const glm::ivec3 covered = at(back, overBody);
        if (hasDepth) {
            QVERIFY2(
                covered.r < at(plain, overBody).r + 50, qPrintable(QString::number(covered.r)));
            QVERIFY2(covered.g > green * 7 / 10, qPrintable(QString::number(covered.g)));
        } else {
            QVERIFY(covered.r > at(plain, overBody).r + 60);
        }
    }

    void itsPlaceIsTrueToTheVoxel()
    {
        open(before);
        const Frame frame = draw(RenderMode::Surface);
        // x from 8 to 40: pixels 16 to 80; z from 18 to 30: pixels 36 to 60 from below.
        for (const int x : {17, 22, 78})
            QVERIFY2(isRed(at(frame, {x, 48})), qPrintable(QString::number(x)));
        for (const int x : {13, 83})
            QVERIFY2(!isRed(at(frame, {x, 48})), qPrintable(QString::number(x)));
        for (const int y : {38, 57})
            QVERIFY2(isRed(at(frame, {20, y})), qPrintable(QString::number(y)));
        for (const int y : {33, 63})
            QVERIFY2(!isRed(at(frame, {20, y})), qPrintable(QString::number(y)));
    }

    void whoHidesThemSeesNone_data()
    {
        QTest::addColumn<int>("mode");
        for (int mode = 0; mode < int(renderModes); ++mode)
            QTest::addRow("mode %d", mode) << mode;
    }
    void whoHidesThemSeesNone()
    {
        QFETCH(int, mode);
        open({});
        const Frame plain = draw(RenderMode(mode));
        open(before);
        SegmentDisplay segments = greenSegment();
        QVERIFY(*draw(RenderMode(mode), segments).rgba != *plain.rgba);
        segments.showBarriers = false;
        QCOMPARE(*draw(RenderMode(mode), segments).rgba, *plain.rgba);
        const SliceScene slice{.centreLps = {0, -18.0, 0},
            .downLps = {0, 0, 1},
            .mmPerPixel = 0.5,
            .window = {2000, 1}};
        QCOMPARE(at(m_fixture->draw(slice, size, segments), {25, 48}), glm::ivec3(0));
        segments.showBarriers = true;
        QVERIFY(isRed(at(m_fixture->draw(slice, size, segments), {25, 48})));
    }

    void onceErasedItIsGone()
    {
        open({});
        const Frame plain = draw(RenderMode::Surface);
        open(before);
        QVERIFY(isRed(at(draw(RenderMode::Surface), beside)));
        reference::DenseFields state = withPlate({});
        std::vector<core::BrickImage> images;
        for (const core::BrickKey& key : withPlate(before).occupiedBricks()) {
            if (key.field == core::Field::SeedWords)
                images.push_back({.key = key, .bytes = state.readBrick(key)});
        }
        static_cast<void>(swapImages(*m_fixture->edits.fields, std::move(images)));
        m_fixture->settle();
        QVERIFY(m_fixture->volume.barriers() && !m_fixture->volume.barriers()->any());
        QCOMPARE(*draw(RenderMode::Surface).rgba, *plain.rgba);
    }

    /// Each label plane has barriers of its own; those of the growth that is shown are seen.
    void thoseOfTheShownGrowthAreSeen()
    {
        open({});
        const Frame plain = draw(RenderMode::Surface);
        reference::DenseFields state = withPlate({});
        shut(state, before, 1);
        m_fixture->put(state);
        m_fixture->settle();
        QCOMPARE(*draw(RenderMode::Surface).rgba, *plain.rgba);
        const SliceScene slice{.centreLps = {0, -18.0, 0},
            .downLps = {0, 0, 1},
            .mmPerPixel = 0.5,
            .window = {2000, 1}};
        SegmentDisplay segments = greenSegment();
        QCOMPARE(at(m_fixture->draw(slice, size, segments), {25, 48}), glm::ivec3(0));
        segments.growthPlane = 1;
        static_cast<void>(draw(RenderMode::Surface, segments));
        m_fixture->settle(); // the bricks that hold some are found between edits
        QVERIFY(isRed(at(draw(RenderMode::Surface, segments), beside)));
        QVERIFY(isRed(at(m_fixture->draw(slice, size, segments), {25, 48})));
        segments.growthPlane = 2; // nothing has grown there
        static_cast<void>(draw(RenderMode::Surface, segments));
        m_fixture->settle();
        QCOMPARE(*draw(RenderMode::Surface, segments).rgba, *plain.rgba);
        segments.growthPlane = 0;
        static_cast<void>(draw(RenderMode::Surface, segments));
        m_fixture->settle();
        QCOMPARE(*draw(RenderMode::Surface, segments).rgba, *plain.rgba);
    }

    void aSculptedAwayPlaceShowsIt()
    {
        open(behind);
        m_fixture->carveBox({{8, 8, 8}, {40, 36, 40}});
        QVERIFY(isRed(at(draw(RenderMode::Surface), beside)));
    }

    void aClippedOneIsNotSeen()
    {
        open(before);
        VolumeScene scene = fromFront(RenderMode::Surface);
        scene.clip.box.on = true;
        scene.clip.box.minimum = glm::dvec3(0.0, 10.0, 0.0);
        scene.clip.box.maximum = glm::dvec3(47.0);
        QVERIFY(!isRed(at(m_fixture->draw(scene, size, greenSegment()), beside)));
    }

    void seedsBeforeItStaySolid()
    {
        open(behind);
        VolumeScene scene = fromFront(RenderMode::Surface);
        const auto seeds = std::make_shared<std::vector<SceneSeed>>();
        seeds->push_back({.lps = {-12.5, -10.0, 0.0}, .label = label});
        scene.seeds = seeds;
        const glm::ivec3 colour = at(m_fixture->draw(scene, size, greenSegment()), beside);
        QVERIFY(colour.g > colour.r);
    }
};

BURIN_TEST(BarriersGlTest)

} // namespace barriersGlTest

#include "BarriersGlTest.moc"
