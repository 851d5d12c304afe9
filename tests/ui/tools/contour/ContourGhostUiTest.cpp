// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/contour/ContourGhost.h"

#include "core/brick/ThreadWithoutVoxels.h"
#include "core/contour/ContourState.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QPainter>
#include <QSignalSpy>
#include <QtTest>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

namespace contourGhostUiTest {

namespace {

/// What a state is made of.
struct Body {
    core::VolumeGeometry geometry;
    core::VoxelBox box;
    std::vector<std::uint8_t> voxels;
    [[nodiscard]] core::ContourState state() const { return {box, voxels}; }
    [[nodiscard]] QImage picture(const ui::ViewContext& view, const QColor& colour) const
    {
        return ui::ContourGhost::picture(view, state(), geometry, colour);
    }
};

const QColor ghostColour(80, 200, 120);

/// A ball, and specks of which some stay as they are, in a box of a volume around the origin.
Body someBody(bool specks = true)
{
    using Ground = core::ContourGround;
    Body body;
    body.geometry.size = glm::ivec3(28, 26, 30);
    body.geometry.indexToWorld[0][0] = 1.0;
    body.geometry.indexToWorld[1][1] = 1.1;
    body.geometry.indexToWorld[2][2] = 1.6;
    body.geometry.indexToWorld[3] = glm::dvec4(-14.137, -14.3, -23.913, 1.0);
    body.box = {{3, 2, 4}, {25, 24, 26}};
    std::mt19937 random(7);
    for (int z = body.box.minimum.z; z < body.box.maximum.z; ++z) {
        for (int y = body.box.minimum.y; y < body.box.maximum.y; ++y) {
            for (int x = body.box.minimum.x; x < body.box.maximum.x; ++x) {
                const glm::dvec3 step =
                    glm::dvec3(x - 14, y - 13, z - 15) * glm::dvec3(1, 1.1, 1.6);
                std::uint8_t flags = 0;
                if (glm::length(step) < 7.0)
                    flags = Ground::inside;
                else if (specks && random() % 400 == 0)
                    flags = random() % 2 == 0 ? Ground::held | Ground::own : Ground::inside;
                else if (specks && random() % 50 == 0)
                    flags = random() % 2 == 0 ? Ground::held | Ground::inside : Ground::own;
                body.voxels.push_back(flags);
            }
        }
    }
    return body;
}

/// From the front: x to the right, z upwards.
ui::ViewContext frontView()
{
    gpu::VolumeScene scene;
    scene.eyeLps = {0.0, -300.0, 0.0};
    scene.targetLps = {0.0, 0.0, 0.0};
    scene.up = {0.0, 0.0, 1.0};
    scene.heightMm = 40.0;
    return {.view = 3, .scene = scene, .sizePixels = QSizeF(100.0, 80.0)};
}

QImage empty()
{
    QImage image(100, 80, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    return image;
}

} // namespace

class ContourGhostUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// A pixel is covered where a voxel lies behind it, and nowhere else.
    void itCoversItsVoxels()
    {
        const Body body = someBody();
        const core::ContourState state = body.state();
        const QImage picture = body.picture(frontView(), ghostColour);
        QCOMPARE(picture.size(), QSize(100, 80));
        int covered = 0;
        for (int row = 0; row < 80; ++row) {
            for (int column = 0; column < 100; ++column) {
                const double x = (column + 0.5 - 50.0) * 0.5;
                const double z = (40.0 - row - 0.5) * 0.5;
                const glm::ivec3 voxel(glm::floor(body.geometry.toIndex({x, 0.0, z}) + 0.5));
                bool isThere = false;
                for (int y = 0; y < body.geometry.size.y; ++y)
                    isThere = isThere || state.isInside({voxel.x, y, voxel.z});
                QCOMPARE(picture.pixelColor(column, row).alpha() > 0, isThere);
                covered += isThere ? 1 : 0;
            }
        }
        QVERIFY2(covered > 500, qPrintable(QString::number(covered)));
    }

    /// What faces the viewer is brighter than the rim; a perspective shows what is near larger.
    void itLooksRound()
    {
        const Body body = someBody(false);
        const glm::dvec3 middle = body.geometry.toWorld({14.0, 13.0, 15.0});
        const ui::ViewContext view = frontView();
        const QImage picture = body.picture(view, ghostColour);
        const QPoint at = view.toPixel(middle).toPoint();
        const int bright = picture.pixelColor(at).green();
        const int rim = picture.pixelColor(at + QPoint(12, 0)).green(); // 6 of 7 mm
        QVERIFY2(bright > 150 && rim < bright - 30,
            qPrintable(QStringLiteral("%1 and %2").arg(bright).arg(rim)));
        QVERIFY(picture.pixelColor(at).alpha() < 255); // what lies behind is seen
        const auto coveredBy = [&](double eyeY) {
            ui::ViewContext perspective = frontView();
            auto& scene = std::get<gpu::VolumeScene>(perspective.scene);
            scene.orthographic = false;
            scene.eyeLps.y = eyeY;
            scene.targetLps.y = 20.0; // the body lies before it
            const QImage image = body.picture(perspective, ghostColour);
            int count = 0;
            for (int row = 0; row < 80; ++row) {
                for (int column = 0; column < 100; ++column)
                    count += image.pixelColor(column, row).alpha() > 0 ? 1 : 0;
            }
            return count;
        };
        QVERIFY(coveredBy(-60.0) > coveredBy(-600.0) + 50);
    }

    /// Each picture is made beside the window, whose thread reads no voxels; the last one stays
    /// until the next is there.
    void itFollows()
    {
        const Body body = someBody();
        auto state = std::make_shared<const core::ContourState>(body.state());
        std::vector<std::uint32_t> changed;
        for (std::uint32_t place = 0; place < std::uint32_t(body.voxels.size()); place += 2)
            changed.push_back(place);
        ui::ContourGhost ghost;
        QSignalSpy drawn(&ghost, &ui::ContourGhost::drawn);
        const auto painted = [&](const ui::ViewContext& view) {
            const core::ThreadWithoutVoxels here;
            QImage canvas = empty();
            QPainter painter(&canvas);
            ghost.paint(painter, view, state, body.geometry, ghostColour);
            painter.end();
            return canvas;
        };
        const auto expected = [&](const ui::ViewContext& view) {
            return ui::ContourGhost::picture(view, *state, body.geometry, ghostColour);
        };
        const ui::ViewContext view = frontView();
        QVERIFY(painted(view) == empty());
        QTRY_COMPARE(drawn.size(), 1);
        const QImage first = painted(view);
        QVERIFY(first == expected(view));
        QTest::qWait(20);
        QCOMPARE(drawn.size(), 1); // no other one is made
        auto next = std::make_shared<core::ContourState>(*state);
        next->pass(changed);
        state = next;
        QVERIFY(painted(view) == first);
        QTRY_COMPARE(drawn.size(), 2);
        QVERIFY(painted(view) == expected(view));
        QVERIFY(painted(view) != first);
        ui::ViewContext turned = view;
        std::get<gpu::VolumeScene>(turned.scene).eyeLps = {300.0, 0.0, 0.0};
        QVERIFY(painted(turned) == empty()); // not where it was seen before
        QTRY_COMPARE(drawn.size(), 3);
        QVERIFY(painted(turned) == expected(turned));
        ghost.forget();
        QVERIFY(painted(turned) == empty());
        ghost.forget(); // while it is worked out
        QTest::qWait(20);
        QCOMPARE(drawn.size(), 3);
    }
};

BURIN_WINDOW_TEST(ContourGhostUiTest)

} // namespace contourGhostUiTest

#include "ContourGhostUiTest.moc"
