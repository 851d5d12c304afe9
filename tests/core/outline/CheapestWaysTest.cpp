// SPDX-License-Identifier: Apache-2.0
#include "core/outline/CheapestWays.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace cheapestWaysTest {

namespace {

using Costs = std::shared_ptr<const core::SideCosts>;
using Corners = std::vector<glm::ivec2>;

core::SlicePixels randomPicture(const glm::ivec2& size, int highest, test::Random& random)
{
    core::SlicePixels picture{.size = size, .codes = {}};
    for (int i = 0; i < size.x * size.y; ++i)
        picture.codes.push_back(std::uint16_t(test::randomInt(random, 0, highest)));
    return picture;
}

/// Code 800 where @p inside says so, 100 elsewhere.
core::SlicePixels drawn(const glm::ivec2& size, const std::function<bool(int, int)>& inside)
{
    core::SlicePixels picture{.size = size, .codes = {}};
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x)
            picture.codes.push_back(inside(x, y) ? 800 : 100);
    }
    return picture;
}

Costs costsOf(const core::SlicePixels& picture, int low, int high)
{
    return std::make_shared<const core::SideCosts>(core::sideCosts(picture, low, high));
}

/// Of the side between two neighbouring corners.
int costBetween(const core::SideCosts& costs, const glm::ivec2& a, const glm::ivec2& b)
{
    const glm::ivec2 first = glm::min(a, b);
    return a.y == b.y ? costs.along[costs.at(first)] : costs.down[costs.at(first)];
}

/// Every corner of a way, of which only the turns are given; empty if it does not run along sides.
Corners everyCorner(const Corners& turns)
{
    Corners corners{turns.front()};
    for (std::size_t i = 1; i < turns.size(); ++i) {
        const glm::ivec2 step = glm::sign(turns[i] - turns[i - 1]);
        if (std::abs(step.x) + std::abs(step.y) != 1)
            return {};
        while (corners.back() != turns[i])
            corners.push_back(corners.back() + step);
    }
    return corners;
}

/// By going over all sides until nothing gets cheaper (Bellman and Ford).
std::vector<std::int64_t> leastSums(const core::SideCosts& costs, const glm::ivec2& anchor)
{
    const glm::ivec2 corners = costs.pixels + 1;
    std::vector<std::int64_t> sums(
        std::size_t(corners.x * corners.y), std::numeric_limits<std::int32_t>::max());
    sums[costs.at(anchor)] = 0;
    bool changed = true;
    const auto relax = [&](const glm::ivec2& a, const glm::ivec2& b) {
        const std::int64_t through = sums[costs.at(a)] + costBetween(costs, a, b);
        if (through < sums[costs.at(b)]) {
            sums[costs.at(b)] = through;
            changed = true;
        }
    };
    while (changed) {
        changed = false;
        for (int y = 0; y < corners.y; ++y) {
            for (int x = 0; x < corners.x; ++x) {
                const glm::ivec2 here(x, y);
                for (const glm::ivec2& next : {here + glm::ivec2(1, 0), here + glm::ivec2(0, 1)}) {
                    if (next.x < corners.x && next.y < corners.y) {
                        relax(here, next);
                        relax(next, here);
                    }
                }
            }
        }
    }
    return sums;
}

/// Whether a closed outline along sides winds around the centre of a pixel.
bool windsAround(const Corners& outline, int x, int y)
{
    int winding = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::ivec2 a = outline[i];
        const glm::ivec2 b = outline[(i + 1) % outline.size()];
        if (a.x == b.x && a.x <= x && std::min(a.y, b.y) <= y && y < std::max(a.y, b.y))
            winding += a.y < b.y ? -1 : 1;
    }
    return winding != 0;
}

/// From anchor to anchor and back to the first.
Corners closedWire(const Costs& costs, const Corners& anchors)
{
    Corners outline;
    for (std::size_t i = 0; i < anchors.size(); ++i) {
        const Corners way =
            core::CheapestWays(costs, anchors[i]).wayTo(anchors[(i + 1) % anchors.size()]);
        outline.insert(outline.end(), way.begin(), way.end() - 1);
    }
    return outline;
}

} // namespace

class CheapestWaysTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// Rules 1 to 3 of SideCosts.h, side by side from pixels.
    void costsAreThoseOfTheRules()
    {
        test::Random random(5);
        for (int round = 0; round < 40; ++round) {
            const glm::ivec2 size{test::randomInt(random, 1, 9), test::randomInt(random, 1, 9)};
            const core::SlicePixels picture = randomPicture(size, round % 2 ? 60000 : 40, random);
            const int low = test::randomInt(random, -5, 45);
            // Narrow and wrong windows, too.
            const int high = low + test::randomInt(random, -3, round % 2 ? 50000 : 30);
            const core::SideCosts costs = core::sideCosts(picture, low, high);
            QVERIFY(costs.pixels == size);
            const int width = std::max(1, high - low);
            const auto brightness = [&](const glm::ivec2& pixel) {
                const int above = picture.code(pixel) - low;
                return above <= 0 ? 0 : above >= width ? 255 : above * 255 / width;
            };
            for (int y = 0; y <= size.y; ++y) {
                for (int x = 0; x <= size.x; ++x) {
                    for (const bool along : {true, false}) {
                        if (along ? x == size.x : y == size.y)
                            continue;
                        const glm::ivec2 step = along ? glm::ivec2(1, 0) : glm::ivec2(0, 1);
                        const glm::ivec2 over = along ? glm::ivec2(0, -1) : glm::ivec2(-1, 0);
                        const glm::ivec2 pixel(x, y);
                        int contrast = 0;
                        if (picture.contains(pixel) && picture.contains(pixel + over)) {
                            const int weights[]{1, 2, 1};
                            for (int i = -1; i <= 1; ++i) {
                                glm::ivec2 beside = pixel + i * step;
                                if (!picture.contains(beside))
                                    beside = pixel;
                                contrast += weights[i + 1]
                                    * (brightness(beside) - brightness(beside + over));
                            }
                        }
                        const int expected = 1 + 254 * 64 / (64 + std::abs(contrast));
                        QCOMPARE(costBetween(costs, pixel, pixel + step), expected);
                    }
                }
            }
        }
        QCOMPARE(core::SideCosts::ofContrast(0), 255);
        QCOMPARE(core::SideCosts::ofContrast(64), 128);
        QCOMPARE(core::SideCosts::ofContrast(core::SideCosts::greatestContrast), 15);
    }

    void waysAreTheCheapest()
    {
        test::Random random(6);
        for (int round = 0; round < 150; ++round) {
            const glm::ivec2 size{test::randomInt(random, 1, 8), test::randomInt(random, 1, 8)};
            const int highest = round % 3 ? 4000 : 2; // with many ways of the same cost
            const Costs costs = costsOf(randomPicture(size, highest, random), 0, highest);
            const glm::ivec2 anchor{
                test::randomInt(random, 0, size.x), test::randomInt(random, 0, size.y)};
            const core::CheapestWays ways(costs, anchor);
            QVERIFY(ways.anchor() == anchor);
            const std::vector<std::int64_t> least = leastSums(*costs, anchor);
            for (int y = 0; y <= size.y; ++y) {
                for (int x = 0; x <= size.x; ++x) {
                    const glm::ivec2 end(x, y);
                    QCOMPARE(std::int64_t(ways.costTo(end)), least[costs->at(end)]);
                    const Corners turns = ways.wayTo(end);
                    QVERIFY(turns.front() == anchor && turns.back() == end);
                    const Corners corners = everyCorner(turns);
                    QVERIFY(!corners.empty());
                    std::int64_t sum = 0;
                    for (std::size_t i = 1; i < corners.size(); ++i)
                        sum += costBetween(*costs, corners[i - 1], corners[i]);
                    QCOMPARE(sum, least[costs->at(end)]);
                    // Between its ends it is told where it turns, and nowhere else.
                    for (std::size_t i = 2; i < turns.size(); ++i) {
                        QVERIFY(glm::sign(turns[i] - turns[i - 1])
                            != glm::sign(turns[i - 1] - turns[i - 2]));
                    }
                }
            }
        }
    }

    /// Where nothing is seen a wire keeps to the straight line as well as sides allow.
    void withoutEdgesItRunsStraight()
    {
        const Costs costs = costsOf(drawn({30, 20}, [](int, int) { return false; }), 0, 1000);
        const glm::ivec2 anchor(7, 8);
        const core::CheapestWays ways(costs, anchor);
        for (int y = 0; y <= 20; ++y) {
            for (int x = 0; x <= 30; ++x) {
                const glm::ivec2 line = glm::ivec2(x, y) - anchor;
                const int steps = std::abs(line.x) + std::abs(line.y);
                const Corners corners = everyCorner(ways.wayTo({x, y}));
                QCOMPARE(corners.size(), std::size_t(steps) + 1);
                for (const glm::ivec2& corner : corners) {
                    const glm::ivec2 way = corner - anchor;
                    QVERIFY(2 * std::abs(line.x * way.y - line.y * way.x) <= steps);
                }
            }
        }
    }

    void beyondItsReachItRunsStraight()
    {
        test::Random random(8);
        const Costs costs = costsOf(randomPicture({20, 20}, 4000, random), 0, 4000);
        const glm::ivec2 anchor(4, 10);
        const core::CheapestWays ways(costs, anchor, 5);
        Corners expected = ways.wayTo({9, 15});
        QVERIFY(expected.back() == glm::ivec2(9, 15));
        for (const glm::ivec2& corner : everyCorner(expected))
            QVERIFY(corner.x <= 9 && corner.y >= 5 && corner.y <= 15);
        expected.emplace_back(17, 19);
        QVERIFY(ways.wayTo({17, 19}) == expected);
        QVERIFY(ways.wayTo(anchor) == Corners{anchor});
    }

    void itFollowsADrawnEdge_data()
    {
        QTest::addColumn<double>("radius");
        for (const double radius : {3.3, 6.2, 9.7, 20.4})
            QTest::addRow("%.1f", radius) << radius;
    }
    /// A disc, from anchors on its border: what the wire encloses is the disc, to the pixel.
    void itFollowsADrawnEdge()
    {
        QFETCH(const double, radius);
        const auto inside = [radius](
                                int x, int y) { return std::hypot(x - 25.0, y - 25.0) < radius; };
        const core::SlicePixels picture = drawn({51, 51}, inside);
        const Costs costs = costsOf(picture, 100, 800);
        // The corners in the middle of its four outermost sides, where it runs along an axis.
        const int far = int(std::floor(radius)); // of the outermost pixels from the middle
        const Corners anchors{
            {25 + far + 1, 25}, {25, 25 - far}, {25 - far, 25}, {25, 25 + far + 1}};
        for (int first = 0; first < 4; ++first) {
            Corners chosen = anchors;
            std::rotate(chosen.begin(), chosen.begin() + first, chosen.end());
            if (first % 2 == 1)
                std::reverse(chosen.begin(), chosen.end());
            const Corners outline = closedWire(costs, chosen);
            int pixels = 0;
            for (int y = 0; y < 51; ++y) {
                for (int x = 0; x < 51; ++x) {
                    QCOMPARE(windsAround(outline, x, y), inside(x, y));
                    pixels += inside(x, y) ? 1 : 0;
                }
            }
            QVERIFY(pixels > 20);
            for (const glm::ivec2& corner : outline) {
                // No side of it leads elsewhere, there and back.
                int around = 0;
                for (const glm::ivec2& pixel :
                    {corner, corner - 1, corner - glm::ivec2(1, 0), corner - glm::ivec2(0, 1)})
                    around += inside(pixel.x, pixel.y) ? 1 : 0;
                QVERIFY(around > 0 && around < 4);
            }
        }
    }

    /// A faint edge is followed although a much stronger one runs near, and beside the window of
    /// values there is none.
    void itFollowsAFaintEdge()
    {
        // A bar of 400 on 350 above, and a floor of 4000 below.
        core::SlicePixels picture{.size = {40, 20}, .codes = {}};
        for (int y = 0; y < 20; ++y) {
            for (int x = 0; x < 40; ++x)
                picture.codes.push_back(y >= 14 ? 4000 : y >= 6 ? 400 : 350);
        }
        const Corners straight{{2, 6}, {38, 6}};
        QVERIFY(core::CheapestWays(costsOf(picture, 200, 600), {2, 6}).wayTo({38, 6}) == straight);
        const core::CheapestWays seen(costsOf(picture, 200, 600), {2, 6});
        // 50 of 400 is 31 or 32 of 255, and its fourfold on both sides of the middle.
        QCOMPARE(seen.costTo({38, 6}), 36U * unsigned(core::SideCosts::ofContrast(4 * 32)));
        const core::CheapestWays unseen(costsOf(picture, 1000, 2000), {2, 6});
        QVERIFY(unseen.costTo({38, 6}) < 36U * 255U); // by way of the floor
        QVERIFY(unseen.wayTo({38, 6}) != straight);
    }
};

BURIN_TEST(CheapestWaysTest)

} // namespace cheapestWaysTest

#include "CheapestWaysTest.moc"
