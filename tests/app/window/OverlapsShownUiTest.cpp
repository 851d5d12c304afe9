// SPDX-License-Identifier: Apache-2.0
#include "core/brick/VoxelRuns.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/ApplicationFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/PlainMasks.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/Workspace.h"

#include <QImage>
#include <QTest>

#include <algorithm>

namespace overlapsShownUiTest {

namespace {

constexpr std::uint32_t firstRgb = 0x30C060;
constexpr std::uint32_t secondRgb = 0xE04080;
constexpr glm::ivec3 inFirst(14, 18, 17);
constexpr glm::ivec3 inBoth(20, 18, 17);
constexpr glm::ivec3 inSecond(26, 18, 17);

core::VoxelRuns boxOf(const glm::ivec3& size, const glm::ivec3& from, const glm::ivec3& to)
{
    core::VoxelRuns runs;
    for (int z = from.z; z < to.z; ++z) {
        for (int y = from.y; y < to.y; ++y)
            runs.append(
                std::uint64_t((z * size.y + y) * size.x + from.x), std::uint64_t(to.x - from.x));
    }
    return runs;
}

/// Two boxes in the brain of the small study, side by side, with a part in both.
core::Edit overlappingMask()
{
    const glm::ivec3 size = test::smallStudy().volume.geometry.size;
    return test::maskImport(QStringLiteral("two.seg.nrrd"), size,
        {{QStringLiteral("First"), boxOf(size, {11, 13, 12}, {24, 23, 22}), firstRgb},
            {QStringLiteral("Second"), boxOf(size, {16, 13, 12}, {29, 23, 22}), secondRgb}},
        {0, 1});
}

glm::dvec3 colourOf(std::uint32_t rgb)
{
    return {double(rgb >> 16), double(rgb >> 8 & 0xFFu), double(rgb & 0xFFu)};
}

} // namespace

/// The program with its own renderer: what lies in several label planes is seen, and painting in
/// one leaves the other.
class OverlapsShownUiTest : public QObject, private test::WithApplication {
    Q_OBJECT

    [[nodiscard]] glm::dvec3 seenAt(const glm::ivec3& voxel) const
    {
        ui::SliceView& axial = window().views().axial();
        const glm::dvec3 place = workspace().volume()->geometry.toWorld(glm::dvec3(voxel));
        const QColor colour =
            axial.grab().toImage().pixelColor(axial.context().toPixel(place).toPoint());
        return {colour.red(), colour.green(), colour.blue()};
    }
    [[nodiscard]] bool shows(const glm::ivec3& voxel, const glm::dvec3& expected) const
    {
        const glm::dvec3 off = glm::abs(seenAt(voxel) - expected);
        return std::max({off.r, off.g, off.b}) <= 4.0;
    }

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        makeApplication();
        open(path("case/ct"));
    }
    void cleanup() { dropApplication(); }

    void bothAreSeenAndPaintedApart()
    {
        const core::VolumeGeometry geometry = workspace().volume()->geometry;
        // Its lines are nowhere near.
        workspace().setCrosshairLps(geometry.toWorld(glm::dvec3(33.0, 30.0, 17.0)));
        ui::SliceView& axial = window().views().axial();
        QTRY_VERIFY_WITH_TIMEOUT(axial.quality() && seenAt(inBoth).r > 20.0, patience);
        const glm::dvec3 grey = seenAt(inBoth);
        QVERIFY(grey.r == grey.g && grey.g == grey.b);
        QVERIFY(shows(inFirst, grey) && shows(inSecond, grey)); // all of it is brain

        edit(overlappingMask());
        const double fill = workspace().viewOptions().segmentFillPercent / 100.0;
        const glm::dvec3 first = glm::mix(grey, colourOf(firstRgb), fill);
        const glm::dvec3 second = glm::mix(grey, colourOf(secondRgb), fill);
        const glm::dvec3 both = glm::mix(first, colourOf(secondRgb), fill);
        QTRY_VERIFY_WITH_TIMEOUT(shows(inBoth, both), patience);
        QTRY_VERIFY_WITH_TIMEOUT(shows(inFirst, first), patience);
        QTRY_VERIFY_WITH_TIMEOUT(shows(inSecond, second), patience);

        const std::int64_t voxels = session().document().segment(1)->voxels;
        edit(test::eraseAt(2, {geometry.toWorld(glm::dvec3(inBoth))}, 3.0));
        QCOMPARE(session().document().segment(1)->voxels, voxels);
        QTRY_VERIFY_WITH_TIMEOUT(shows(inBoth, first), patience);
        QVERIFY(session().undo());
        QTRY_VERIFY_WITH_TIMEOUT(shows(inBoth, both), patience);
        edit(test::eraseAt(1, {geometry.toWorld(glm::dvec3(inBoth))}, 3.0));
        QTRY_VERIFY_WITH_TIMEOUT(shows(inBoth, second), patience);
        // Before the mask, all is as it was.
        QVERIFY(session().goTo(0));
        QVERIFY(session().settle());
        QTRY_VERIFY_WITH_TIMEOUT(shows(inBoth, grey), patience);
    }
};

BURIN_WINDOW_TEST(OverlapsShownUiTest)

} // namespace overlapsShownUiTest

#include "OverlapsShownUiTest.moc"
