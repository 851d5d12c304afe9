// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/OutlineRaster.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

namespace outlineRasterTest {

using namespace core;
using test::Random;

namespace {

constexpr int unit = outlineSubdivision;

/// Twice the signed area of a polygon cut to one element, in subdivisions: clipped side by side.
double areaIn(const std::vector<OutlineVertex>& polygon, const glm::ivec2& element)
{
    std::vector<glm::dvec2> points(polygon.begin(), polygon.end());
    const glm::dvec2 low = glm::dvec2(element) * double(unit);
    const glm::dvec2 high = low + double(unit);
    for (int side = 0; side < 4; ++side) {
        const int axis = side / 2;
        const double border = side % 2 ? high[axis] : low[axis];
        const double sign = side % 2 ? -1.0 : 1.0;
        const auto depth = [&](const glm::dvec2& p) { return sign * (p[axis] - border); };
        std::vector<glm::dvec2> kept;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const glm::dvec2 a = points[i];
            const glm::dvec2 b = points[(i + 1) % points.size()];
            if (depth(a) >= 0.0)
                kept.push_back(a);
            if (depth(a) * depth(b) < 0.0)
                kept.push_back(a + (b - a) * (depth(a) / (depth(a) - depth(b))));
        }
        points = kept;
    }
    double twice = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec2 a = points[i];
        const glm::dvec2 b = points[(i + 1) % points.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return twice / (2.0 * unit * unit);
}

std::vector<OutlineVertex> rotatedByAQuarter(const std::vector<OutlineVertex>& polygon)
{
    std::vector<OutlineVertex> result;
    for (const OutlineVertex& vertex : polygon)
        result.emplace_back(-vertex.y, vertex.x);
    return result;
}

std::vector<OutlineVertex> lasso(int points, const glm::dvec2& radius, double wobble)
{
    std::vector<OutlineVertex> polygon;
    for (int i = 0; i < points; ++i) {
        const double t = 2.0 * M_PI * i / points;
        const double r = 1.0 - wobble * (0.5 + 0.5 * std::sin(23.0 * t));
        polygon.emplace_back(glm::ivec2(
            glm::round(radius * r * glm::dvec2(std::cos(t), std::sin(t)) * double(unit))));
    }
    return polygon;
}

int floorOf(int value, int divisor)
{
    return value >= 0 ? value / divisor : -((-value + divisor - 1) / divisor);
}

/// filledExactly() with a sum for every element.
OutlineRaster filledPlainly(const std::vector<OutlineVertex>& vertices)
{
    constexpr std::int64_t wholeElement = 2 * unit * unit;
    glm::ivec2 low = vertices.front();
    glm::ivec2 high = low;
    for (const OutlineVertex& vertex : vertices) {
        low = glm::min(low, vertex);
        high = glm::max(high, vertex);
    }
    OutlineRaster mask;
    mask.first = {floorOf(low.x, unit), floorOf(low.y, unit)};
    mask.size = glm::ivec2(floorOf(high.x, unit), floorOf(high.y, unit)) + 1 - mask.first;
    const int width = mask.size.x + 1;
    std::vector<std::int64_t> sums(std::size_t(width) * std::size_t(mask.size.y), 0);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        glm::ivec2 from = vertices[i] - mask.first * unit;
        glm::ivec2 to = vertices[(i + 1) % vertices.size()] - mask.first * unit;
        const int direction = from.y < to.y ? 1 : -1;
        if (direction < 0)
            std::swap(from, to);
        int x = from.x;
        for (int y = from.y; y < to.y;) {
            const int row = y / unit;
            const int nextY = std::min((row + 1) * unit, to.y);
            const int nextX = nextY == to.y
                ? to.x
                : from.x + int(std::int64_t(to.x - from.x) * (nextY - from.y) / (to.y - from.y));
            const int left = std::min(x, nextX);
            const int right = std::max(x, nextX);
            const int height = (nextY - y) * direction;
            int done = 0;
            for (int at = left;;) {
                const int element = at / unit;
                const int next = std::min((element + 1) * unit, right);
                const int upTo = next == right
                    ? height
                    : int(std::int64_t(height) * (next - left) / (right - left));
                const int twiceMiddle = at + next - 2 * element * unit;
                std::int64_t* const sum = &sums[std::size_t(width * row + element)];
                sum[0] += std::int64_t(upTo - done) * (2 * unit - twiceMiddle);
                sum[1] += std::int64_t(upTo - done) * twiceMiddle;
                done = upTo;
                at = next;
                if (at == right)
                    break;
            }
            x = nextX;
            y = nextY;
        }
    }
    for (int b = 0; b < mask.size.y; ++b) {
        std::int64_t winding = 0;
        for (int a = 0; a < mask.size.x; ++a) {
            winding += sums[std::size_t(width * b + a)];
            const std::int64_t covered = std::min(std::abs(winding), wholeElement);
            mask.values.push_back(
                std::uint16_t((covered + wholeElement / 512) / (wholeElement / 256)));
        }
    }
    return mask;
}

} // namespace

class OutlineRasterTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void fillsExactly()
    {
        // Stars around a middle do not cross themselves: the area of every element is known.
        Random random(1);
        for (int round = 0; round < (qEnvironmentVariableIsSet("BURIN_LONG") ? 300 : 30); ++round) {
            std::vector<OutlineVertex> star;
            const int corners = test::randomInt(random, 3, 40);
            const glm::dvec2 middle{
                test::randomInt(random, -9000, 9000), test::randomInt(random, -9000, 9000)};
            for (int i = 0; i < corners; ++i) {
                const double t = 2.0 * M_PI * i / corners;
                const double r = 500.0 + 9000.0 * test::randomUnit(random);
                star.emplace_back(
                    glm::ivec2(glm::round(middle + r * glm::dvec2(std::cos(t), std::sin(t)))));
            }
            if (round % 2)
                std::reverse(star.begin(), star.end());
            const OutlineRaster mask = filledExactly(star);
            double whole = 0.0;
            for (int b = mask.first.y - 1; b <= mask.first.y + mask.size.y; ++b) {
                for (int a = mask.first.x - 1; a <= mask.first.x + mask.size.x; ++a) {
                    const double area = std::abs(areaIn(star, {a, b}));
                    whole += area;
                    // Half a value of rounding, and where edges meet rows and columns.
                    QVERIFY2(std::abs(mask.at({a, b}) - 256.0 * area) < 1.6,
                        qPrintable(QStringLiteral("%1 %2: %3 instead of %4")
                                       .arg(a)
                                       .arg(b)
                                       .arg(mask.at({a, b}))
                                       .arg(256.0 * area)));
                }
            }
            QVERIFY(std::abs(double(mask.area()) / 256.0 - whole) < 0.002 * whole + 0.2);
        }
    }

    /// To the bit, for any curve: the sums that are left out were all 0.
    void leavesNothingOut()
    {
        Random random(7);
        const int rounds = qEnvironmentVariableIsSet("BURIN_LONG") ? 2000 : 150;
        for (int round = 0; round < rounds; ++round) {
            const int reach = test::randomInt(random, 1, round % 8 ? 60 : 700) * unit;
            std::vector<OutlineVertex> curve;
            for (int i = test::randomInt(random, 3, 60); i > 0; --i) {
                OutlineVertex at(
                    test::randomInt(random, -reach, reach), test::randomInt(random, -reach, reach));
                if (random() % 4 == 0) // on the border of an element
                    at -= at % unit;
                if (random() % 5 == 0 && !curve.empty())
                    at[int(random() % 2)] = curve.back()[0];
                curve.push_back(at);
            }
            const OutlineRaster expected = filledPlainly(curve);
            const OutlineRaster mask = filledExactly(curve);
            QCOMPARE(mask.first, expected.first);
            QCOMPARE(mask.size, expected.size);
            QVERIFY(mask.values == expected.values);
        }
    }

    void windsNonZero()
    {
        // A pentagram: its middle is wound about twice, and is inside.
        std::vector<OutlineVertex> star;
        for (int i = 0; i < 5; ++i) {
            const double t = 4.0 * M_PI * i / 5.0;
            star.emplace_back(
                glm::ivec2(glm::round(20.0 * unit * glm::dvec2(std::cos(t), std::sin(t)))));
        }
        QCOMPARE(filledExactly(star).at({0, 0}), 256);
        QCOMPARE(filledExactly(star).at({16, 0}), 256);
        QCOMPARE(filledExactly(star).at({11, 8}), 0);
        // An eight, whose halves wind against each other.
        const std::vector<OutlineVertex> eight{
            {0, 0}, {10 * unit, 10 * unit}, {10 * unit, 0}, {0, 10 * unit}};
        const OutlineRaster mask = filledExactly(eight);
        QCOMPARE(mask.at({9, 5}), 256);
        QCOMPARE(mask.at({0, 5}), 256);
        QCOMPARE(mask.at({5, 0}), 0);
        // Wound about over and over it is not more than inside, nor does any sum run over.
        std::vector<OutlineVertex> wound;
        for (int i = 0; i < 200000; ++i)
            wound.insert(wound.end(), {{0, 0}, {4 * unit, 0}, {4 * unit, 4 * unit}});
        QCOMPARE(filledExactly(wound).at({3, 1}), 256);
        QCOMPARE(filledExactly(wound).at({1, 3}), 0);
    }

    void knowsNoSide()
    {
        const std::vector<OutlineVertex> polygon = lasso(300, {21.3, 11.7}, 0.6);
        const OutlineRaster mask = smoothed(filledExactly(polygon));
        const OutlineRaster turned = smoothed(filledExactly(rotatedByAQuarter(polygon)));
        for (int b = -25; b < 25; ++b) {
            for (int a = -25; a < 25; ++a)
                QVERIFY(std::abs(mask.at({a, b}) - turned.at({-b - 1, a})) <= 1);
        }
        std::vector<OutlineVertex> backwards(polygon.rbegin(), polygon.rend());
        QCOMPARE(filledExactly(backwards).values, filledExactly(polygon).values);
        // In a frame of its own wherever it lies.
        std::vector<OutlineVertex> moved = polygon;
        for (OutlineVertex& vertex : moved)
            vertex += glm::ivec2(-1000 * unit, 77 * unit);
        QCOMPARE(filledExactly(moved).values, filledExactly(polygon).values);
        QCOMPARE(filledExactly(moved).first, filledExactly(polygon).first + glm::ivec2(-1000, 77));
    }

    void straightEdgesStayWhereTheyAre()
    {
        // The B-spline keeps the level 0.5 of an edge: the sum across it is the same as before, and
        // an edge through the middle of an element leaves one half there.
        for (int offset = 0; offset < unit; offset += 64) {
            const std::vector<OutlineVertex> box{{offset, 0}, {20 * unit + offset, 0},
                {20 * unit + offset, 20 * unit}, {offset, 20 * unit}};
            const OutlineRaster sharp = filledExactly(box);
            const OutlineRaster soft = smoothed(sharp);
            int before = 0;
            int after = 0;
            for (int a = -3; a < 10; ++a) {
                before += sharp.at({a, 10});
                after += soft.at({a, 10});
            }
            QVERIFY(std::abs(before - after) <= 2);
            if (offset == unit / 2)
                QVERIFY(std::abs(soft.at({0, 10}) - 128) <= 1);
            for (int a = 5; a < 15; ++a)
                QCOMPARE(soft.at({a, 10}), 256);
            for (int a = -3; a < 3; ++a)
                QVERIFY(soft.at({a, 10}) <= soft.at({a + 1, 10}));
        }
    }

    /// Against the nearest of all elements that are not covered, one by one.
    void softEdgesFollowTheDistance()
    {
        Random random(7);
        for (int round = 0; round < (qEnvironmentVariableIsSet("BURIN_LONG") ? 300 : 30); ++round) {
            OutlineRaster mask = smoothed(filledExactly(lasso(test::randomInt(random, 3, 40),
                {test::randomInt(random, 1, 25) + 0.3, test::randomInt(random, 1, 25) + 0.6},
                0.5)));
            if (round % 5 == 0) { // anything at all, also up to the border
                for (std::uint16_t& value : mask.values)
                    value = std::uint16_t(test::randomInt(random, 0, 3) ? 256 : 0);
            }
            const int width = test::randomInt(random, 1, 12 * 256);
            const auto depth = [&mask](int a, int b) {
                std::int64_t nearest = 1 << 20;
                for (int y = -1; y <= mask.size.y; ++y) {
                    for (int x = -1; x <= mask.size.x; ++x) {
                        if (mask.at(mask.first + glm::ivec2(x, y)) < 128)
                            nearest = std::min<std::int64_t>(
                                nearest, (x - a) * (x - a) + (y - b) * (y - b));
                    }
                }
                return std::floor(std::sqrt(double(nearest)) * 256.0) - 128.0;
            };
            double deepest = 0.0;
            for (int b = 0; b < mask.size.y; ++b) {
                for (int a = 0; a < mask.size.x; ++a)
                    deepest = std::max(deepest, depth(a, b));
            }
            const OutlineRaster soft = softened(mask, width);
            QCOMPARE(soft.size, mask.size);
            int full = 0;
            for (int b = 0; b < mask.size.y; ++b) {
                for (int a = 0; a < mask.size.x; ++a) {
                    const int drawn = mask.at(mask.first + glm::ivec2(a, b));
                    const double most = std::floor(std::max(depth(a, b), 0.0) * 256.0
                        / std::max(std::min(double(width), deepest), 1.0));
                    const int expected = deepest > 0.0 ? int(std::min<double>(drawn, most)) : drawn;
                    QCOMPARE(soft.at(soft.first + glm::ivec2(a, b)), expected);
                    full += expected == drawn && drawn > 0 ? 1 : 0;
                }
            }
            QVERIFY(full > 0 || mask.area() == 0);
        }
        const OutlineRaster mask = smoothed(filledExactly(lasso(30, {20.0, 20.0}, 0.0)));
        QVERIFY(softened(mask, 0).values == mask.values);
    }

    void whatHasNoAreaIsEmpty()
    {
        QVERIFY(filledExactly({}).empty());
        QVERIFY(filledExactly({{0, 0}, {5 * unit, 5 * unit}}).empty());
        QCOMPARE(filledExactly({{0, 0}, {5 * unit, 5 * unit}, {2 * unit, 2 * unit}}).area(),
            std::int64_t(0));
        QVERIFY(smoothed({}).empty());
    }

    void largeLassos()
    {
        const std::vector<OutlineVertex> polygon = lasso(2000, {614.9, 434.9}, 0.3);
        OutlineRaster mask;
        QBENCHMARK
        {
            mask = smoothed(filledExactly(polygon));
        }
        QVERIFY(mask.size.x > 1200 && mask.size.y > 850);
        QCOMPARE(mask.at({0, 0}), 256);
    }
};

BURIN_PLAIN_TEST(OutlineRasterTest)

} // namespace outlineRasterTest

#include "OutlineRasterTest.moc"
