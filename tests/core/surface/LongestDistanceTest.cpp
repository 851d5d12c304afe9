// SPDX-License-Identifier: Apache-2.0
#include "core/surface/LongestDistance.h"
#include "core/surface/SegmentSurface.h"
#include "tests/support/program/TestProgram.h"

#include <QElapsedTimer>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

namespace longestDistanceTest {

namespace {

/// Every point with every other.
double byBruteForce(const std::vector<glm::dvec3>& points)
{
    double longest = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k)
            longest = std::max(longest, glm::distance(points[i], points[k]));
    }
    return longest;
}

/// Whole numbers, so that many distances are equal, and some points too.
std::vector<glm::dvec3> scattered(std::mt19937& random, std::size_t count, const glm::ivec3& size)
{
    std::vector<glm::dvec3> points;
    for (std::size_t i = 0; i < count; ++i)
        points.emplace_back(int(random() % unsigned(size.x)), int(random() % unsigned(size.y)),
            int(random() % unsigned(size.z)));
    return points;
}

/// The points of a segment's surface: a ball of @p radius in a grid just around it.
std::vector<glm::dvec3> ballSurface(double radius)
{
    const int side = int(std::ceil(2.0 * radius)) + 4;
    const glm::dvec3 middle(side / 2.0 + 0.1, side / 2.0 - 0.3, side / 2.0);
    std::vector<std::uint8_t> labels;
    for (int z = 0; z < side; ++z)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                labels.push_back(glm::distance(glm::dvec3(x, y, z), middle) <= radius ? 1 : 0);
    std::vector<glm::dvec3> points;
    for (const glm::vec3& vertex : core::segmentSurface(labels, 1, glm::ivec3(side)).vertices)
        points.emplace_back(vertex);
    return points;
}

} // namespace

/// The exact longest distance between points, found without comparing all with all.
class LongestDistanceTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void fewPoints();
    void scatteredPoints();
    void pointsOfASphere();
    void surfacesOfBalls();
};

void LongestDistanceTest::fewPoints()
{
    QCOMPARE(core::longestDistance({}).length(), 0.0);
    QCOMPARE(core::longestDistance({{1.0, 2.0, 3.0}}).length(), 0.0);
    QCOMPARE(core::longestDistance({{1.0, 2.0, 3.0}, {1.0, 5.0, 7.0}}).length(), 5.0);
    // More than a leaf holds, all at one place.
    QCOMPARE(core::longestDistance(std::vector<glm::dvec3>(100, {1.0, 2.0, 3.0})).length(), 0.0);
}

/// In boxes, plates and lines of all sizes.
void LongestDistanceTest::scatteredPoints()
{
    std::mt19937 random(35);
    for (int round = 0; round < 300; ++round) {
        const glm::ivec3 size(
            1 + int(random() % 60), 1 + int(random() % 60), 1 + int(random() % 20));
        const std::vector<glm::dvec3> points = scattered(random, 1 + random() % 700, size);
        const double right = byBruteForce(points);
        const double found = core::longestDistance(points).length();
        QVERIFY2(std::abs(found - right) <= 1e-12 * right,
            qPrintable(QStringLiteral("round %1: %2 of %3").arg(round).arg(found).arg(right)));
    }
}

/// All opposite points are nearly equally far apart: little can be passed over. The points are
/// moved away from the origin, as places in a patient are.
void LongestDistanceTest::pointsOfASphere()
{
    std::mt19937 random(1711);
    std::normal_distribution<double> normal;
    for (int round = 0; round < 20; ++round) {
        std::vector<glm::dvec3> points;
        for (int i = 0; i < 1500; ++i)
            points.push_back(glm::dvec3(-250.0, 130.0, 1200.0)
                + 40.0
                    * glm::normalize(glm::dvec3(normal(random), normal(random), normal(random))));
        const double right = byBruteForce(points);
        QVERIFY(std::abs(core::longestDistance(points).length() - right) <= 1e-12 * right);
    }
}

void LongestDistanceTest::surfacesOfBalls()
{
    for (const double radius : {0.8, 3.0, 9.0}) {
        const std::vector<glm::dvec3> points = ballSurface(radius);
        const double right = byBruteForce(points);
        QVERIFY(std::abs(core::longestDistance(points).length() - right) <= 1e-12 * right);
    }
    // A large one is too much for brute force; it may be smaller than the ball by what voxels are.
    const std::vector<glm::dvec3> points = ballSurface(60.0);
    QElapsedTimer clock;
    clock.start();
    const double found = core::longestDistance(points).length();
    qInfo("%zu points of a ball: %.3f mm in %lld ms", points.size(), found, clock.elapsed());
    QVERIFY(found > 118.0 && found < 122.0);
}

BURIN_TEST(LongestDistanceTest)

} // namespace longestDistanceTest

#include "LongestDistanceTest.moc"
