// SPDX-License-Identifier: Apache-2.0
#include "core/outline/LevelContour.h"
#include "core/sculpt/labels/LabelOutlined.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <vector>

namespace levelContourTest {

namespace {

/// Digits are codes; rows end in '/'.
core::SlicePixels drawn(std::string_view picture)
{
    core::SlicePixels pixels{.size = {0, 1}, .codes = {}};
    for (const char digit : picture) {
        if (digit == '/')
            ++pixels.size.y;
        else
            pixels.codes.push_back(std::uint16_t(digit - '0'));
    }
    pixels.size.x = int(pixels.codes.size()) / pixels.size.y;
    return pixels;
}

/// A picture of yes and no with a frame of no around it, one pixel wide.
struct Framed {
    explicit Framed(const glm::ivec2& ofSize)
        : size(ofSize)
        , yes(std::size_t((size.x + 2) * (size.y + 2)), false)
    {
    }
    [[nodiscard]] std::size_t at(int x, int y) const
    {
        return std::size_t((y + 1) * (size.x + 2) + x + 1);
    }
    [[nodiscard]] int count() const { return int(std::count(yes.begin(), yes.end(), true)); }

    glm::ivec2 size;
    std::vector<bool> yes;
};

/// Passes yes on to neighbours that may have it until there is none left.
template <class May> void passOn(Framed& picture, bool overCorners, const May& may)
{
    for (bool changed = true; changed;) {
        changed = false;
        for (int y = -1; y <= picture.size.y; ++y) {
            for (int x = -1; x <= picture.size.x; ++x) {
                if (picture.yes[picture.at(x, y)] || !may(x, y))
                    continue;
                for (int dy = -1; dy <= 1; ++dy) {
                    for (int dx = -1; dx <= 1; ++dx) {
                        const int nextX = x + dx;
                        const int nextY = y + dy;
                        if ((dx != 0 && dy != 0 && !overCorners) || nextX < -1 || nextY < -1
                            || nextX > picture.size.x || nextY > picture.size.y)
                            continue;
                        if (picture.yes[picture.at(nextX, nextY)]) {
                            picture.yes[picture.at(x, y)] = true;
                            changed = true;
                        }
                    }
                }
            }
        }
    }
}

struct Expected {
    Framed inside; ///< with holes
    bool reachesBorder = false;
};

/// Rules 1 and 2 of LevelContour.h for one of the two parts.
Expected partOf(const core::SlicePixels& picture, const glm::ivec2& pixel, bool brighter)
{
    const int level = picture.code(pixel);
    Framed part(picture.size);
    part.yes[part.at(pixel.x, pixel.y)] = true;
    passOn(part, false, [&](int x, int y) {
        if (!picture.contains({x, y}))
            return false;
        const int code = picture.code({x, y});
        return brighter ? code >= level : code <= level;
    });
    Framed outside(picture.size);
    outside.yes[outside.at(-1, -1)] = true;
    passOn(outside, true, [&part](int x, int y) { return !part.yes[part.at(x, y)]; });
    Expected expected{.inside = Framed(picture.size)};
    for (int y = 0; y < picture.size.y; ++y) {
        for (int x = 0; x < picture.size.x; ++x) {
            expected.inside.yes[expected.inside.at(x, y)] = !outside.yes[outside.at(x, y)];
            const bool atBorder =
                x == 0 || y == 0 || x == picture.size.x - 1 || y == picture.size.y - 1;
            if (atBorder && part.yes[part.at(x, y)])
                expected.reachesBorder = true;
        }
    }
    return expected;
}

/// The voxels that the edit fills when it is given these corners on a grid of this size, by the
/// rule that both engines follow.
Framed filled(const std::vector<glm::ivec2>& corners, const glm::ivec2& size)
{
    constexpr std::int64_t millimetre = std::int64_t(1) << 30;
    constexpr int millimetre16 = 1 << 16;
    core::LabelOutlined edit{.target = {.plane = 0, .label = 1}, .halfThickness = millimetre16 / 2};
    edit.perI[0] = millimetre;
    edit.perJ[1] = millimetre;
    edit.perK[2] = millimetre;
    for (const glm::ivec2& corner : corners)
        edit.corners.push_back(corner * millimetre16 - millimetre16 / 2);
    const core::BrickGrid grid{glm::ivec3(size, 1)};
    Framed found(size);
    for (const core::RelabelListed::Brick& brick : core::voxelsWithin(edit, grid)) {
        const core::VoxelBox box = grid.boxOf(int(brick.brick));
        for (int y = box.minimum.y; y < box.maximum.y; ++y) {
            for (int x = box.minimum.x; x < box.maximum.x; ++x) {
                if (brick.asked[std::size_t(core::BrickGrid::offsetInBrick({x, y, 0}))] != 0)
                    found.yes[found.at(x, y)] = true;
            }
        }
    }
    return found;
}

} // namespace

class LevelContourTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// Noise of few values, so that parts touch by corners, have holes in holes and reach the
    /// border; against parts found another way.
    void itEnclosesThePartWithItsHoles()
    {
        test::Random random(12);
        int dark = 0;
        int withHoles = 0;
        int atBorder = 0;
        constexpr int rounds = 400;
        for (int round = 0; round < rounds; ++round) {
            // In half of them something lies in an empty frame.
            const bool framed = round % 2 == 1;
            const int least = framed ? 5 : 1;
            const glm::ivec2 size{
                test::randomInt(random, least, 12), test::randomInt(random, least, 12)};
            core::SlicePixels picture{.size = size, .codes = {}};
            const int highest = test::randomInt(random, 1, 5);
            for (int i = 0; i < size.x * size.y; ++i) {
                const bool isRim = i < size.x || i >= size.x * (size.y - 1) || i % size.x == 0
                    || i % size.x == size.x - 1;
                int code = test::randomInt(random, 0, highest);
                if (framed && (isRim || random() % 4 == 0))
                    code = 0;
                else if (framed && code == 0)
                    code = 1;
                picture.codes.push_back(std::uint16_t(code));
            }
            const int rim = framed ? 1 : 0;
            const glm::ivec2 pixel{test::randomInt(random, rim, size.x - 1 - rim),
                test::randomInt(random, rim, size.y - 1 - rim)};
            const core::LevelContour contour = core::levelContour(picture, pixel);
            QCOMPARE(contour.level, picture.code(pixel));

            const Expected bright = partOf(picture, pixel, true);
            const Expected faint = partOf(picture, pixel, false);
            const bool brighter = bright.reachesBorder != faint.reachesBorder
                ? !bright.reachesBorder
                : bright.inside.count() <= faint.inside.count();
            QCOMPARE(contour.brighter, brighter);
            const Expected& expected = brighter ? bright : faint;
            QCOMPARE(contour.reachesBorder, expected.reachesBorder);
            QCOMPARE(int(contour.pixels), expected.inside.count());
            const Framed found = filled(contour.corners, size);
            QVERIFY(found.yes == expected.inside.yes);
            QVERIFY(found.yes[found.at(pixel.x, pixel.y)]);

            // It runs along sides, and each corner is a turn.
            const std::size_t corners = contour.corners.size();
            QVERIFY(corners >= 4);
            for (std::size_t i = 0; i < corners; ++i) {
                const glm::ivec2 here = contour.corners[i];
                const glm::ivec2 way = contour.corners[(i + 1) % corners] - here;
                const glm::ivec2 before = here - contour.corners[(i + corners - 1) % corners];
                QVERIFY((way.x == 0) != (way.y == 0));
                QVERIFY((way.x == 0) != (before.x == 0));
            }
            dark += brighter ? 0 : 1;
            atBorder += expected.reachesBorder ? 1 : 0;
            for (int i = 0; i < size.x * size.y; ++i) {
                const int code = picture.codes[std::size_t(i)];
                const bool beyond = brighter ? code < contour.level : code > contour.level;
                if (beyond && found.yes[found.at(i % size.x, i / size.x)]) {
                    ++withHoles;
                    break;
                }
            }
        }
        QVERIFY(dark > 20);
        QVERIFY(withHoles > 10);
        QVERIFY(atBorder > 20 && atBorder < rounds - 20);
    }

    /// What a hand would expect: a bright spot in a dark ground, a dark one in a bright ring, and
    /// the ring with what it encloses.
    void spotsAndRings()
    {
        const core::SlicePixels picture = drawn("00000000/"
                                                "05555500/"
                                                "05333500/"
                                                "05313500/"
                                                "05333500/"
                                                "05555500/"
                                                "00000070/"
                                                "00000000");
        const core::LevelContour ring = core::levelContour(picture, {1, 1});
        QVERIFY(ring.brighter && !ring.reachesBorder);
        QVERIFY((ring.corners == std::vector<glm::ivec2>{{1, 1}, {6, 1}, {6, 6}, {1, 6}}));
        const core::LevelContour grey = core::levelContour(picture, {2, 3});
        QVERIFY(!grey.brighter && !grey.reachesBorder);
        QVERIFY((grey.corners == std::vector<glm::ivec2>{{2, 2}, {5, 2}, {5, 5}, {2, 5}}));
        const core::LevelContour middle = core::levelContour(picture, {3, 3});
        QVERIFY(!middle.brighter);
        QVERIFY((middle.corners == std::vector<glm::ivec2>{{3, 3}, {4, 3}, {4, 4}, {3, 4}}));
        // The pixel of 7 touches the ring by a corner alone.
        const core::LevelContour spot = core::levelContour(picture, {6, 6});
        QVERIFY(spot.brighter);
        QVERIFY((spot.corners == std::vector<glm::ivec2>{{6, 6}, {7, 6}, {7, 7}, {6, 7}}));
        const core::LevelContour ground = core::levelContour(picture, {0, 0});
        QVERIFY(ground.brighter && ground.reachesBorder);
        QCOMPARE(int(ground.pixels), 64);
        QVERIFY((ground.corners == std::vector<glm::ivec2>{{0, 0}, {8, 0}, {8, 8}, {0, 8}}));
    }
};

BURIN_TEST(LevelContourTest)

} // namespace levelContourTest

#include "LevelContourTest.moc"
