// SPDX-License-Identifier: Apache-2.0
#include "ui/report/ChangePicture.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <array>
#include <set>

namespace changePictureTest {

using namespace core;

namespace {

constexpr glm::ivec3 size(12, 9, 5);

std::uint64_t at(int x, int y, int z)
{
    return std::uint64_t((z * size.y + y) * size.x + x);
}

/// A volume without contrast, whose index axes run as told: each names a world axis, LPS.
Volume volumeOf(const std::array<glm::dvec3, 3>& axes)
{
    Volume volume;
    volume.geometry.size = size;
    for (int axis = 0; axis < 3; ++axis)
        volume.geometry.indexToWorld[axis] = glm::dvec4(axes[std::size_t(axis)], 0.0);
    volume.defaultWindow = {.centre = 0.0, .width = 2.0};
    return volume;
}

VoxelRuns runsOf(const std::set<std::uint64_t>& voxels)
{
    VoxelRuns runs;
    for (const std::uint64_t voxel : voxels)
        runs.append(voxel, 1);
    return runs;
}

/// The middle of the pixels for which something holds, between 0 and 1 on each axis.
template <typename Holds> QPointF middleOf(const QImage& image, Holds holds)
{
    double count = 0.0;
    QPointF sum;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            if (holds(image.pixelColor(x, y))) {
                sum += QPointF((x + 0.5) / image.width(), (y + 0.5) / image.height());
                count += 1.0;
            }
        }
    }
    return count > 0.0 ? sum / count : QPointF(-1.0, -1.0);
}

bool isGreen(const QColor& colour)
{
    return colour.green() > colour.red() + 40 && colour.green() > colour.blue() + 20;
}

bool isRed(const QColor& colour)
{
    return colour.red() > colour.green() + 40;
}

} // namespace

class ChangePictureTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void equalMasksHaveNone()
    {
        const Volume volume = volumeOf({glm::dvec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}});
        const std::vector<std::uint16_t> codes(volume.geometry.voxelCount(), 1);
        const VoxelRuns mask = runsOf({at(3, 4, 2), at(4, 4, 2)});
        QVERIFY(!ui::changePicture(volume, codes, mask, mask));
    }

    /// The slice with most changes, not that with most voxels, and the first of equal ones.
    void theSliceWithTheMostChanges()
    {
        const Volume volume = volumeOf({glm::dvec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}});
        const std::vector<std::uint16_t> codes(volume.geometry.voxelCount(), 1);
        std::set<std::uint64_t> before;
        for (int x = 0; x < size.x; ++x)
            before.insert(at(x, 4, 0));
        std::set<std::uint64_t> now = before;
        now.insert({at(1, 1, 1), at(2, 1, 3), at(3, 1, 3), at(2, 1, 4), at(3, 1, 4)});
        QCOMPARE(ui::changePicture(volume, codes, runsOf(now), runsOf(before))->slice, 3);
        QCOMPARE(ui::changePicture(volume, codes, runsOf(before), runsOf(now))->slice, 3);
    }

    /// Runs that go on over the end of a slice count in each.
    void aRunOverSlices()
    {
        const Volume volume = volumeOf({glm::dvec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}});
        const std::vector<std::uint16_t> codes(volume.geometry.voxelCount(), 1);
        VoxelRuns now;
        now.append(at(size.x - 2, size.y - 1, 1), std::uint64_t(size.x * size.y) + 3);
        QCOMPARE(ui::changePicture(volume, codes, now, VoxelRuns())->slice, 2);
    }

    /// The patient's right is on the left of an axial slice and the front above, and so on, however
    /// the voxels are stored.
    void itIsTurnedAsViewsAre_data()
    {
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("second");
        QTest::addColumn<int>("third");
        QTest::addColumn<int>("signs");
        constexpr std::array<std::array<int, 3>, 6> orders{
            {{0, 1, 2}, {1, 0, 2}, {0, 2, 1}, {2, 0, 1}, {1, 2, 0}, {2, 1, 0}}};
        for (const auto& order : orders) {
            for (int signs = 0; signs < 8; ++signs)
                QTest::addRow("%d%d%d %d", order[0], order[1], order[2], signs)
                    << order[0] << order[1] << order[2] << signs;
        }
    }
    void itIsTurnedAsViewsAre()
    {
        QFETCH(int, first);
        QFETCH(int, second);
        QFETCH(int, third);
        QFETCH(int, signs);
        std::array<glm::dvec3, 3> axes{glm::dvec3(0.0), glm::dvec3(0.0), glm::dvec3(0.0)};
        const std::array<int, 3> order{first, second, third};
        for (std::size_t axis = 0; axis < 3; ++axis)
            axes[axis][order[axis]] = signs >> axis & 1 ? -1.5 : 1.5;
        const Volume volume = volumeOf(axes);
        const std::vector<std::uint16_t> codes(volume.geometry.voxelCount(), 1);
        // One voxel was added near one corner of the slice, another taken near the opposite one.
        const glm::ivec3 added(1, 1, 2);
        const glm::ivec3 taken(10, 7, 2);
        const auto picture = ui::changePicture(volume, codes,
            runsOf({at(added.x, added.y, added.z)}), runsOf({at(taken.x, taken.y, taken.z)}));
        QVERIFY(picture);
        const QPointF green = middleOf(picture->image, isGreen);
        const QPointF red = middleOf(picture->image, isRed);
        QVERIFY(green.x() >= 0.0 && red.x() >= 0.0);
        // To the right: the patient's left, of a sagittal slice the back. Down: the back, else the
        // feet.
        const glm::dvec3 way =
            volume.geometry.toWorld(glm::dvec3(taken)) - volume.geometry.toWorld(glm::dvec3(added));
        const double right = third == 0 ? way.y : way.x;
        const double down = third == 2 ? way.y : -way.z;
        QCOMPARE(red.x() > green.x(), right > 0.0);
        QCOMPARE(red.y() > green.y(), down > 0.0);
        // The whole slice is shown, with true lengths.
        const double wide = std::abs(right) > 9.0 ? 12.0 : 9.0;
        const double tall = std::abs(down) > 9.0 ? 12.0 : 9.0;
        QVERIFY(std::abs(double(picture->image.width()) / picture->image.height() - wide / tall)
            < 0.01);
    }
};

BURIN_TEST(ChangePictureTest)

} // namespace changePictureTest

#include "ChangePictureTest.moc"
