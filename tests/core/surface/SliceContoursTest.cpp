// SPDX-License-Identifier: Apache-2.0
#include "core/surface/SliceContours.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/TestVolumes.h"

#include <QTest>

#include <string_view>

namespace sliceContoursTest {

namespace {

/// '#' is label 1; rows end in '/'.
std::vector<std::uint8_t> drawn(std::string_view picture, glm::ivec2& size)
{
    std::vector<std::uint8_t> labels;
    size = {0, 1};
    for (const char pixel : picture) {
        if (pixel == '/')
            ++size.y;
        else
            labels.push_back(pixel == '#' ? 1 : 0);
    }
    size.x = int(labels.size()) / size.y;
    return labels;
}

std::int64_t twiceTheArea(const core::SliceContour& contour)
{
    std::int64_t area = 0;
    for (std::size_t i = 0; i < contour.size(); ++i) {
        const glm::ivec2 a = contour[i];
        const glm::ivec2 b = contour[(i + 1) % contour.size()];
        area += std::int64_t(a.x) * b.y - std::int64_t(b.x) * a.y;
    }
    return area;
}

/// How often contours wind around the centre of a pixel, and how often their sides lie to its left.
std::pair<int, int> around(const std::vector<core::SliceContour>& contours, int x, int y)
{
    int winding = 0;
    int crossings = 0;
    for (const core::SliceContour& contour : contours) {
        for (std::size_t i = 0; i < contour.size(); ++i) {
            const glm::ivec2 a = contour[i];
            const glm::ivec2 b = contour[(i + 1) % contour.size()];
            if (a.x != b.x || a.x > x)
                continue;
            if (std::min(a.y, b.y) <= y && y < std::max(a.y, b.y)) {
                winding += a.y < b.y ? -1 : 1;
                ++crossings;
            }
        }
    }
    return {winding, crossings};
}

/// Parts whose pixels hang together by their sides.
int partsOf(std::vector<std::uint8_t> labels, const glm::ivec2& size)
{
    int parts = 0;
    std::vector<glm::ivec2> open;
    const auto take = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= size.x || y >= size.y)
            return false;
        std::uint8_t& label = labels[std::size_t(y * size.x + x)];
        const bool found = label == 1;
        if (found) {
            label = 0;
            open.emplace_back(x, y);
        }
        return found;
    };
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            parts += take(x, y) ? 1 : 0;
            while (!open.empty()) {
                const glm::ivec2 p = open.back();
                open.pop_back();
                take(p.x + 1, p.y);
                take(p.x - 1, p.y);
                take(p.x, p.y + 1);
                take(p.x, p.y - 1);
            }
        }
    }
    return parts;
}

} // namespace

/// Outlines of the pixels of a slice.
class SliceContoursTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void shapes_data();
    void shapes();
    void aRingIsOneOutlineWithASlit();
    void theVeryPixelsOfNoise_data();
    void theVeryPixelsOfNoise();
};

void SliceContoursTest::shapes_data()
{
    QTest::addColumn<QByteArray>("picture");
    QTest::addColumn<QList<int>>("points");
    QTest::newRow("nothing") << QByteArray("..../....") << QList<int>{};
    QTest::newRow("one pixel") << QByteArray("#") << QList<int>{4};
    QTest::newRow("a bar") << QByteArray("...../.###.") << QList<int>{4};
    QTest::newRow("all") << QByteArray("###/###") << QList<int>{4};
    QTest::newRow("corners that touch") << QByteArray("#./.#") << QList<int>{4, 4};
    QTest::newRow("corners that touch, the other way") << QByteArray(".#/#.") << QList<int>{4, 4};
    QTest::newRow("an L") << QByteArray("#../#../###") << QList<int>{6};
    // The two tips touch at a corner: the outline passes it twice.
    QTest::newRow("tips that touch") << QByteArray("####/#.#./####/....") << QList<int>{14};
}

void SliceContoursTest::shapes()
{
    QFETCH(QByteArray, picture);
    QFETCH(QList<int>, points);
    glm::ivec2 size;
    const auto labels = drawn(picture.constData(), size);
    const auto contours = core::sliceContours(labels, 1, size);
    QList<int> found;
    for (const auto& contour : contours)
        found.push_back(int(contour.size()));
    QCOMPARE(found, points);
}

void SliceContoursTest::aRingIsOneOutlineWithASlit()
{
    glm::ivec2 size;
    const auto labels = drawn("####/#..#/####", size);
    const auto contours = core::sliceContours(labels, 1, size);
    QCOMPARE(contours.size(), std::size_t(1));
    const core::SliceContour ring{
        {0, 1}, {1, 1}, {1, 2}, {3, 2}, {3, 1}, {0, 1}, {0, 0}, {4, 0}, {4, 3}, {0, 3}};
    QCOMPARE(contours[0].size(), ring.size());
    // Wherever it begins.
    bool same = false;
    for (std::size_t first = 0; first < ring.size(); ++first) {
        bool all = true;
        for (std::size_t i = 0; i < ring.size(); ++i)
            all = all && ring[(first + i) % ring.size()] == contours[0][i];
        same = same || all;
    }
    QVERIFY(same);
}

void SliceContoursTest::theVeryPixelsOfNoise_data()
{
    QTest::addColumn<int>("share");
    for (const int share : {5, 30, 50, 60, 80, 97})
        QTest::addRow("%d %% of the pixels", share) << share;
}

/// Each outline encloses its part alone, by any rule of filling, and is one for each part.
void SliceContoursTest::theVeryPixelsOfNoise()
{
    QFETCH(int, share);
    auto random = test::Random(unsigned(share));
    for (int trial = 0; trial < 40; ++trial) {
        const glm::ivec2 size{test::randomInt(random, 1, 24), test::randomInt(random, 1, 19)};
        std::vector<std::uint8_t> labels(std::size_t(size.x * size.y));
        int pixels = 0;
        for (auto& label : labels) {
            label = test::randomInt(random, 0, 99) < share ? 1 : 2;
            pixels += label == 1 ? 1 : 0;
        }
        const auto contours = core::sliceContours(labels, 1, size);
        QCOMPARE(int(contours.size()), partsOf(labels, size));
        std::int64_t area = 0;
        for (const auto& contour : contours)
            area += twiceTheArea(contour);
        QCOMPARE(area, std::int64_t(2 * pixels));
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const auto [winding, crossings] = around(contours, x, y);
                const int expected = labels[std::size_t(y * size.x + x)] == 1 ? 1 : 0;
                QCOMPARE(winding, expected);
                QCOMPARE(crossings % 2, expected);
            }
        }
    }
}

BURIN_TEST(SliceContoursTest)

} // namespace sliceContoursTest

#include "SliceContoursTest.moc"
