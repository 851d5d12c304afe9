// SPDX-License-Identifier: Apache-2.0
#include "core/outline/SegmentAxes.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <cmath>

namespace segmentAxesTest {

using namespace core;

namespace {

/// Pixels of 0.5 × 0.8 mm in a plane that is turned about z; sheared if asked.
SliceLattice latticeOf(const glm::ivec2& size, double shear = 0.0)
{
    SliceLattice lattice;
    lattice.size = size;
    const glm::dvec3 right = glm::normalize(glm::dvec3(3, 1, 0));
    const glm::dvec3 down = glm::normalize(glm::dvec3(-1, 3, 0));
    lattice.originLps = {7, -3, 11};
    lattice.columnLps = 0.5 * right;
    lattice.rowLps = 0.8 * down + shear * right;
    return lattice;
}

glm::dvec3 placeOf(const SliceLattice& lattice, double x, double y)
{
    return lattice.originLps + x * lattice.columnLps + y * lattice.rowLps;
}

template <class Inside>
std::vector<std::uint8_t> pixelsOf(const SliceLattice& lattice, const Inside& isInside)
{
    std::vector<std::uint8_t> inside;
    for (int y = 0; y < lattice.size.y; ++y) {
        for (int x = 0; x < lattice.size.x; ++x)
            inside.push_back(isInside(x, y) ? 1 : 0);
    }
    return inside;
}

double longOf(const SegmentAxes& axes)
{
    return glm::distance(axes.longFromLps, axes.longToLps);
}

double shortOf(const SegmentAxes& axes)
{
    return glm::distance(axes.shortFromLps, axes.shortToLps);
}

double betweenThem(const SegmentAxes& axes)
{
    return std::abs(
               glm::dot(axes.longToLps - axes.longFromLps, axes.shortToLps - axes.shortFromLps))
        / (longOf(axes) * shortOf(axes));
}

} // namespace

class SegmentAxesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// 12 × 1 pixels: from side to side along the row, and across it in the middle of each.
    void aRowOfPixels()
    {
        const SliceLattice lattice = latticeOf({20, 9});
        const auto inside =
            pixelsOf(lattice, [](int x, int y) { return y == 4 && x >= 3 && x <= 14; });
        const auto axes = segmentAxes(lattice, inside, {7, 4});
        QVERIFY(axes);
        QVERIFY(std::abs(longOf(*axes) - 12 * 0.5) < 1e-9);
        QVERIFY(std::abs(shortOf(*axes) - 0.8) < 1e-9);
        QVERIFY(betweenThem(*axes) < 1e-9);
        QVERIFY(glm::distance(axes->longFromLps, placeOf(lattice, 2.5, 4)) < 1e-9
            || glm::distance(axes->longToLps, placeOf(lattice, 2.5, 4)) < 1e-9);
    }

    /// An ellipse of any direction has its axes, to within a pixel.
    void anEllipse_data()
    {
        QTest::addColumn<double>("degrees");
        QTest::addColumn<double>("shear");
        for (const double degrees : {0.0, 20.0, 65.0, 90.0, 130.0}) {
            QTest::addRow("%g", degrees) << degrees << 0.0;
            QTest::addRow("%g, sheared", degrees) << degrees << 0.2;
        }
    }
    void anEllipse()
    {
        QFETCH(const double, degrees);
        QFETCH(const double, shear);
        const SliceLattice lattice = latticeOf({160, 110}, shear);
        const glm::dvec3 middle = placeOf(lattice, 80, 55);
        const glm::dvec3 right = glm::normalize(glm::dvec3(3, 1, 0));
        const glm::dvec3 down = glm::normalize(glm::dvec3(-1, 3, 0));
        const double turn = glm::radians(degrees);
        const glm::dvec3 along = std::cos(turn) * right + std::sin(turn) * down;
        const glm::dvec3 across = -std::sin(turn) * right + std::cos(turn) * down;
        const auto inside = pixelsOf(lattice, [&](int x, int y) {
            const glm::dvec3 way = placeOf(lattice, x, y) - middle;
            const double a = glm::dot(way, along) / 24.0;
            const double b = glm::dot(way, across) / 13.0;
            return a * a + b * b <= 1.0;
        });
        const auto axes = segmentAxes(lattice, inside, {80, 55});
        QVERIFY(axes);
        QVERIFY2(std::abs(longOf(*axes) - 48.0) < 0.9, qPrintable(QString::number(longOf(*axes))));
        QVERIFY2(
            std::abs(shortOf(*axes) - 26.0) < 0.9, qPrintable(QString::number(shortOf(*axes))));
        QVERIFY(betweenThem(*axes) < 1e-9);
        const glm::dvec3 found = glm::normalize(axes->longToLps - axes->longFromLps);
        QVERIFY(std::abs(glm::dot(found, along)) > std::cos(glm::radians(6.0)));
    }

    /// The longest distance of any two places, and of chords across it, by trying all.
    void noOtherIsLonger()
    {
        test::Random random(5);
        for (int round = 0; round < 30; ++round) {
            const SliceLattice lattice = latticeOf({13, 11}, round % 2 == 0 ? 0.0 : 0.3);
            std::vector<std::uint8_t> inside(13 * 11, 0);
            glm::ivec2 at(6, 5);
            for (int step = 0; step < 40; ++step) {
                inside[std::size_t(at.y * 13 + at.x)] = 1;
                at = glm::clamp(
                    at + glm::ivec2(test::randomInt(random, -1, 1), test::randomInt(random, -1, 1)),
                    glm::ivec2(0), glm::ivec2(12, 10));
            }
            const auto axes = segmentAxes(lattice, inside, {6, 5});
            QVERIFY(axes);
            std::vector<glm::dvec3> places;
            for (int y = 0; y < 11; ++y) {
                for (int x = 0; x < 13; ++x) {
                    if (inside[std::size_t(y * 13 + x)] == 0)
                        continue;
                    for (const glm::dvec2& side : {glm::dvec2(0.5, 0), glm::dvec2(-0.5, 0),
                             glm::dvec2(0, 0.5), glm::dvec2(0, -0.5)})
                        places.push_back(placeOf(lattice, x + side.x, y + side.y));
                }
            }
            double longest = 0.0;
            for (const glm::dvec3& a : places) {
                for (const glm::dvec3& b : places)
                    longest = std::max(longest, glm::distance(a, b));
            }
            QVERIFY(std::abs(longOf(*axes) - longest) < 1e-9);
            // Chords of the hull: between any two segments that join places.
            const glm::dvec3 along = glm::normalize(axes->longToLps - axes->longFromLps);
            const glm::dvec3 across = glm::cross(glm::dvec3(0, 0, 1), along);
            double widest = 0.0;
            for (const glm::dvec3& corner : places) {
                const double place = glm::dot(corner, along);
                double low = glm::dot(corner, across);
                double high = low;
                for (const glm::dvec3& a : places) {
                    if (std::abs(glm::dot(a, along) - place) < 1e-9) {
                        low = std::min(low, glm::dot(a, across));
                        high = std::max(high, glm::dot(a, across));
                    }
                    for (const glm::dvec3& b : places) {
                        const double from = glm::dot(a, along) - place;
                        const double to = glm::dot(b, along) - place;
                        if (!(from < 0.0 && to > 0.0))
                            continue;
                        const glm::dvec3 met = a + (b - a) * (from / (from - to));
                        low = std::min(low, glm::dot(met, across));
                        high = std::max(high, glm::dot(met, across));
                    }
                }
                widest = std::max(widest, high - low);
            }
            QVERIFY2(std::abs(shortOf(*axes) - widest) < 1e-6,
                qPrintable(QStringLiteral("%1 %2").arg(shortOf(*axes)).arg(widest)));
        }
    }

    void onlyWhatHangsTogetherCounts()
    {
        const SliceLattice lattice = latticeOf({30, 10});
        // Two blocks; one pixel more touches the first at a corner.
        const auto inside = pixelsOf(lattice, [](int x, int y) {
            return (y == 2 && x >= 1 && x <= 4) || (x == 5 && y == 3) || (y == 2 && x >= 20);
        });
        const auto left = segmentAxes(lattice, inside, {2, 2});
        const auto right = segmentAxes(lattice, inside, {25, 2});
        QVERIFY(left && right);
        QVERIFY(std::abs(longOf(*right) - 5.0) < 1e-9);
        QVERIFY(longOf(*left) > 2.5 && longOf(*left) < 2.8);
        QVERIFY(!segmentAxes(lattice, inside, {10, 2}));
        QVERIFY(!segmentAxes(lattice, inside, {-1, 2}));
        QVERIFY(!segmentAxes(lattice, inside, {30, 2}));
        QVERIFY(!segmentAxes(SliceLattice(), {}, {0, 0}));
    }
};

BURIN_TEST(SegmentAxesTest)

} // namespace segmentAxesTest

#include "SegmentAxesTest.moc"
