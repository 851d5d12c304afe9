// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/radiation/SparseRadiation.h"
#include "core/sculpt/radiation/Radiation.h"
#include "tests/reference/fields/SparseRadiation.h"
#include "tests/support/program/LongRun.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace sparseRadiationTest {

using namespace core::radiation;
using reference::SparsePoint;

namespace {

constexpr double quantum = 1.0 / 255.0; // of the byte that is drawn

double uniform(test::Random& random, double low, double high)
{
    return low + (high - low) * double(random() % 65536u) / 65536.0;
}

/// Seed A's sum, in doubles, with the footprint's box as its end.
double sumOfGaussians(
    const std::vector<glm::dvec3>& points, const glm::dvec3& radii, const glm::ivec3& voxel)
{
    double sum = 0.0;
    for (const glm::dvec3& point : points) {
        const glm::dvec3 away = glm::dvec3(voxel) - point;
        if (glm::any(glm::greaterThan(glm::abs(away), radii)))
            continue;
        const glm::dvec3 sigmas = away / (radii / 2.5);
        sum += std::exp(-0.5 * glm::dot(sigmas, sigmas));
    }
    return sum;
}

std::vector<SparsePoint> radiating(const std::vector<glm::dvec3>& points, const glm::dvec3& radii)
{
    std::vector<SparsePoint> result;
    for (const glm::dvec3& point : points)
        result.push_back({sparseFootprint(point, radii), 1});
    return result;
}

template <class Visit> void forEachVoxel(const glm::ivec3& size, Visit visit)
{
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                visit(glm::ivec3(x, y, z));
}

} // namespace

class SparseRadiationTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void isTheSumOfGaussians();
    void ofAFullBlockToo();
    void oneSeedReachesOne();
    void followsTheSpacing();
    void anyOrderGivesTheSame();
    void anEmptySumIsNothing();
};

void SparseRadiationTest::isTheSumOfGaussians()
{
    const int count = test::longRun() ? 200 : 20;
    double worst = 0.0;
    for (int seed = 0; seed < count; ++seed) {
        test::Random random{std::uint32_t(seed)};
        const glm::ivec3 size(20, 18, 16);
        const glm::dvec3 radii = sparseRadii(test::randomInt(random, 1, 8),
            {uniform(random, 0.3, 2.0), uniform(random, 0.3, 2.0), uniform(random, 0.3, 5.0)});
        std::vector<glm::dvec3> points;
        for (int i = test::randomInt(random, 1, 60); i > 0; --i) {
            // Anywhere, also beside the box and between voxels: on the grid of 1/256.
            glm::dvec3 at;
            for (int axis = 0; axis < 3; ++axis)
                at[axis] = test::randomInt(random, -1280, (size[axis] + 5) * 256) / 256.0;
            points.push_back(at);
        }
        const auto field =
            reference::sparseRadiation(radiating(points, radii), glm::ivec3(0), size);
        forEachVoxel(size, [&](const glm::ivec3& voxel) {
            const double truth = sumOfGaussians(points, radii, voxel);
            const double sum = field.sums.at(voxel) / double(1u << sparseSumBits);
            worst = std::max(worst, std::abs(sum - truth));
            const double byte = 255.0 * std::min(truth, 1.0);
            QVERIFY(std::abs(sparseByte(field.sums.at(voxel)) - byte) <= 0.5 + 0.01);
        });
    }
    QVERIFY2(worst < quantum, qPrintable(QString::number(worst)));
}

void SparseRadiationTest::ofAFullBlockToo()
{
    // As many points as there can be in voxels of their own, the greatest radius: before the clamp
    // the sum is some five hundred.
    const glm::ivec3 size(17, 17, 17);
    std::vector<glm::dvec3> points;
    forEachVoxel(size, [&](const glm::ivec3& voxel) { points.emplace_back(voxel); });
    const glm::dvec3 radii(greatestSparseRadius);
    const auto field =
        reference::sparseRadiation(radiating(points, radii), glm::ivec3(8), glm::ivec3(1));
    const double truth = sumOfGaussians(points, radii, glm::ivec3(8));
    QVERIFY(truth > 450.0 && truth < 520.0);
    const double sum = field.sums.at(glm::ivec3(0)) / double(1u << sparseSumBits);
    QVERIFY2(std::abs(sum - truth) < quantum, qPrintable(QString::number(sum - truth)));
    QCOMPARE(int(sparseByte(field.sums.at(glm::ivec3(0)))), 255);
}

void SparseRadiationTest::oneSeedReachesOne()
{
    for (int voxels = smallestSparseRadius; voxels <= greatestSparseRadius; ++voxels) {
        const SparseFootprint footprint =
            sparseFootprint({5.0, 6.0, 7.0}, sparseRadii(voxels, {0.7, 0.7, 3.0}));
        QCOMPARE(int(sparseByte(sparseContribution(footprint, {5, 6, 7}))), 255);
        QCOMPARE(footprint.count.x, 2 * voxels + 1);
        QVERIFY(footprint.count.z >= 3);
    }
}

void SparseRadiationTest::followsTheSpacing()
{
    // Equal distances in millimetres weigh alike: 4 voxels of 0.5 mm, 2 of 1 mm, 1 of 2 mm.
    const glm::dvec3 spacing(0.5, 1.0, 2.0);
    const SparseFootprint footprint = sparseFootprint(glm::dvec3(10.0), sparseRadii(8, spacing));
    const std::uint32_t alongX = sparseContribution(footprint, {14, 10, 10});
    QVERIFY(alongX > 0);
    QCOMPARE(sparseContribution(footprint, {10, 12, 10}), alongX);
    QCOMPARE(sparseContribution(footprint, {10, 10, 11}), alongX);
    QCOMPARE(footprint.count, glm::ivec3(17, 9, 5));
}

void SparseRadiationTest::anyOrderGivesTheSame()
{
    test::Random random(4);
    const glm::ivec3 size(12, 12, 12);
    std::vector<SparsePoint> points;
    for (int i = 0; i < 40; ++i)
        points.push_back({sparseFootprint({uniform(random, 0, 12), uniform(random, 0, 12),
                                              uniform(random, 0, 12)},
                              sparseRadii(3, {1, 1, 1})),
            std::uint8_t(test::randomInt(random, 1, 4))});
    const auto field = reference::sparseRadiation(points, glm::ivec3(0), size);
    for (int turn = 0; turn < 5; ++turn) {
        std::shuffle(points.begin(), points.end(), random);
        const auto again = reference::sparseRadiation(points, glm::ivec3(0), size);
        QCOMPARE(again.sums.values, field.sums.values);
        QCOMPARE(again.labels.values, field.labels.values);
    }
}

void SparseRadiationTest::anEmptySumIsNothing()
{
    const auto field = reference::sparseRadiation({}, glm::ivec3(0), glm::ivec3(3));
    for (const std::uint32_t sum : field.sums.values)
        QCOMPARE(int(sparseByte(sum)), 0);
    QCOMPARE(int(sparseByte(1u << (sparseSumBits - 1))), 128);
    QCOMPARE(int(sparseByte(0xFFFFFFFFu)), 255);
}

BURIN_TEST(SparseRadiationTest)

} // namespace sparseRadiationTest

#include "SparseRadiationTest.moc"
