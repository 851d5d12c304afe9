// SPDX-License-Identifier: Apache-2.0
#include "gpu/render/parts/TileParts.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <array>

namespace tilePartsTest {

using namespace gpu;

namespace {

constexpr int side = 8;

bool holds(const Tile& tile, const glm::ivec2& pixel)
{
    return glm::all(glm::lessThanEqual(tile.minimum, pixel))
        && glm::all(glm::lessThan(pixel, tile.minimum + tile.size));
}

} // namespace

/// Rectangles of a picture, pixel by pixel.
class TilePartsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void partsAndHoleAreTheTile();
    void whatTwoShareAndWhatHoldsThem();
};

/// Every hole within a tile of 4 × 3 pixels.
void TilePartsTest::partsAndHoleAreTheTile()
{
    const Tile tile{{2, 1}, {4, 3}};
    int holes = 0;
    for (int x = 0; x < tile.size.x; ++x) {
        for (int y = 0; y < tile.size.y; ++y) {
            for (int width = 1; x + width <= tile.size.x; ++width) {
                for (int height = 1; y + height <= tile.size.y; ++height) {
                    const Tile hole{tile.minimum + glm::ivec2(x, y), {width, height}};
                    std::array<int, std::size_t(side) * side> covered{};
                    for (const Tile& part : partsAround(tile, hole)) {
                        for (int pixel = 0; pixel < side * side; ++pixel)
                            covered[std::size_t(pixel)] +=
                                holds(part, {pixel % side, pixel / side}) ? 1 : 0;
                    }
                    for (int pixel = 0; pixel < side * side; ++pixel) {
                        const glm::ivec2 at(pixel % side, pixel / side);
                        QCOMPARE(covered[std::size_t(pixel)],
                            holds(tile, at) && !holds(hole, at) ? 1 : 0);
                    }
                    ++holes;
                }
            }
        }
    }
    QCOMPARE(holes, 10 * 6);
    QCOMPARE(partsAround(tile, {}).size(), std::size_t(1));
    QVERIFY(partsAround(tile, tile).empty());
}

void TilePartsTest::whatTwoShareAndWhatHoldsThem()
{
    const Tile a{{0, 0}, {4, 4}};
    const Tile b{{2, 3}, {5, 2}};
    const Tile shared = commonPart(a, b);
    QVERIFY(shared.minimum == glm::ivec2(2, 3) && shared.size == glm::ivec2(2, 1));
    const Tile both = unionOf(a, b);
    QVERIFY(both.minimum == glm::ivec2(0, 0) && both.size == glm::ivec2(7, 5));
    // Those that touch share nothing.
    QVERIFY(commonPart(a, {{4, 0}, {2, 2}}).size == glm::ivec2(0));
}

BURIN_TEST(TilePartsTest)

} // namespace tilePartsTest

#include "TilePartsTest.moc"
