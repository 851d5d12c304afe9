// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/splitting/LineAcross.h"

#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <cmath>
#include <random>

namespace lineAcrossTest {

using namespace core;

namespace {

using Line = std::vector<glm::dvec2>;

/// Twice the area of a closed curve, above 0 if it runs counterclockwise.
double twiceArea(const Line& curve)
{
    double area = 0.0;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const glm::dvec2& from = curve[i];
        const glm::dvec2& to = curve[(i + 1) % curve.size()];
        area += from.x * to.y - from.y * to.x;
    }
    return area;
}

bool winds(const Line& curve, const glm::dvec2& place)
{
    double turned = 0.0;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const glm::dvec2 from = curve[i] - place;
        const glm::dvec2 to = curve[(i + 1) % curve.size()] - place;
        turned += std::atan2(from.x * to.y - from.y * to.x, glm::dot(from, to));
    }
    return std::lround(turned / (2.0 * M_PI)) != 0;
}

} // namespace

class LineAcrossTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void goesOnAsItRan()
    {
        const std::optional<LineEnds> straight = lineEnds({{1.0, 2.0}, {4.0, 6.0}});
        QVERIFY(straight);
        QVERIFY(glm::distance(straight->before, {-0.6, -0.8}) < 1e-12);
        QVERIFY(glm::distance(straight->behind, {0.6, 0.8}) < 1e-12);
        // A hook at the end, as a pen makes when it is lifted, hardly counts.
        const std::optional<LineEnds> hooked =
            lineEnds({{0.0, 0.0}, {50.0, 0.0}, {100.0, 0.0}, {100.0, 0.4}});
        QVERIFY(hooked);
        QVERIFY(hooked->behind.x > 0.99);
        QVERIFY(hooked->before.x == -1.0);
    }

    void withoutLengthThereIsNoEnd()
    {
        QVERIFY(!lineEnds({}));
        QVERIFY(!lineEnds({{3.0, 3.0}}));
        QVERIFY(!lineEnds({{3.0, 3.0}, {3.0, 3.0}}));
        QVERIFY(leftOfLine({{3.0, 3.0}, {3.0, 3.0}}, {0.0, 0.0}, {9.0, 9.0}).empty());
    }

    /// From right to left above and below the middle; from bottom to top, and back.
    void leftIsOnTheLeft()
    {
        const glm::dvec2 low(-10.0, -5.0);
        const glm::dvec2 high(10.0, 5.0);
        const Line up = leftOfLine({{2.0, -1.0}, {2.0, 1.0}}, low, high);
        QVERIFY(winds(up, {1.0, 0.0}) && winds(up, {-9.0, 4.9}) && winds(up, {-9.0, -4.9}));
        QVERIFY(!winds(up, {3.0, 0.0}) && !winds(up, {9.0, 4.0}));
        const Line down = leftOfLine({{2.0, 1.0}, {2.0, -1.0}}, low, high);
        QVERIFY(!winds(down, {1.0, 0.0}) && winds(down, {3.0, 0.0}));
        const Line left = leftOfLine({{2.0, 1.0}, {-2.0, 1.0}}, low, high);
        QVERIFY(winds(left, {0.0, 0.0}) && winds(left, {9.0, -4.9}) && !winds(left, {0.0, 2.0}));
        const Line corner = leftOfLine({{9.0, 3.0}, {8.0, 4.0}}, low, high);
        QVERIFY(winds(corner, {-9.0, -4.0}) && !winds(corner, {9.5, 4.5}));
    }

    /// Both ways along a straight line they are the whole rectangle, without overlap.
    void bothSidesAreAll()
    {
        std::mt19937 random(3);
        const glm::dvec2 low(-7.0, -4.0);
        const glm::dvec2 high(6.0, 5.0);
        const auto place = [&](double share) {
            return glm::dvec2(low.x + share * (0.5 + double(random() % 999) / 100.0),
                low.y + share * (0.5 + double(random() % 699) / 100.0));
        };
        for (int i = 0; i < 200; ++i) {
            Line line{place(1.0), place(1.0)};
            if (glm::distance(line[0], line[1]) < 0.05)
                continue;
            const Line one = leftOfLine(line, low, high);
            std::reverse(line.begin(), line.end());
            const Line other = leftOfLine(line, low, high);
            QVERIFY(twiceArea(one) > 0.0 && twiceArea(other) > 0.0);
            QVERIFY(std::abs(twiceArea(one) + twiceArea(other) - 2.0 * 13.0 * 9.0) < 1e-6);
        }
    }
};

BURIN_TEST(LineAcrossTest)

} // namespace lineAcrossTest

#include "LineAcrossTest.moc"
