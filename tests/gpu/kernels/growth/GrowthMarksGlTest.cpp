// SPDX-License-Identifier: Apache-2.0
#include "core/growth/SeedWord.h"
#include "gpu/kernels/growth/ComparedGrowth.h"
#include "gpu/kernels/growth/GrowthMarks.h"
#include "gpu/kernels/shrink/CutPreviewer.h"
#include "tests/support/fixtures/frames/FrameTest.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <numeric>

namespace growthMarksGlTest {

using namespace gpu;

namespace {

constexpr int side = 48;
constexpr std::uint32_t label = 7;
constexpr std::uint32_t late = 5; ///< generation of the right half

/// A segment: a box that grew from left to right; above it a row of voxels is shut.
reference::DenseFields grownBox(std::uint8_t plane = 0)
{
    reference::DenseFields state(glm::ivec3{side});
    for (int z = 12; z < 36; ++z) {
        for (int y = 12; y < 36; ++y) {
            for (int x = 12; x < 36; ++x) {
                const std::uint32_t generation = x < 24 ? late - 2 : late;
                state.labels(plane).at({x, y, z}) = std::uint8_t(label);
                state.seedWords(plane).at({x, y, z}) =
                    core::seedWord::member(generation, std::uint8_t(label), 0);
            }
        }
    }
    for (int x = 12; x < 36; ++x) {
        for (int y = 2; y < 8; ++y)
            state.seedWords(plane).at({x, y, 24}) = core::seedWord::barrier;
    }
    return state;
}

SegmentDisplay greenSegment()
{
    SegmentDisplay segments;
    segments.rgb[label] = 0x00C000;
    segments.visible[label] = true;
    segments.warningRgb = 0xFF8000;
    segments.fillOpacity = 1.0f;
    return segments;
}

SliceScene axial()
{
    return {.centreLps = {0.0, 0.0, 0.5}, .mmPerPixel = 0.5, .window = {2000.0, 1.0}};
}

bool isGreen(const glm::ivec3& colour)
{
    return colour.g > 60 && colour.g > 3 * colour.r && colour.g > 3 * colour.b;
}

/// The voxels of the right half, one by one.
core::PreviewCut rightHalfGoes(std::uint8_t plane = 0)
{
    core::PreviewCut question{
        .cut = {.plane = plane, .how = core::CutGrowth::How::Here, .generation = late}};
    for (int z = 12; z < 36; ++z)
        for (int y = 12; y < 36; ++y)
            for (int x = 24; x < 36; ++x)
                question.cut.voxels.emplace_back(x, y, z);
    return question;
}

/// The same with another interval: the middle has left, and it has grown on to the right.
reference::DenseFields movedBox(std::uint8_t plane = 0)
{
    reference::DenseFields state = grownBox(plane);
    for (int z = 12; z < 36; ++z) {
        for (int y = 12; y < 36; ++y) {
            for (int x = 24; x < 30; ++x) {
                state.labels(plane).at({x, y, z}) = 0;
                state.seedWords(plane).at({x, y, z}) = core::seedWord::unvisited;
            }
            for (int x = 36; x < 44; ++x) {
                state.labels(plane).at({x, y, z}) = std::uint8_t(label);
                state.seedWords(plane).at({x, y, z}) = core::seedWord::member(late + 1, label, 0);
            }
        }
    }
    return state;
}

bool isRed(const glm::ivec3& colour)
{
    return colour.r > 40 && colour.r > 2 * colour.g && colour.r > 2 * colour.b;
}

/// Like isRed(), also of the dark stripes through what is translucent.
bool isReddish(const glm::ivec3& colour)
{
    return colour.r > 25 && 2 * colour.r > 3 * colour.g && 2 * colour.r > 3 * colour.b;
}

VolumeScene seenFrom(const glm::dvec3& eyeLps, RenderMode mode)
{
    VolumeScene scene;
    scene.eyeLps = eyeLps;
    scene.heightMm = side;
    scene.mode = mode;
    scene.surfaceThreshold = 1000.0;
    scene.mipWindow = scene.xrayWindow = {2000.0, 1000.0};
    scene.transferFunction.points = {{990.0, 0xFFFFFF, 0.0}, {1000.0, 0xFFFFFF, 0.9}};
    return scene;
}

/// The segment's green, lightened.
bool isPale(const glm::ivec3& colour)
{
    return colour.g > 60 && 4 * colour.r > colour.g && colour.g > colour.r;
}

bool isMagenta(const glm::ivec3& colour)
{
    return colour.r > 40 && colour.r > 2 * colour.g && colour.b > 2 * colour.g;
}

bool warns(const glm::ivec3& colour)
{
    return colour.r > 80 && colour.r > colour.g && colour.g > 2 * colour.b;
}

} // namespace

/// What pictures tell of a growth: where it is shut out, and what came after it may have leaked.
class GrowthMarksGlTest : public test::FrameTest {
    Q_OBJECT

private:
    void open(std::uint8_t plane = 0)
    {
        m_fixture->open(
            test::centredGeometry(glm::ivec3(side)), [](const glm::dvec3&) { return 0.0; });
        m_fixture->put(grownBox(plane));
        m_fixture->settle();
    }
    /// Puts movedBox() there. @return what that has changed
    ComparedGrowth move(std::uint8_t plane = 0)
    {
        VoxelFields& fields = *m_fixture->edits.fields;
        std::vector<std::uint32_t> bricks(std::size_t(fields.grid().brickCount()));
        std::iota(bricks.begin(), bricks.end(), 0u);
        std::vector<core::BrickKey> touched;
        for (const core::Field field : {core::Field::Labels, core::Field::SeedWords}) {
            for (const std::uint32_t brick : bricks)
                touched.push_back({.field = field, .plane = plane, .brick = brick});
        }
        BeforeImages before(fields);
        before.capture(core::Field::Labels, plane, bricks);
        m_fixture->put(movedBox(plane));
        m_fixture->settle();
        return compareGrowth(fields, before, plane, touched);
    }

    /// Rows for label planes in which a segment has grown.
    static void planes()
    {
        QTest::addColumn<int>("plane");
        QTest::newRow("in the only label plane") << 0;
        QTest::newRow("in a further one") << 2;
    }

private Q_SLOTS:
    void placesThatAreShutAreStriped()
    {
        open();
        const Frame frame = m_fixture->draw(axial(), {96, 96}, greenSegment());
        int bright = 0;
        int dim = 0;
        for (int y = 6; y < 14; ++y) {
            for (int x = 28; x < 68; ++x) {
                const glm::ivec3 colour = test::pixel(frame, x, y);
                QVERIFY(colour.r > 2 * colour.g);
                bright += colour.r > 150 ? 1 : 0;
                dim += colour.r < 90 ? 1 : 0;
            }
        }
        QVERIFY(bright > 80);
        QVERIFY(dim > 80);
        QCOMPARE(test::pixel(frame, 8, 8), glm::ivec3(0));
    }

    void whatCameLateWarnsInSlices_data() { planes(); }
    void whatCameLateWarnsInSlices()
    {
        QFETCH(int, plane);
        open(std::uint8_t(plane));
        SegmentDisplay segments = greenSegment();
        segments.growthPlane = std::uint8_t(plane);
        QVERIFY(isGreen(test::pixel(m_fixture->draw(axial(), {96, 96}, segments), 60, 48)));
        segments.warnAfterGeneration = late - 1;
        const Frame frame = m_fixture->draw(axial(), {96, 96}, segments);
        QVERIFY(warns(test::pixel(frame, 60, 48)));
        QVERIFY(isGreen(test::pixel(frame, 36, 48)));
        segments.warnAfterGeneration = late;
        QVERIFY(isGreen(test::pixel(m_fixture->draw(axial(), {96, 96}, segments), 60, 48)));
    }

    void whatCameLateWarnsIn3D_data()
    {
        QTest::addColumn<int>("mode");
        QTest::newRow("surface") << int(RenderMode::Surface);
        QTest::newRow("DVR") << int(RenderMode::Dvr);
        QTest::newRow("MIP") << int(RenderMode::Mip);
        QTest::newRow("X-ray") << int(RenderMode::Xray);
    }
    void whatCameLateWarnsIn3D()
    {
        QFETCH(int, mode);
        open();
        m_fixture->fill(VolumeField::Segmentation, {{12, 12, 12}, {36, 36, 36}}, 255);
        VolumeScene scene;
        scene.eyeLps = {0, -300, 0};
        scene.heightMm = side;
        scene.mode = RenderMode(mode);
        scene.surfaceThreshold = 1000.0;
        scene.mipWindow = scene.xrayWindow = {2000.0, 1000.0};
        scene.transferFunction.points = {{990.0, 0xFFFFFF, 0.0}, {1000.0, 0xFFFFFF, 0.9}};
        SegmentDisplay segments = greenSegment();
        const Frame plain = m_fixture->draw(scene, {96, 96}, segments);
        QVERIFY(isGreen(test::pixel(plain, 36, 48)) && isGreen(test::pixel(plain, 60, 48)));
        segments.warnAfterGeneration = late - 1;
        const Frame frame = m_fixture->draw(scene, {96, 96}, segments);
        QVERIFY(isGreen(test::pixel(frame, 36, 48)));
        QVERIFY(warns(test::pixel(frame, 60, 48)));
    }

    void whatACutWouldTakeIsHatchedInSlices_data() { planes(); }
    void whatACutWouldTakeIsHatchedInSlices()
    {
        QFETCH(int, plane);
        open(std::uint8_t(plane));
        SegmentDisplay segments = greenSegment();
        segments.growthPlane = std::uint8_t(plane);
        const Frame plain = m_fixture->draw(axial(), {96, 96}, segments);
        CutPreviewer previewer(m_fixture->volume);
        const auto cutPreview =
            previewer.ask(*m_fixture->edits.fields, rightHalfGoes(std::uint8_t(plane)));
        QVERIFY(cutPreview && *cutPreview);
        QCOMPARE((*cutPreview)->voxels, std::int64_t(12 * 24 * 24));
        const Frame frame = m_fixture->draw(axial(), {96, 96}, segments);
        int bright = 0;
        int dark = 0;
        for (int y = 30; y < 66; ++y) {
            for (int x = 52; x < 68; ++x) {
                const glm::ivec3 colour = test::pixel(frame, x, y);
                QVERIFY(!isGreen(colour));
                bright += colour.r > 140 ? 1 : 0;
                dark += colour.r < 110 ? 1 : 0;
            }
        }
        QVERIFY(bright > 100);
        QVERIFY(dark > 100);
        for (int x = 28; x < 46; ++x)
            QVERIFY(isGreen(test::pixel(frame, x, 48)));
        // Whatever is shown of the segment.
        segments.visible[label] = false;
        QVERIFY(isMagenta(test::pixel(m_fixture->draw(axial(), {96, 96}, segments), 69, 48)));
        segments.visible[label] = true;
        previewer.forget();
        QCOMPARE(*m_fixture->draw(axial(), {96, 96}, segments).rgba, *plain.rgba);
    }

    void whatAnIntervalChangesIsStripedInSlices_data() { planes(); }
    void whatAnIntervalChangesIsStripedInSlices()
    {
        QFETCH(int, plane);
        open(std::uint8_t(plane));
        ComparedGrowth compared = move(std::uint8_t(plane));
        QCOMPARE(compared.counts.suspended, std::int64_t(6 * 24 * 24));
        QCOMPARE(compared.counts.reached, std::int64_t(8 * 24 * 24));
        SegmentDisplay segments = greenSegment();
        segments.growthPlane = std::uint8_t(plane);
        const Frame plain = m_fixture->draw(axial(), {96, 96}, segments);
        PreviewMarks marks(m_fixture->volume);
        marks.show(*m_fixture->edits.fields, compared.bricks, std::uint8_t(plane));
        const Frame frame = m_fixture->draw(axial(), {96, 96}, segments);
        int bright = 0;
        int dark = 0;
        int pale = 0;
        int green = 0;
        for (int y = 30; y < 66; ++y) {
            for (int x = 50; x < 58; ++x) { // suspended
                const glm::ivec3 colour = test::pixel(frame, x, y);
                QVERIFY(isRed(colour));
                bright += colour.r > 110 ? 1 : 0;
                dark += colour.r < 90 ? 1 : 0;
            }
            for (int x = 75; x < 85; ++x) { // reached
                const glm::ivec3 colour = test::pixel(frame, x, y);
                QVERIFY(isPale(colour) || isGreen(colour));
                ++(isGreen(colour) ? green : pale);
            }
            for (int x = 28; x < 46; ++x)
                QVERIFY(isGreen(test::pixel(frame, x, y)));
        }
        QVERIFY(bright > 60 && dark > 40);
        QVERIFY(pale > 60 && green > 60);
        // A segment that is hidden shows nothing new, but what it loses.
        segments.visible[label] = false;
        const Frame hidden = m_fixture->draw(axial(), {96, 96}, segments);
        QVERIFY(isRed(test::pixel(hidden, 53, 48)));
        QCOMPARE(test::pixel(hidden, 80, 48), glm::ivec3(0));
        segments.visible[label] = true;
        // Only what differs is written anew; the rest stays.
        marks.show(*m_fixture->edits.fields, {}, std::uint8_t(plane));
        QCOMPARE(*m_fixture->draw(axial(), {96, 96}, segments).rgba, *plain.rgba);
        marks.show(*m_fixture->edits.fields, compared.bricks, std::uint8_t(plane));
        QCOMPARE(*m_fixture->draw(axial(), {96, 96}, segments).rgba, *frame.rgba);
        marks.hide();
        QCOMPARE(*m_fixture->draw(axial(), {96, 96}, segments).rgba, *plain.rgba);
        // Whoever hides his own marks leaves those of others.
        CutPreviewer previewer(m_fixture->volume);
        marks.show(*m_fixture->edits.fields, compared.bricks, std::uint8_t(plane));
        previewer.forget();
        QCOMPARE(*m_fixture->draw(axial(), {96, 96}, segments).rgba, *frame.rgba);
        marks.hide();
    }

    void whatAnIntervalReachesIsStripedIn3D()
    {
        open();
        const ComparedGrowth compared = move();
        m_fixture->fill(VolumeField::Segmentation, {{12, 12, 12}, {44, 36, 36}}, 255);
        VolumeScene scene;
        scene.mode = RenderMode::Surface;
        scene.eyeLps = {0, -300, 0};
        scene.heightMm = side;
        scene.surfaceThreshold = 1000.0;
        SegmentDisplay segments = greenSegment();
        segments.showBarriers = false;
        const Frame plain = m_fixture->draw(scene, {96, 96}, segments);
        PreviewMarks marks(m_fixture->volume);
        marks.show(*m_fixture->edits.fields, compared.bricks);
        const Frame frame = m_fixture->draw(scene, {96, 96}, segments);
        int pale = 0;
        int green = 0;
        for (int y = 32; y < 64; ++y) {
            for (int x = 76; x < 85; ++x) {
                const glm::ivec3 colour = test::pixel(frame, x, y);
                QVERIFY(isPale(colour) || isGreen(colour));
                ++(isGreen(colour) ? green : pale);
            }
            for (int x = 28; x < 44; ++x)
                QVERIFY(isGreen(test::pixel(frame, x, y)));
        }
        QVERIFY(pale > 50 && green > 50);
        marks.hide();
        QCOMPARE(*m_fixture->draw(scene, {96, 96}, segments).rgba, *plain.rgba);
    }

    void whatAnIntervalSuspendsHasABodyIfAskedFor_data() { whatCameLateWarnsIn3D_data(); }
    void whatAnIntervalSuspendsHasABodyIfAskedFor()
    {
        QFETCH(int, mode);
        open();
        const ComparedGrowth compared = move();
        m_fixture->fill(VolumeField::Segmentation, {{12, 12, 12}, {24, 36, 36}}, 255);
        m_fixture->fill(VolumeField::Segmentation, {{30, 12, 12}, {44, 36, 36}}, 255);
        VolumeScene scene = seenFrom({0, -300, 0}, RenderMode(mode));
        SegmentDisplay segments = greenSegment();
        segments.showBarriers = false;
        SegmentDisplay withBodies = segments;
        withBodies.suspendedBodies = true;
        // Without marks there is nothing to show.
        const Frame unmarked = m_fixture->draw(scene, {96, 96}, segments);
        QCOMPARE(*m_fixture->draw(scene, {96, 96}, withBodies).rgba, *unmarked.rgba);
        PreviewMarks marks(m_fixture->volume);
        marks.show(*m_fixture->edits.fields, compared.bricks);
        QCOMPARE(m_fixture->volume.suspended().minimum, glm::ivec3(16, 0, 0));
        QCOMPARE(m_fixture->volume.suspended().maximum, glm::ivec3(32, 48, 48));
        const Frame plain = m_fixture->draw(scene, {96, 96}, segments);
        const Frame frame = m_fixture->draw(scene, {96, 96}, withBodies);
        // Voxels 24 to 30 along x: pixels 48 to 60.
        int bright = 0;
        int dark = 0;
        for (int y = 34; y < 62; ++y) {
            for (int x = 51; x < 57; ++x) {
                QVERIFY(!isReddish(test::pixel(plain, x, y)));
                const glm::ivec3 colour = test::pixel(frame, x, y);
                QVERIFY2(isReddish(colour),
                    qPrintable(
                        QStringLiteral("%1 %2 %3").arg(colour.r).arg(colour.g).arg(colour.b)));
                ++(colour.r > 85 ? bright : dark);
            }
            for (int x = 28; x < 44; ++x)
                QVERIFY(isGreen(test::pixel(frame, x, y)));
        }
        QVERIFY(bright > 40 && dark > 25);
        // Above the body, beside it, and far from it nothing has changed.
        for (const glm::ivec2 place : {glm::ivec2(54, 14), {54, 82}, {4, 48}, {92, 48}})
            QCOMPARE(test::pixel(frame, place.x, place.y), test::pixel(plain, place.x, place.y));
        // Translucent segments are drawn by other programs.
        SegmentDisplay translucent = withBodies;
        translucent.transparencyPercent[label] = 50;
        QVERIFY(isReddish(test::pixel(m_fixture->draw(scene, {96, 96}, translucent), 54, 48)));
        // What is clipped is not seen.
        scene.clip.box = {.minimum = glm::dvec3(-0.5), .maximum = {23.0, 47.5, 47.5}, .on = true};
        QVERIFY(!isReddish(test::pixel(m_fixture->draw(scene, {96, 96}, withBodies), 54, 48)));
        scene.clip = {};
        marks.hide();
        QVERIFY(m_fixture->volume.suspended().empty());
        QCOMPARE(*m_fixture->draw(scene, {96, 96}, withBodies).rgba, *unmarked.rgba);
    }

    void behindItsSegmentABodyShinesThrough()
    {
        open();
        const ComparedGrowth compared = move();
        m_fixture->fill(VolumeField::Segmentation, {{12, 12, 12}, {24, 36, 36}}, 255);
        m_fixture->fill(VolumeField::Segmentation, {{30, 12, 12}, {44, 36, 36}}, 255);
        const VolumeScene scene = seenFrom({-300, 0, 0}, RenderMode::Surface);
        SegmentDisplay segments = greenSegment();
        segments.showBarriers = false;
        PreviewMarks marks(m_fixture->volume);
        marks.show(*m_fixture->edits.fields, compared.bricks);
        const glm::ivec3 plain = test::pixel(m_fixture->draw(scene, {96, 96}, segments), 48, 48);
        segments.suspendedBodies = true;
        const glm::ivec3 over = test::pixel(m_fixture->draw(scene, {96, 96}, segments), 48, 48);
        QVERIFY(isGreen(plain));
        QVERIFY2(over.r > plain.r + 6, qPrintable(QString::number(over.r)));
        QVERIFY2(3 * over.g > 2 * plain.g && over.g < plain.g, qPrintable(QString::number(over.g)));
        marks.hide();
    }

    void whatAnEarlierGrowthHasSuspendedIsSuspendedOrBack()
    {
        const auto brick = [](std::uint32_t number,
                               const std::array<PreviewMarks::Mark, 3>& first) {
            std::vector<std::uint8_t> marks(core::BrickGrid::voxelsPerBrick, PreviewMarks::None);
            std::copy(first.begin(), first.end(), marks.begin());
            return PreviewMarks::Brick{.brick = number, .marks = marks};
        };
        constexpr auto none = PreviewMarks::None;
        constexpr auto suspended = PreviewMarks::Suspended;
        constexpr auto reached = PreviewMarks::Reached;
        constexpr auto reinstated = PreviewMarks::Reinstated;
        const GrowthMarks::Bricks kept{brick(3, {suspended, suspended, reached}),
            brick(5, {none, reached, reinstated}), brick(9, {none, none, suspended})};
        const GrowthMarks::Bricks changed{
            brick(3, {none, reached, suspended}), brick(7, {reached, none, none})};
        const GrowthMarks::Bricks after{brick(3, {suspended, reinstated, suspended}),
            brick(7, {reached, none, none}), brick(9, {none, none, suspended})};
        QVERIFY(marksAfter(kept, changed) == after);
        QVERIFY(marksAfter({}, changed) == changed);
        QVERIFY(marksAfter({}, {}).empty());
    }

    /// A growth in another label plane is another growth.
    void whatWasSuspendedIsOfOnePlane()
    {
        open(1);
        VoxelFields& fields = *m_fixture->edits.fields;
        const ComparedGrowth compared = move(1);
        fields.showGrowth(1);
        GrowthMarks marks(m_fixture->volume);
        marks.begin(1);
        marks.show(fields, compared.bricks, true);
        marks.keep(fields, compared.bricks);
        marks.begin(1);
        QVERIFY(m_fixture->volume.cutPreview());
        fields.showGrowth(0); // they are not of the growth that is shown then
        QVERIFY(!m_fixture->volume.cutPreview());
        fields.showGrowth(1);
        QVERIFY(m_fixture->volume.cutPreview());
        marks.begin(0);
        QVERIFY(!m_fixture->volume.cutPreview());
        marks.restore(fields);
        QVERIFY(!m_fixture->volume.cutPreview());
        marks.begin(1);
        marks.show(fields, compared.bricks, true);
        marks.keep(fields, compared.bricks);
        marks.begin({});
        QVERIFY(!m_fixture->volume.cutPreview());
    }

    void whatIsReinstatedIsStripedRedInItsColour()
    {
        open();
        ComparedGrowth compared = move();
        for (PreviewMarks::Brick& brick : compared.bricks)
            std::replace(brick.marks.begin(), brick.marks.end(),
                std::uint8_t(PreviewMarks::Reached), std::uint8_t(PreviewMarks::Reinstated));
        m_fixture->fill(VolumeField::Segmentation, {{12, 12, 12}, {44, 36, 36}}, 255);
        SegmentDisplay segments = greenSegment();
        segments.showBarriers = false;
        PreviewMarks marks(m_fixture->volume);
        marks.show(*m_fixture->edits.fields, compared.bricks);
        const std::array<Frame, 2> frames{m_fixture->draw(axial(), {96, 96}, segments),
            m_fixture->draw(seenFrom({0, -300, 0}, RenderMode::Surface), {96, 96}, segments)};
        for (const Frame& frame : frames) {
            int red = 0;
            int green = 0;
            for (int y = 32; y < 64; ++y) {
                for (int x = 76; x < 85; ++x) {
                    const glm::ivec3 colour = test::pixel(frame, x, y);
                    const bool isRedder = colour.r > 100 && colour.r > colour.g;
                    QVERIFY(isRedder || isGreen(colour));
                    ++(isRedder ? red : green);
                }
                for (int x = 28; x < 44; ++x)
                    QVERIFY(isGreen(test::pixel(frame, x, y)));
            }
            QVERIFY(red > 50 && green > 50);
        }
        marks.hide();
    }

    /// Where a segment of a higher label plane is seen, the marks of what lies below are not.
    void aHigherSegmentHidesTheMarksBelow()
    {
        constexpr std::uint8_t other = 9;
        m_fixture->open(
            test::centredGeometry(glm::ivec3(side)), [](const glm::dvec3&) { return 0.0; });
        reference::DenseFields state = grownBox();
        for (int z = 12; z < 36; ++z)
            for (int y = 12; y < 36; ++y)
                for (int x = 30; x < 36; ++x)
                    state.labels(1).at({x, y, z}) = other;
        m_fixture->put(state);
        SegmentDisplay segments = greenSegment();
        segments.showBarriers = false;
        segments.rgb[other] = 0x2030D0;
        segments.visible[other] = true;
        const VolumeScene scene = seenFrom({0, -300, 0}, RenderMode::Surface);
        VoxelFields& fields = *m_fixture->edits.fields;
        fields.setShownLabels(std::bitset<256>().set(label).set(other));
        while (fields.segmentationStale())
            fields.updateSegmentation(64);
        const Frame plain = m_fixture->draw(scene, {96, 96}, segments);
        CutPreviewer previewer(m_fixture->volume);
        QVERIFY(previewer.ask(fields, rightHalfGoes()));
        const Frame frame = m_fixture->draw(scene, {96, 96}, segments);
        for (int y = 32; y < 64; ++y) {
            for (int x = 51; x < 57; ++x)
                QVERIFY(isMagenta(test::pixel(frame, x, y)));
            for (int x = 64; x < 68; ++x) {
                const glm::ivec3 colour = test::pixel(frame, x, y);
                QVERIFY(colour.b > 2 * colour.r);
                QCOMPARE(colour, test::pixel(plain, x, y));
            }
        }
    }

    void whatACutWouldTakeIsHatchedIn3D_data() { whatCameLateWarnsIn3D_data(); }
    void whatACutWouldTakeIsHatchedIn3D()
    {
        QFETCH(int, mode);
        open();
        m_fixture->fill(VolumeField::Segmentation, {{12, 12, 12}, {36, 36, 36}}, 255);
        VolumeScene scene;
        scene.eyeLps = {0, -300, 0};
        scene.heightMm = side;
        scene.mode = RenderMode(mode);
        scene.surfaceThreshold = 1000.0;
        scene.mipWindow = scene.xrayWindow = {2000.0, 1000.0};
        scene.transferFunction.points = {{990.0, 0xFFFFFF, 0.0}, {1000.0, 0xFFFFFF, 0.9}};
        SegmentDisplay segments = greenSegment();
        segments.showBarriers = false;
        const Frame plain = m_fixture->draw(scene, {96, 96}, segments);
        CutPreviewer previewer(m_fixture->volume);
        QVERIFY(previewer.ask(*m_fixture->edits.fields, rightHalfGoes()));
        const Frame frame = m_fixture->draw(scene, {96, 96}, segments);
        for (int y = 32; y < 64; ++y) {
            for (int x = 28; x < 46; ++x)
                QVERIFY(isGreen(test::pixel(frame, x, y)));
            for (int x = 51; x < 68; ++x)
                QVERIFY(isMagenta(test::pixel(frame, x, y)));
        }
        previewer.forget();
        QCOMPARE(*m_fixture->draw(scene, {96, 96}, segments).rgba, *plain.rgba);
    }
};

BURIN_TEST(GrowthMarksGlTest)

} // namespace growthMarksGlTest

#include "GrowthMarksGlTest.moc"
