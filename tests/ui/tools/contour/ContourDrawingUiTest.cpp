// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/contour/ContourDrawing.h"

#include "core/brick/ThreadWithoutVoxels.h"
#include "core/contour/ContourState.h"
#include "core/volume/VolumeGeometry.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QPainter>
#include <QSignalSpy>
#include <QtTest>

#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

namespace contourDrawingUiTest {

namespace {

const QColor segmentColour(80, 200, 120);

core::VolumeGeometry sheared()
{
    core::VolumeGeometry geometry;
    geometry.size = glm::ivec3(30, 28, 24);
    geometry.indexToWorld[0][0] = 0.9;
    geometry.indexToWorld[1][1] = 0.9;
    geometry.indexToWorld[2][2] = 1.7;
    geometry.indexToWorld[2][1] = 0.3; // a tilted gantry
    geometry.indexToWorld[3] = glm::dvec4(-13.1, -12.3, -20.7, 1.0);
    return geometry;
}

/// A ball in a box, a half of which was the segment's before, with voxels that were and are not.
core::ContourState someContour()
{
    using Ground = core::ContourGround;
    const core::VoxelBox box{{6, 5, 4}, {24, 23, 20}};
    std::mt19937 random(3);
    std::vector<std::uint8_t> voxels;
    for (int z = box.minimum.z; z < box.maximum.z; ++z) {
        for (int y = box.minimum.y; y < box.maximum.y; ++y) {
            for (int x = box.minimum.x; x < box.maximum.x; ++x) {
                const glm::ivec3 step = glm::ivec3(x, y, z) - glm::ivec3(15, 14, 12);
                std::uint8_t flags = 0;
                if (step.x * step.x + step.y * step.y + step.z * step.z < 36)
                    flags = step.x + step.y + step.z < 0 ? Ground::inside | Ground::own
                                                         : Ground::inside;
                else if (random() % 5 == 0)
                    flags = Ground::own;
                voxels.push_back(flags);
            }
        }
    }
    return {box, std::move(voxels)};
}

ui::ViewContext sliceView(const glm::dvec3& right, const glm::dvec3& down)
{
    gpu::SliceScene scene;
    scene.centreLps = {0.0137, -0.0291, 0.0413};
    scene.rightLps = right;
    scene.downLps = down;
    scene.mmPerPixel = 0.371;
    return {.view = 1, .scene = scene, .sizePixels = QSizeF(90.0, 80.0)};
}

} // namespace

class ContourDrawingUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Each pixel is that of the nearest voxel, and the outline that of the segment in pixels.
    void eachPixelIsAVoxel_data()
    {
        QTest::addColumn<glm::dvec3>("right");
        QTest::addColumn<glm::dvec3>("down");
        QTest::addColumn<double>("ratio");
        const double tilt = 0.3;
        for (const double ratio : {1.0, 2.0}) {
            QTest::addRow("axial, %.0f", ratio)
                << glm::dvec3(1.0, 0.0, 0.0) << glm::dvec3(0.0, 1.0, 0.0) << ratio;
            QTest::addRow("sagittal, mirrored, %.0f", ratio)
                << glm::dvec3(0.0, -1.0, 0.0) << glm::dvec3(0.0, 0.0, -1.0) << ratio;
            QTest::addRow("oblique, %.0f", ratio)
                << glm::dvec3(std::cos(tilt), std::sin(tilt), 0.0)
                << glm::normalize(glm::dvec3(-std::sin(tilt), std::cos(tilt), 0.7)) << ratio;
        }
    }
    void eachPixelIsAVoxel()
    {
        QFETCH(const glm::dvec3, right);
        QFETCH(const glm::dvec3, down);
        QFETCH(const double, ratio);
        const core::VolumeGeometry geometry = sheared();
        const core::ContourState state = someContour();
        const ui::ViewContext view = sliceView(right, down);
        const QRect area(11, 7, 71, 66);
        const QImage picture =
            ui::ContourDrawing::picture(area, ratio, view, state, geometry, segmentColour);
        QCOMPARE(picture.size(), area.size() * ratio);
        QCOMPARE(picture.devicePixelRatio(), ratio);
        const auto voxelAt = [&](int x, int y) {
            const QPointF pixel(area.left() + (x + 0.5) / ratio, area.top() + (y + 0.5) / ratio);
            return glm::ivec3(glm::floor(geometry.toIndex(view.toLps(pixel)) + 0.5));
        };
        const auto isIn = [&](int x, int y) { return state.isInside(voxelAt(x, y)); };
        std::array<int, 5> counts{};
        for (int y = 1; y + 1 < picture.height(); ++y) {
            for (int x = 1; x + 1 < picture.width(); ++x) {
                const QColor colour = picture.pixelColor(x, y);
                const bool in = isIn(x, y);
                const bool was = state.wasInside(voxelAt(x, y));
                const bool rim =
                    in && !(isIn(x - 1, y) && isIn(x + 1, y) && isIn(x, y - 1) && isIn(x, y + 1));
                if (rim)
                    QCOMPARE(colour.alpha(), 255);
                else if (in)
                    QCOMPARE(colour.alpha(), was ? 51 : 115);
                else
                    QCOMPARE(colour.alpha(), was ? 102 : 0);
                if (in && !rim)
                    QVERIFY(std::abs(colour.green() - segmentColour.green()) < 6);
                if (!in && was)
                    QVERIFY(colour.red() > colour.green() + 60);
                ++counts[std::size_t(rim ? 0 : in ? (was ? 1 : 2) : was ? 3 : 4)];
            }
        }
        for (const int count : counts)
            QVERIFY(count > 20);
    }

    /// On a view it lies where the box is seen, and it follows contour and view; the window's
    /// thread reads no voxels for it.
    void itLiesWhereItIsSeen()
    {
        const core::VolumeGeometry geometry = sheared();
        auto state = std::make_shared<const core::ContourState>(someContour());
        const ui::ViewContext view = sliceView({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0});
        ui::ContourDrawing drawing;
        QSignalSpy drawn(&drawing, &ui::ContourDrawing::drawn);
        const auto empty = [] {
            QImage canvas(90, 80, QImage::Format_ARGB32_Premultiplied);
            canvas.fill(Qt::transparent);
            return canvas;
        };
        const auto painted = [&](const ui::ViewContext& in) {
            const core::ThreadWithoutVoxels here;
            QImage canvas = empty();
            QPainter painter(&canvas);
            drawing.paint(painter, in, state, geometry, segmentColour);
            painter.end();
            return canvas;
        };
        const auto whole = [&](const ui::ViewContext& in) {
            const QImage image = ui::ContourDrawing::picture(
                QRect(0, 0, 90, 80), 1.0, in, *state, geometry, segmentColour);
            return image.isNull() ? empty() : image;
        };
        QVERIFY(painted(view) == empty());
        QTRY_COMPARE(drawn.size(), 1);
        const QImage first = painted(view);
        QVERIFY(first == whole(view));
        QVERIFY(first != empty());
        QTest::qWait(20);
        QCOMPARE(drawn.size(), 1); // no other one is made
        // What does not move a voxel makes no other one.
        ui::ViewContext darker = view;
        std::get<gpu::SliceScene>(darker.scene).inverted = true;
        QVERIFY(painted(darker) == first);
        ui::ViewContext moved = view;
        std::get<gpu::SliceScene>(moved.scene).centreLps.x += 5.0;
        QVERIFY(painted(moved) == empty()); // not where it was seen before
        QTRY_COMPARE(drawn.size(), 2);
        QVERIFY(painted(moved) == whole(moved));
        QVERIFY(painted(moved) != first);
        ui::ViewContext beside = view;
        std::get<gpu::SliceScene>(beside.scene).centreLps.z += 500.0;
        (void)painted(beside);
        QTRY_COMPARE(drawn.size(), 3);
        QVERIFY(painted(beside) == empty());
        QVERIFY(painted(view) == empty());
        QTRY_COMPARE(drawn.size(), 4);
        // A generation more: the last picture stays until the next one is there.
        std::vector<std::uint32_t> changed;
        for (std::uint32_t place = 0; place < 18U * 18U * 16U; place += 3)
            changed.push_back(place);
        auto next = std::make_shared<core::ContourState>(*state);
        next->pass(changed);
        state = next;
        QVERIFY(painted(view) == first);
        QTRY_COMPARE(drawn.size(), 5);
        QVERIFY(painted(view) == whole(view));
        QVERIFY(painted(view) != first);
        drawing.forget();
        QVERIFY(painted(view) == empty());
        drawing.forget(); // while it is worked out
        QTest::qWait(20);
        QCOMPARE(drawn.size(), 5);
    }

    /// While a picture is made others may be wished for: then it is the newest that is made.
    void theNewestWishWins()
    {
        const core::VolumeGeometry geometry = sheared();
        auto state = std::make_shared<const core::ContourState>(someContour());
        const ui::ViewContext view = sliceView({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0});
        ui::ContourDrawing drawing;
        QSignalSpy drawn(&drawing, &ui::ContourDrawing::drawn);
        const auto painted = [&] {
            QImage canvas(90, 80, QImage::Format_ARGB32_Premultiplied);
            canvas.fill(Qt::transparent);
            QPainter painter(&canvas);
            drawing.paint(painter, view, state, geometry, segmentColour);
            painter.end();
            return canvas;
        };
        for (std::uint32_t wish = 0; wish < 10; ++wish) {
            auto next = std::make_shared<core::ContourState>(*state);
            next->pass(std::vector<std::uint32_t>{wish * 7U, 2500U + wish * 18U});
            state = next;
            (void)painted(); // no event comes in between
        }
        QTRY_COMPARE(drawn.size(), 1); // of the first
        (void)painted();
        QTRY_COMPARE(drawn.size(), 2);
        QVERIFY(painted()
            == ui::ContourDrawing::picture(
                QRect(0, 0, 90, 80), 1.0, view, *state, geometry, segmentColour));
        QTest::qWait(20);
        QCOMPARE(drawn.size(), 2);
    }
};

BURIN_WINDOW_TEST(ContourDrawingUiTest)

} // namespace contourDrawingUiTest

#include "ContourDrawingUiTest.moc"
