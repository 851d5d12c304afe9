// SPDX-License-Identifier: Apache-2.0
#include "core/morphology/GaussianShape.h"
#include "core/morphology/GridGaussian.h"
#include "core/morphology/MillimetreBall.h"
#include "core/morphology/SegmentShape.h"
#include "core/volume/VolumeGeometry.h"
#include "tests/peers/ItkDistances.h"
#include "tests/peers/ItkGaussian.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace segmentShapeItkTest {

namespace {

using core::ShapeOperation;
using Labels = std::vector<std::uint8_t>;

core::VolumeGeometry uprightGrid(const glm::ivec3& size, const glm::dvec3& spacing)
{
    core::VolumeGeometry geometry;
    geometry.size = size;
    geometry.indexToWorld = glm::dmat4(glm::dmat3(glm::dvec3(spacing.x, 0.0, 0.0),
        glm::dvec3(0.0, spacing.y, 0.0), glm::dvec3(0.0, 0.0, spacing.z)));
    return geometry;
}

/// Balls and specks, beside nothing else.
Labels randomBalls(const glm::ivec3& size, std::mt19937& random)
{
    Labels labels(std::size_t(size.x * size.y * size.z), 0);
    std::array<glm::ivec4, 4> balls{};
    for (glm::ivec4& ball : balls)
        ball = glm::ivec4{
            int(random() % 44), int(random() % 40), int(random() % 30), 3 + int(random() % 8)};
    std::size_t voxel = 0;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x, ++voxel) {
                for (const glm::ivec4& ball : balls) {
                    const glm::ivec3 from = glm::ivec3(x, y, z) - glm::ivec3(ball);
                    if (from.x * from.x + from.y * from.y + from.z * from.z <= ball.w * ball.w)
                        labels[voxel] = 1;
                }
                if (random() % 200 == 0)
                    labels[voxel] = labels[voxel] == 1 ? 0 : 1;
            }
        }
    }
    return labels;
}

} // namespace

/// Margins are those of ITK's exact distance map, voxel for voxel: on spacings of whole
/// millimetres squared distances are whole numbers, which its floats hold, too. A smoothing by a
/// Gaussian is ITK's but for voxels that are nearly half of either side.
class SegmentShapeItkTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void margins_data()
    {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("z");
        QTest::newRow("1 1 1") << 1.0 << 1.0 << 1.0;
        QTest::newRow("1 2 3") << 1.0 << 2.0 << 3.0;
        QTest::newRow("2 1 8") << 2.0 << 1.0 << 8.0;
    }
    void margins()
    {
        QFETCH(const double, x);
        QFETCH(const double, y);
        QFETCH(const double, z);
        const glm::ivec3 size(44, 40, 30);
        const core::VolumeGeometry geometry = uprightGrid(size, {x, y, z});
        std::mt19937 random(std::uint32_t(x + 10.0 * y + 100.0 * z));
        for (int round = 0; round < 3; ++round) {
            const Labels labels = randomBalls(size, random);
            Labels rest = labels;
            for (std::uint8_t& voxel : rest)
                voxel = voxel == 0 ? 1 : 0;
            const peer::ItkDistances toOwn = peer::itkDistances(size, {x, y, z}, labels);
            const peer::ItkDistances toRest = peer::itkDistances(size, {x, y, z}, rest);
            // 3 and 5 are distances that voxels have; the others lie between.
            for (const double mm : {1.0, 2.3, 3.0, 5.0, 9.7}) {
                for (const ShapeOperation operation :
                    {ShapeOperation::Grow, ShapeOperation::Shrink}) {
                    const bool grows = operation == ShapeOperation::Grow;
                    const auto change = core::shapeChange(labels, size, 1, operation,
                        core::ShellPlace::Inside, core::ballOf(geometry, mm), core::Progress());
                    QVERIFY(change);
                    core::VoxelRuns expected;
                    const std::vector<float>& squared = grows ? toOwn.squared : toRest.squared;
                    for (std::size_t voxel = 0; voxel < labels.size(); ++voxel) {
                        if (labels[voxel] == (grows ? 0 : 1) && double(squared[voxel]) <= mm * mm)
                            expected.append(voxel, 1);
                    }
                    QVERIFY(!expected.empty());
                    QVERIFY((grows ? change->given : change->taken) == expected);
                    QVERIFY((grows ? change->taken : change->given).empty());
                }
            }
        }
    }

    void gaussian_data()
    {
        QTest::addColumn<double>("z");
        QTest::addColumn<double>("sigma");
        QTest::newRow("cubes") << 1.0 << 2.0;
        QTest::newRow("thick slices") << 2.5 << 3.0;
        QTest::newRow("wide") << 1.5 << 5.0;
    }
    /// The kernels differ: ITK's is Lindeberg's discrete one, which is another than samples of a
    /// Gaussian where that has few voxels, and does not end after three standard deviations. So
    /// where it finds one half to a fiftieth, either side is right.
    void gaussian()
    {
        QFETCH(const double, z);
        QFETCH(const double, sigma);
        const glm::ivec3 size(44, 40, 30);
        const core::VolumeGeometry geometry = uprightGrid(size, {1.0, 1.0, z});
        std::mt19937 random(11);
        for (int round = 0; round < 3; ++round) {
            const Labels labels = randomBalls(size, random);
            const peer::ItkGaussian theirs = peer::itkGaussian(size, {1.0, 1.0, z}, labels, sigma);
            const auto change = core::gaussianChange(
                labels, size, 1, core::gaussianOf(geometry, sigma), core::Progress());
            QVERIFY(change);
            Labels ours = labels;
            for (const core::VoxelRun& run : change->given.runs())
                std::fill_n(ours.begin() + std::ptrdiff_t(run.first), run.count, std::uint8_t(1));
            for (const core::VoxelRun& run : change->taken.runs())
                std::fill_n(ours.begin() + std::ptrdiff_t(run.first), run.count, std::uint8_t(0));
            QVERIFY(ours != labels);
            int doubtful = 0;
            for (std::size_t voxel = 0; voxel < labels.size(); ++voxel) {
                const double value = double(theirs.values[voxel]);
                if (std::abs(value - 0.5) < 0.02)
                    ++doubtful;
                else
                    QCOMPARE(int(ours[voxel]), value > 0.5 ? 1 : 0);
            }
            QVERIFY2(doubtful < int(labels.size()) / 50, qPrintable(QString::number(doubtful)));
        }
    }
};

BURIN_TEST(SegmentShapeItkTest)

} // namespace segmentShapeItkTest

#include "SegmentShapeItkTest.moc"
