// SPDX-License-Identifier: Apache-2.0
#include "core/document/Document.h"
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>

namespace overlapsShownGlTest {

using namespace gpu;

namespace {

using Bytes = reference::DenseArray<std::uint8_t>;

const glm::ivec3 volumeSize(20, 20, 20);
const glm::ivec2 large(200, 200); // in slices voxel i covers pixels 10·i … 10·i + 9
const glm::ivec3 green(100, 200, 48);
const glm::ivec3 pink(200, 52, 100);

void fill(Bytes& labels, const core::VoxelBox& box, std::uint8_t label)
{
    for (int z = box.minimum.z; z < box.maximum.z; ++z)
        for (int y = box.minimum.y; y < box.maximum.y; ++y)
            for (int x = box.minimum.x; x < box.maximum.x; ++x)
                labels.at({x, y, z}) = label;
}

std::uint32_t packed(const glm::ivec3& rgb)
{
    return std::uint32_t(rgb.r << 16 | rgb.g << 8 | rgb.b);
}

/// Green, label 3, lies in plane 0; pink, label 4, in plane 1.
SegmentDisplay bothShown()
{
    SegmentDisplay segments;
    segments.rgb[3] = packed(green);
    segments.rgb[4] = packed(pink);
    segments.visible[3] = segments.visible[4] = true;
    segments.fillOpacity = 0.5f;
    segments.outlineWidthPixels = 2.0f;
    return segments;
}

SliceScene axial()
{
    SliceScene scene;
    scene.mmPerPixel = 0.1;
    scene.window = {500.0, 1000.0};
    return scene;
}

int apart(const glm::ivec3& a, const glm::ivec3& b)
{
    const glm::ivec3 off = glm::abs(a - b);
    return std::max({off.r, off.g, off.b});
}

} // namespace

/// Segments that overlap, in slices and in the 3D view.
class OverlapsShownGlTest : public test::FrameTest {
    Q_OBJECT

    /// Black everywhere.
    void open(test::FrameFixture& fixture) const
    {
        fixture.open(test::centredGeometry(volumeSize), [](const glm::dvec3&) { return 0.0; });
    }
    /// As the 3D view is told and its textures follow.
    static void show(test::FrameFixture& fixture, const SegmentDisplay& segments)
    {
        std::bitset<256> shown;
        std::bitset<256> translucent;
        for (std::size_t label = 1; label < 256; ++label) {
            shown[label] = segments.visible[label];
            translucent[label] = shown[label] && segments.transparencyPercent[label] > 0;
        }
        fixture.edits.fields->setShownLabels(shown, translucent);
        while (fixture.edits.fields->segmentationStale())
            fixture.edits.fields->updateSegmentation(4);
    }

private Q_SLOTS:
    void slicesShowAllPlanes()
    {
        open(*m_fixture);
        reference::DenseFields state(volumeSize);
        fill(state.labels(0), {{3, 5, 5}, {13, 15, 15}}, 3);
        fill(state.labels(1), {{8, 5, 5}, {18, 15, 15}}, 4);
        m_fixture->put(state);
        SegmentDisplay segments = bothShown();
        Frame frame = m_fixture->draw(axial(), large, segments);
        QCOMPARE(test::pixel(frame, 20, 100), glm::ivec3(0));
        QCOMPARE(test::pixel(frame, 60, 100), green / 2); // one alone
        QCOMPARE(test::pixel(frame, 160, 100), pink / 2); // the other alone
        QCOMPARE(test::pixel(frame, 105, 100), glm::ivec3(125, 76, 62)); // pink over green
        // Every line is whole, and over every fill; where two meet, that of the higher plane is
        // seen.
        for (const int y : {60, 100, 140}) {
            QCOMPARE(test::pixel(frame, 30, y), green);
            QCOMPARE(test::pixel(frame, 129, y), green);
            QCOMPARE(test::pixel(frame, 80, y), pink);
            QCOMPARE(test::pixel(frame, 179, y), pink);
        }
        QCOMPARE(test::pixel(frame, 130, 100), pink / 2);
        QCOMPARE(test::pixel(frame, 79, 100), green / 2);
        QCOMPARE(test::pixel(frame, 105, 50), pink);
        QCOMPARE(test::pixel(frame, 60, 50), green);
        // Half as opaque, above: fill and line.
        segments.transparencyPercent[4] = 50;
        frame = m_fixture->draw(axial(), large, segments);
        const double half = 128.0 / 255.0; // 50 %, as the palette holds it
        const auto over = [](const glm::ivec3& below, const glm::ivec3& above, double share) {
            return glm::ivec3(glm::round(glm::mix(glm::dvec3(below), glm::dvec3(above), share)));
        };
        QVERIFY(apart(test::pixel(frame, 105, 100), over(green / 2, pink, 0.5 * half)) <= 1);
        QVERIFY(apart(test::pixel(frame, 80, 100), over(green / 2, pink, half)) <= 1);
        segments.visible[4] = false;
        frame = m_fixture->draw(axial(), large, segments);
        QCOMPARE(test::pixel(frame, 105, 100), green / 2);
        QCOMPARE(test::pixel(frame, 160, 100), glm::ivec3(0));
        segments.visible = {};
        segments.visible[4] = true;
        segments.transparencyPercent = {};
        frame = m_fixture->draw(axial(), large, segments);
        QCOMPARE(test::pixel(frame, 105, 100), pink / 2);
        QCOMPARE(test::pixel(frame, 60, 100), glm::ivec3(0));
    }

    /// As many as there can be, one on the other.
    void fillsAreBlendedInTheirOrder()
    {
        const glm::ivec3 colours[] = {{240, 0, 0}, {0, 240, 0}, {0, 0, 240}, {240, 240, 0}};
        open(*m_fixture);
        reference::DenseFields state(volumeSize);
        SegmentDisplay segments = bothShown();
        segments.visible = {};
        glm::dvec3 expected(0.0);
        for (int plane = 0; plane < core::mostLabelPlanes; ++plane) {
            const auto label = std::uint8_t(10 + plane);
            // Each a little smaller, so that no line hides another.
            fill(state.labels(std::uint8_t(plane)), {glm::ivec3(3 + plane), glm::ivec3(17 - plane)},
                label);
            segments.rgb[label] = packed(colours[plane]);
            segments.visible[label] = true;
            m_fixture->put(state);
            const Frame frame = m_fixture->draw(axial(), large, segments);
            expected = glm::mix(expected, glm::dvec3(colours[plane]), 0.5);
            QVERIFY(apart(test::pixel(frame, 100, 100), glm::ivec3(glm::round(expected))) <= 1);
            for (int outer = 0; outer <= plane; ++outer)
                QCOMPARE(test::pixel(frame, 10 * (3 + outer), 100), colours[outer]);
        }
    }

    /// A plane that holds nothing changes no pixel, and neither does one that was emptied again.
    void anEmptyPlaneChangesNothing()
    {
        open(*m_fixture);
        reference::DenseFields state(volumeSize);
        fill(state.labels(0), {{3, 5, 5}, {13, 15, 15}}, 3);
        m_fixture->put(state);
        const SegmentDisplay segments = bothShown();
        VolumeScene volume;
        volume.heightMm = 30.0;
        show(*m_fixture, segments);
        const Frame slice = m_fixture->draw(axial(), large, segments);
        const Frame body = m_fixture->draw(volume, large, segments);
        QCOMPARE(test::pixel(slice, 60, 100), green / 2);
        QVERIFY(test::pixel(body, 80, 100).g > test::pixel(body, 80, 100).r);
        (void)m_fixture->edits.fields->labels(1);
        show(*m_fixture, segments);
        QVERIFY(*m_fixture->draw(axial(), large, segments).rgba == *slice.rgba);
        QVERIFY(*m_fixture->draw(volume, large, segments).rgba == *body.rgba);
    }

    /// The picture of several planes is that of the one plane to which they are composed.
    void bodiesAreThoseOfWhatIsSeen_data()
    {
        QTest::addColumn<int>("greenTransparency");
        QTest::addColumn<int>("pinkTransparency");
        QTest::addColumn<bool>("voxelTrue");
        QTest::addColumn<bool>("pinkWins");
        QTest::newRow("both opaque") << 0 << 0 << false << true;
        QTest::newRow("both opaque, voxel by voxel") << 0 << 0 << true << true;
        QTest::newRow("an opaque one within a translucent one") << 50 << 0 << false << true;
        QTest::newRow("the same, and the other is higher") << 0 << 50 << false << false;
        QTest::newRow("the same, voxel by voxel") << 0 << 50 << true << false;
        QTest::newRow("both translucent") << 40 << 60 << false << true;
    }

    void bodiesAreThoseOfWhatIsSeen()
    {
        QFETCH(int, greenTransparency);
        QFETCH(int, pinkTransparency);
        QFETCH(bool, voxelTrue);
        QFETCH(bool, pinkWins);
        SegmentDisplay segments = bothShown();
        segments.transparencyPercent[3] = std::uint8_t(greenTransparency);
        segments.transparencyPercent[4] = std::uint8_t(pinkTransparency);
        segments.voxelTrue = voxelTrue;
        const core::VoxelBox greens{{3, 5, 5}, {13, 15, 15}};
        const core::VoxelBox pinks{{8, 3, 8}, {18, 12, 17}};
        reference::DenseFields two(volumeSize);
        fill(two.labels(0), greens, 3);
        fill(two.labels(1), pinks, 4);
        reference::DenseFields one(volumeSize);
        fill(one.labels(0), pinkWins ? greens : pinks, pinkWins ? 3 : 4);
        fill(one.labels(0), pinkWins ? pinks : greens, pinkWins ? 4 : 3);
        VolumeScene scene;
        scene.eyeLps = {120.0, -500.0, 90.0};
        scene.heightMm = 32.0;
        std::vector<Frame> frames;
        for (const reference::DenseFields* state : {&two, &one}) {
            m_fixture.emplace();
            open(*m_fixture);
            m_fixture->put(*state);
            show(*m_fixture, segments);
            frames.push_back(m_fixture->draw(scene, {96, 96}, segments));
        }
        int greenPixels = 0;
        int pinkPixels = 0;
        for (int y = 0; y < 96; ++y) {
            for (int x = 0; x < 96; ++x) {
                const glm::ivec3 rgb = test::pixel(frames[0], x, y);
                greenPixels += rgb.g > rgb.r + 20 ? 1 : 0;
                pinkPixels += rgb.r > rgb.g + 20 ? 1 : 0;
            }
        }
        QVERIFY(greenPixels > 100);
        QVERIFY(pinkPixels > 100);
        QVERIFY(*frames[0].rgba == *frames[1].rgba);
    }
};

BURIN_TEST(OverlapsShownGlTest)

} // namespace overlapsShownGlTest

#include "OverlapsShownGlTest.moc"
