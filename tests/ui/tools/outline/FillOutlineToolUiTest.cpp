// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/outline/FillOutlineTool.h"

#include "core/edits/kinds/segments/FillOutline.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/base/Actions.h"
#include "ui/views/PlaneView.h"
#include "ui/views/ViewGrid.h"
#include "ui/workspace/CuttingPlane.h"

#include <QAction>
#include <QComboBox>
#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <set>

namespace fillOutlineToolUiTest {

namespace {

using Shape = ui::FillOutlineTool::Shape;
using Voxels = std::set<std::array<int, 3>>;

/// The real window with the small head, whose middle voxel (20, 20, 20) has the crosshair.
class Fixture : public test::WindowFixture {
public:
    Fixture()
        : test::WindowFixture(test::smallHead::volume())
        , tool(workspace)
        , views(window.views())
    {
        workspace.setCrosshairLps(place({20.0, 20.0, 20.0}));
        workspace.setActiveTool(&tool);
    }
    [[nodiscard]] const core::FillOutline& lastEdit()
    {
        return session().history().rows().back().edit.get<core::FillOutline>();
    }

    void clickWithPen(const QPointF& at, test::Pen& pen)
    {
        pen.hover(at, m_milliseconds += 8);
        pen.press(at, 0.4, m_milliseconds += 8);
        pen.release(at, m_milliseconds += 8);
    }
    /// From the first to the last point, with the button or the tip down.
    void drag(ui::ImageView& view, const std::vector<QPointF>& way, bool pen,
        test::Pen::End end = test::Pen::End::Tip, Qt::KeyboardModifiers modifiers = {})
    {
        test::Pen stylus(view, end);
        for (std::size_t i = 0; i < way.size(); ++i) {
            if (pen && i == 0)
                stylus.press(way[i], 0.5, m_milliseconds += 8);
            else if (pen)
                stylus.move(way[i], 0.6, m_milliseconds += 8);
            else
                mouse(
                    view, i == 0 ? QEvent::MouseButtonPress : QEvent::MouseMove, way[i], modifiers);
        }
        if (pen)
            stylus.release(way.back(), m_milliseconds += 8);
        else
            mouse(view, QEvent::MouseButtonRelease, way.back(), modifiers);
        QVERIFY(session().settle());
    }
    /// Around 10 … 18 × 12 … 20 of the axial slice, half a voxel away from any.
    [[nodiscard]] std::vector<QPointF> square() const
    {
        const ui::SliceView& view = views.axial();
        return {pixel(view, {9.6, 11.6, 20.0}), pixel(view, {18.4, 11.6, 20.0}),
            pixel(view, {18.4, 20.4, 20.0}), pixel(view, {9.6, 20.4, 20.0})};
    }
    [[nodiscard]] static Voxels squareVoxels()
    {
        Voxels voxels;
        for (int y = 12; y <= 20; ++y)
            for (int x = 10; x <= 18; ++x)
                voxels.insert({x, y, 20});
        return voxels;
    }
    /// Within 4.4 voxels of (14, 16, 20).
    [[nodiscard]] static Voxels discVoxels()
    {
        Voxels voxels;
        for (int y = -4; y <= 4; ++y)
            for (int x = -4; x <= 4; ++x)
                if (x * x + y * y <= 19)
                    voxels.insert({14 + x, 16 + y, 20});
        return voxels;
    }
    [[nodiscard]] std::vector<QPointF> ring() const
    {
        std::vector<QPointF> way;
        for (int i = 0; i < 40; ++i) {
            const double angle = 2.0 * M_PI * i / 40.0;
            way.push_back(pixel(
                views.axial(), {14.0 + 4.4 * std::cos(angle), 16.0 + 4.4 * std::sin(angle), 20.0}));
        }
        return way;
    }

    /// Whether something is so once what is worked out beside the window has come.
    [[nodiscard]] bool comes(const std::function<bool()>& there)
    {
        constexpr int longestMs = 30000;
        return QTest::qWaitFor(
            [this, &there] {
                session().poll();
                return there();
            },
            longestMs);
    }
    [[nodiscard]] bool comesToRows(std::size_t count)
    {
        return comes([this, count] { return rows() == count; }) && session().settle();
    }
    /// Lets what is worked out beside the window come, if it is fast.
    void pause()
    {
        for (int i = 0; i < 5; ++i) {
            session().poll();
            QTest::qWait(20);
        }
    }
    /// The middles of the four outermost sides of the head in the axial slice, on corners of
    /// pixels. All values of the small head are within the window then.
    [[nodiscard]] std::vector<QPointF> headCorners()
    {
        workspace.setWindowLevel({.centre = -50.0, .width = 1900.0});
        const ui::SliceView& view = views.axial();
        return {pixel(view, {35.5, 20.5, 20.0}), pixel(view, {20.5, 4.5, 20.0}),
            pixel(view, {4.5, 20.5, 20.0}), pixel(view, {20.5, 35.5, 20.0})};
    }
    /// Nearer than this to the middle in the axial slice.
    [[nodiscard]] static Voxels within(int mm)
    {
        Voxels voxels;
        for (int y = -mm; y <= mm; ++y)
            for (int x = -mm; x <= mm; ++x)
                if (x * x + y * y < mm * mm)
                    voxels.insert({20 + x, 20 + y, 20});
        return voxels;
    }

    ui::FillOutlineTool tool;
    ui::ViewGrid& views;

private:
    quint64 m_milliseconds = 50000;
};

} // namespace

class FillOutlineToolUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void aRectangleIsDragged_data()
    {
        QTest::addColumn<int>("axis");
        QTest::addColumn<bool>("pen");
        for (const bool pen : {false, true}) {
            QTest::addRow("sagittal, %s", pen ? "pen" : "mouse") << 0 << pen;
            QTest::addRow("coronal, %s", pen ? "pen" : "mouse") << 1 << pen;
            QTest::addRow("axial, %s", pen ? "pen" : "mouse") << 2 << pen;
        }
    }
    void aRectangleIsDragged()
    {
        QFETCH(const int, axis);
        QFETCH(const bool, pen);
        Fixture fixture;
        fixture.tool.setShape(Shape::Rectangle);
        const std::array<ui::SliceView*, 3> views{
            &fixture.views.sagittal(), &fixture.views.coronal(), &fixture.views.axial()};
        ui::SliceView& view = *views[std::size_t(axis)];
        glm::dvec3 from(9.6, 11.6, 13.6);
        glm::dvec3 to(18.4, 20.4, 17.4);
        from[axis] = to[axis] = 20.0;
        const QPointF start = fixture.pixel(view, from);
        const QPointF end = fixture.pixel(view, to);
        fixture.drag(view, {start, (start + end) / 2.0, end}, pen);
        QCOMPARE(fixture.rows(), std::size_t(2)); // a segment for it, and the outline
        QCOMPARE(fixture.session().history().rows().back().name.left(34),
            QStringLiteral("Fill an outline with 'Segment 1', "));
        Voxels expected;
        const glm::ivec3 first = glm::ivec3(glm::ceil(from));
        const glm::ivec3 last = glm::ivec3(glm::floor(to));
        for (int z = first.z; z <= last.z; ++z)
            for (int y = first.y; y <= last.y; ++y)
                for (int x = first.x; x <= last.x; ++x)
                    expected.insert({x, y, z});
        QVERIFY(expected.size() >= 36);
        QVERIFY(fixture.voxels() == expected);
        QVERIFY(fixture.session().undo() && fixture.session().settle());
        QVERIFY(fixture.voxels().empty());
    }

    void anEllipseIsDragged()
    {
        for (const bool pen : {false, true}) {
            Fixture fixture;
            fixture.tool.setShape(Shape::Ellipse);
            const std::vector<QPointF> corners = fixture.square();
            fixture.drag(fixture.views.axial(), {corners[2], corners[1], corners[0]}, pen);
            QVERIFY(fixture.voxels() == Fixture::discVoxels());
            QCOMPARE(fixture.rows(), std::size_t(2));
        }
    }

    void aLassoIsDrawn()
    {
        for (const bool pen : {false, true}) {
            Fixture fixture;
            QVERIFY(fixture.tool.shape() == Shape::Lasso);
            fixture.drag(fixture.views.axial(), fixture.ring(), pen);
            QVERIFY(fixture.voxels() == Fixture::discVoxels());
            QCOMPARE(fixture.rows(), std::size_t(2));
            QVERIFY(fixture.lastEdit().polygonMm.size() >= 35);
            QVERIFY(!fixture.lastEdit().erase);
        }
    }

    void aPolygonIsClicked_data()
    {
        QTest::addColumn<QString>("closing");
        QTest::addColumn<bool>("pen");
        for (const bool pen : {false, true}) {
            for (const char* closing : {"Enter", "first corner", "double click"})
                QTest::addRow("%s, %s", closing, pen ? "pen" : "mouse")
                    << QString::fromLatin1(closing) << pen;
        }
    }
    void aPolygonIsClicked()
    {
        QFETCH(const QString, closing);
        QFETCH(const bool, pen);
        Fixture fixture;
        fixture.tool.setShape(Shape::Polygon);
        ui::SliceView& view = fixture.views.axial();
        test::Pen stylus(view);
        const auto click = [&](const QPointF& at) {
            if (pen)
                fixture.clickWithPen(at, stylus);
            else
                Fixture::click(view, at);
        };
        const std::vector<QPointF> corners = fixture.square();
        for (const QPointF& corner : corners) {
            click(corner);
            QCOMPARE(fixture.rows(), std::size_t(0));
        }
        if (closing == QLatin1String("Enter")) {
            // A corner too many is taken back.
            click(fixture.pixel(view, {30.0, 35.0, 20.0}));
            QTest::keyClick(&view, Qt::Key_Backspace);
            QTest::keyClick(&view, Qt::Key_Return);
        } else if (closing == QLatin1String("first corner")) {
            click(corners.front() + QPointF(2.0, -1.0));
        } else if (pen) {
            click(corners.back() + QPointF(1.0, 1.0));
        } else {
            Fixture::mouse(view, QEvent::MouseButtonDblClick, corners.back());
            Fixture::mouse(view, QEvent::MouseButtonRelease, corners.back());
        }
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(2));
        QVERIFY(fixture.voxels() == Fixture::squareVoxels());
        QVERIFY(!fixture.views.maximised());
        // The next click begins another one.
        click(corners.front());
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(2));
    }

    /// It has a plane: corners are added in that slice alone, after the picture was moved, too.
    void aPolygonStaysInItsSlice()
    {
        Fixture fixture;
        fixture.tool.setShape(Shape::Polygon);
        ui::SliceView& view = fixture.views.axial();
        std::vector<QPointF> corners = fixture.square();
        Fixture::click(view, corners[0]);
        Fixture::click(view, corners[1]);
        Fixture::mouse(view, QEvent::MouseButtonDblClick, corners[1]); // too early
        Fixture::mouse(view, QEvent::MouseButtonRelease, corners[1]);
        int said = 0;
        connect(&fixture.workspace, &ui::Workspace::said, this, [&said] { ++said; });
        fixture.workspace.setCrosshairLps(fixture.place({20.0, 20.0, 24.0}));
        Fixture::click(view, corners[3]);
        QCOMPARE(said, 1);
        fixture.workspace.setCrosshairLps(fixture.place({20.0, 20.0, 20.0}));
        corners = fixture.square();
        Fixture::click(view, corners[2]);
        Fixture::click(view, corners[3]);
        QTest::keyClick(&view, Qt::Key_Enter);
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.voxels() == Fixture::squareVoxels());
        QCOMPARE(fixture.rows(), std::size_t(2));
    }

    void controlAndTheEraserEndErase()
    {
        Fixture fixture;
        fixture.tool.setShape(Shape::Rectangle);
        ui::SliceView& view = fixture.views.axial();
        const std::vector<QPointF> corners = fixture.square();
        fixture.drag(view, {corners[0], corners[2]}, false);
        Voxels expected = Fixture::squareVoxels();
        QVERIFY(fixture.voxels() == expected);

        fixture.tool.setShape(Shape::Lasso);
        fixture.drag(view, fixture.ring(), true, test::Pen::End::Eraser);
        for (const auto& voxel : Fixture::discVoxels())
            expected.erase(voxel);
        QVERIFY(!expected.empty() && fixture.voxels() == expected);
        QVERIFY(fixture.lastEdit().erase);
        QCOMPARE(fixture.rows(), std::size_t(3));

        fixture.tool.setShape(Shape::Rectangle);
        const QPointF middle = fixture.pixel(view, {13.5, 25.0, 20.0});
        fixture.drag(view, {corners[0], middle}, false, test::Pen::End::Tip, Qt::ControlModifier);
        for (auto voxel = expected.begin(); voxel != expected.end();)
            voxel = (*voxel)[0] <= 13 ? expected.erase(voxel) : std::next(voxel);
        QVERIFY(!expected.empty() && fixture.voxels() == expected);
        QCOMPARE(fixture.rows(), std::size_t(4));
        QVERIFY(fixture.session().history().rows().back().name.startsWith(
            QStringLiteral("Erase 'Segment 1' in an outline, ")));
    }

    void escapeDropsIt()
    {
        Fixture fixture;
        ui::SliceView& view = fixture.views.axial();
        const std::vector<QPointF> corners = fixture.square();
        for (const Shape shape : {Shape::Lasso, Shape::Rectangle, Shape::Ellipse}) {
            fixture.tool.setShape(shape);
            Fixture::mouse(view, QEvent::MouseButtonPress, corners[0]);
            for (const QPointF& corner : corners)
                Fixture::mouse(view, QEvent::MouseMove, corner);
            QTest::keyClick(&view, Qt::Key_Escape);
            Fixture::mouse(view, QEvent::MouseButtonRelease, corners[3]);
        }
        fixture.tool.setShape(Shape::Polygon);
        for (const QPointF& corner : corners)
            Fixture::click(view, corner);
        QTest::keyClick(&view, Qt::Key_Escape);
        QTest::keyClick(&view, Qt::Key_Return); // nothing is left to close
        for (const QPointF& corner : corners)
            Fixture::click(view, corner);
        for (int i = 0; i < 5; ++i)
            QTest::keyClick(&view, Qt::Key_Backspace); // one more than there are
        QTest::keyClick(&view, Qt::Key_Return);
        Fixture::click(view, corners[0]);
        fixture.tool.setShape(Shape::Lasso); // another shape drops it, too
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(0));
        // A click is no lasso.
        Fixture::click(view, corners[0]);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(0));
    }

    /// The cutting plane's own slice, against the distances of voxels from it.
    void anObliqueSlice()
    {
        Fixture fixture;
        fixture.tool.setShape(Shape::Rectangle);
        fixture.workspace.plane().setPose(ui::CuttingPlane::poseFacing(
            fixture.place({20.2, 19.7, 20.4}), glm::normalize(glm::dvec3(0.3, 0.5, 1.0))));
        fixture.views.arrange(ui::ViewGrid::Layout::PenAndStage);
        ui::PlaneView& view = fixture.views.plane();
        QTRY_VERIFY(view.isVisible() && view.width() > 100 && view.height() > 100);
        QCoreApplication::processEvents();
        const ui::CuttingPlane::Pose pose = fixture.workspace.plane().pose();
        const glm::dvec3 normal = pose.normalLps();
        const glm::dvec3 middle = pose.centreLps;
        QVERIFY(std::abs(normal.x) > 0.2 && std::abs(normal.y) > 0.2 && std::abs(normal.z) > 0.2);
        const auto at = [&](double right, double down) {
            return view.context().toPixel(middle + right * pose.rightLps + down * pose.downLps);
        };
        fixture.drag(view, {at(-7.3, -5.6), at(1.0, 1.0), at(8.7, 6.1)}, true);
        QCOMPARE(fixture.rows(), std::size_t(2));
        const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
        double halfMm = 0.0;
        for (int axis = 0; axis < 3; ++axis)
            halfMm = std::max(
                halfMm, std::abs(glm::dot(normal, glm::dvec3(geometry.indexToWorld[axis]))) / 2.0);
        const Voxels filled = fixture.voxels();
        int inside = 0;
        int unclear = 0;
        for (int z = 0; z < geometry.size.z; ++z) {
            for (int y = 0; y < geometry.size.y; ++y) {
                for (int x = 0; x < geometry.size.x; ++x) {
                    const glm::dvec3 from = geometry.toWorld(glm::dvec3(x, y, z)) - middle;
                    const double right = glm::dot(from, pose.rightLps);
                    const double down = glm::dot(from, pose.downLps);
                    // How far outside it lies, below 0 inside.
                    const double out = std::max({std::abs(glm::dot(from, normal)) - halfMm,
                        -7.3 - right, right - 8.7, -5.6 - down, down - 6.1});
                    if (std::abs(out) < 0.005) {
                        ++unclear;
                        continue;
                    }
                    QCOMPARE(filled.count({x, y, z}) == 1, out < 0.0);
                    inside += out < 0.0 ? 1 : 0;
                }
            }
        }
        QVERIFY(inside > 120 && unclear < 30);
    }

    void aWireFollowsTheEdge_data()
    {
        QTest::addColumn<QString>("closing");
        QTest::addColumn<bool>("pen");
        QTest::addColumn<bool>("slowly");
        for (const bool slowly : {false, true}) {
            for (const bool pen : {false, true}) {
                for (const char* closing : {"Enter", "first anchor", "double click"})
                    QTest::addRow(
                        "%s, %s, %s", closing, pen ? "pen" : "mouse", slowly ? "slowly" : "at once")
                        << QString::fromLatin1(closing) << pen << slowly;
            }
        }
    }
    /// From anchor to anchor on the border of the head: what it encloses is the head, however fast
    /// it is clicked.
    void aWireFollowsTheEdge()
    {
        QFETCH(const QString, closing);
        QFETCH(const bool, pen);
        QFETCH(const bool, slowly);
        Fixture fixture;
        fixture.tool.setShape(Shape::Livewire);
        ui::SliceView& view = fixture.views.axial();
        test::Pen stylus(view);
        const auto click = [&](const QPointF& at) {
            if (pen)
                fixture.clickWithPen(at, stylus);
            else
                Fixture::click(view, at);
            if (slowly)
                fixture.pause();
        };
        const std::vector<QPointF> corners = fixture.headCorners();
        for (const QPointF& corner : corners) {
            click(corner + QPointF(1.0, -1.0));
            QCOMPARE(fixture.rows(), std::size_t(0));
            QVERIFY(fixture.tool.canTakeStepBack());
        }
        if (closing == QLatin1String("Enter")) {
            QTest::keyClick(&view, Qt::Key_Return);
        } else if (closing == QLatin1String("first anchor")) {
            click(corners.front() + QPointF(2.0, -1.0));
        } else if (pen) {
            click(corners.back());
        } else {
            Fixture::mouse(view, QEvent::MouseButtonDblClick, corners.back());
            Fixture::mouse(view, QEvent::MouseButtonRelease, corners.back());
        }
        QVERIFY(fixture.comesToRows(2)); // a segment for it, and the outline
        QVERIFY(fixture.voxels() == Fixture::within(16));
        QVERIFY(!fixture.lastEdit().erase);
        QCOMPARE(fixture.session().history().rows().back().name.left(34),
            QStringLiteral("Fill an outline with 'Segment 1', "));
        // It is done with, and one step of undo.
        QVERIFY(!fixture.tool.canTakeStepBack());
        fixture.window.actionTable()[QStringLiteral("edit.undo")].trigger();
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.voxels().empty());
    }

    void aWireIsTakenBack_data()
    {
        QTest::addColumn<bool>("slowly");
        QTest::newRow("at once") << false;
        QTest::newRow("slowly") << true;
    }
    void aWireIsTakenBack()
    {
        QFETCH(const bool, slowly);
        Fixture fixture;
        int said = 0;
        connect(&fixture.workspace, &ui::Workspace::said, this, [&said] { ++said; });
        QAction& undo = fixture.window.actionTable()[QStringLiteral("edit.undo")];
        fixture.tool.setShape(Shape::Livewire);
        ui::SliceView& view = fixture.views.axial();
        const auto click = [&](const QPointF& at) {
            Fixture::click(view, at);
            if (slowly)
                fixture.pause();
        };
        const std::vector<QPointF> corners = fixture.headCorners();
        click(corners[0]);
        click(corners[1]);
        // From two anchors it would come back the way it went.
        Fixture::mouse(view, QEvent::MouseButtonDblClick, corners[1]);
        Fixture::mouse(view, QEvent::MouseButtonRelease, corners[1]);
        QVERIFY(fixture.tool.canTakeStepBack());
        QTest::keyClick(&view, Qt::Key_Return);
        QCOMPARE(said, 1);
        QTest::keyClick(&view, Qt::Key_Backspace);
        QVERIFY(fixture.tool.canTakeStepBack());
        QTest::keyClick(&view, Qt::Key_Backspace);
        QVERIFY(!fixture.tool.canTakeStepBack());
        QTest::keyClick(&view, Qt::Key_Backspace); // one more than there are

        for (const QPointF& corner : corners)
            click(corner);
        QTest::keyClick(&view, Qt::Key_Escape);
        QVERIFY(!fixture.tool.canTakeStepBack());
        QTest::keyClick(&view, Qt::Key_Return); // nothing is left to close
        fixture.pause();
        QCOMPARE(fixture.rows(), std::size_t(0));

        // Another slice gets no anchors of it.
        click(corners[0]);
        fixture.workspace.setCrosshairLps(fixture.place({20.0, 20.0, 24.0}));
        click(corners[1]);
        QCOMPARE(said, 2);
        fixture.workspace.setCrosshairLps(fixture.place({20.0, 20.0, 20.0}));
        click(corners[1]);
        click(fixture.pixel(view, {20.5, 20.5, 20.0})); // away from the edge
        QCOMPARE(undo.text(), QStringLiteral("Undo: last corner"));
        undo.trigger();
        if (slowly)
            fixture.pause();
        click(corners[2]);
        click(corners[3]);
        QTest::keyClick(&view, Qt::Key_Enter);
        QVERIFY(fixture.comesToRows(2));
        QVERIFY(fixture.voxels() == Fixture::within(16));
    }

    /// A wire is worth more than a drag: it stays until it is filled.
    void aWireThatCannotBeFilledStaysOpen()
    {
        Fixture fixture;
        int failures = 0;
        connect(&fixture.workspace, &ui::Workspace::failed, this, [&failures] { ++failures; });
        QVERIFY(fixture.session().apply(test::newSegment(QStringLiteral("Liver"), 0x804020)));
        QVERIFY(fixture.session().apply(test::lockSegment(1)));
        QVERIFY(fixture.session().settle());
        fixture.workspace.setActiveSegment(1);
        fixture.tool.setShape(Shape::Livewire);
        ui::SliceView& view = fixture.views.axial();
        for (const QPointF& corner : fixture.headCorners())
            Fixture::click(view, corner);
        QTest::keyClick(&view, Qt::Key_Return);
        QVERIFY(fixture.comes([&failures] { return failures == 1; }));
        QVERIFY(fixture.voxels().empty());
        QVERIFY(fixture.tool.canTakeStepBack());
        QVERIFY(fixture.session().apply(test::lockSegment(1, false)));
        QVERIFY(fixture.session().settle());
        QTest::keyClick(&view, Qt::Key_Return);
        QVERIFY(fixture.comesToRows(4));
        QCOMPARE(failures, 1);
        QVERIFY(fixture.voxels() == Fixture::within(16));
    }

    void aLevelIsTraced_data()
    {
        QTest::addColumn<int>("column");
        QTest::addColumn<int>("radius");
        QTest::addColumn<bool>("pen");
        for (const bool pen : {false, true}) {
            QTest::addRow("ventricle, %s", pen ? "pen" : "mouse") << 22 << 5 << pen;
            QTest::addRow("brain, %s", pen ? "pen" : "mouse") << 28 << 13 << pen;
            QTest::addRow("bone, %s", pen ? "pen" : "mouse") << 34 << 16 << pen;
        }
    }
    /// A click on a value of the small head fills what is enclosed by it.
    void aLevelIsTraced()
    {
        QFETCH(const int, column);
        QFETCH(const int, radius);
        QFETCH(const bool, pen);
        Fixture fixture;
        fixture.tool.setShape(Shape::Level);
        ui::SliceView& view = fixture.views.axial();
        const QPointF at = fixture.pixel(view, {column + 0.2, 20.3, 20.0});
        if (pen) {
            test::Pen stylus(view);
            fixture.clickWithPen(at, stylus);
        } else {
            // Over other values first.
            Fixture::hover(view, fixture.pixel(view, {1.0, 1.0, 20.0}));
            Fixture::hover(view, fixture.pixel(view, {20.0, 20.0, 20.0}));
            Fixture::click(view, at);
        }
        // Where the pointer goes before the contour is known does not matter.
        Fixture::hover(view, fixture.pixel(view, {34.0, 20.0, 20.0}));
        QVERIFY(fixture.comesToRows(2));
        QVERIFY(fixture.voxels() == Fixture::within(radius));
        QVERIFY(!fixture.tool.canTakeStepBack());
        fixture.window.actionTable()[QStringLiteral("edit.undo")].trigger();
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.voxels().empty());
    }

    void controlAndTheEraserEndEraseALevel()
    {
        Fixture fixture;
        fixture.tool.setShape(Shape::Level);
        ui::SliceView& view = fixture.views.axial();
        Fixture::click(view, fixture.pixel(view, {34.0, 20.0, 20.0}));
        QVERIFY(fixture.comesToRows(2));
        Voxels expected = Fixture::within(16);
        QVERIFY(fixture.voxels() == expected);

        Fixture::click(view, fixture.pixel(view, {21.0, 20.0, 20.0}), Qt::ControlModifier);
        QVERIFY(fixture.comesToRows(3));
        for (const auto& voxel : Fixture::within(5))
            expected.erase(voxel);
        QVERIFY(fixture.voxels() == expected);
        QVERIFY(fixture.lastEdit().erase);

        test::Pen eraser(view, test::Pen::End::Eraser);
        fixture.clickWithPen(fixture.pixel(view, {28.0, 20.0, 20.0}), eraser);
        QVERIFY(fixture.comesToRows(4));
        for (const auto& voxel : Fixture::within(13))
            expected.erase(voxel);
        QVERIFY(!expected.empty() && fixture.voxels() == expected);
        QVERIFY(fixture.session().history().rows().back().name.startsWith(
            QStringLiteral("Erase 'Segment 1' in an outline, ")));
    }

    /// Its pixels show the nearest voxels, so that the ventricle is found to within one of them.
    void aLevelOnAnObliqueSlice()
    {
        Fixture fixture;
        fixture.tool.setShape(Shape::Level);
        fixture.workspace.plane().setPose(ui::CuttingPlane::poseFacing(
            fixture.place({20.2, 19.7, 20.4}), glm::normalize(glm::dvec3(0.3, 0.5, 1.0))));
        fixture.views.arrange(ui::ViewGrid::Layout::PenAndStage);
        ui::PlaneView& view = fixture.views.plane();
        QTRY_VERIFY(view.isVisible() && view.width() > 100 && view.height() > 100);
        QCoreApplication::processEvents();
        const ui::CuttingPlane::Pose pose = fixture.workspace.plane().pose();
        const glm::dvec3 normal = pose.normalLps();
        Fixture::click(view, view.context().toPixel(pose.centreLps + 0.5 * pose.rightLps));
        QVERIFY(fixture.comesToRows(2));
        const core::VolumeGeometry& geometry = fixture.workspace.volume()->geometry;
        double halfMm = 0.0;
        for (int axis = 0; axis < 3; ++axis)
            halfMm = std::max(
                halfMm, std::abs(glm::dot(normal, glm::dvec3(geometry.indexToWorld[axis]))) / 2.0);
        // From a voxel to its foot in the plane, to the centre of the pixel, and to its voxel.
        const double unsureMm = halfMm + std::sqrt(0.5) + std::sqrt(0.25 + 0.25 + 0.5625);
        const Voxels filled = fixture.voxels();
        int inside = 0;
        for (int z = 0; z < geometry.size.z; ++z) {
            for (int y = 0; y < geometry.size.y; ++y) {
                for (int x = 0; x < geometry.size.x; ++x) {
                    const glm::dvec3 place = geometry.toWorld(glm::dvec3(x, y, z));
                    const double fromMiddle = glm::distance(place, fixture.place(glm::dvec3(20.0)));
                    const double across = std::abs(glm::dot(place - pose.centreLps, normal));
                    if (filled.count({x, y, z}) == 1) {
                        QVERIFY(fromMiddle < 5.0 + unsureMm && across < halfMm + 0.005);
                        ++inside;
                    } else if (across < halfMm - 0.005) {
                        QVERIFY(fromMiddle > 5.0 - unsureMm);
                    }
                }
            }
        }
        QVERIFY(inside > 30);
    }

    void optionsAreKept()
    {
        Fixture fixture;
        auto* shapes = fixture.window.findChild<QComboBox*>(QStringLiteral("outlineShape"));
        QVERIFY(shapes);
        QCOMPARE(shapes->count(), 6);
        shapes->setCurrentIndex(2);
        Q_EMIT shapes->activated(2);
        QVERIFY(fixture.tool.shape() == Shape::Rectangle);
        ui::FillOutlineTool other(fixture.workspace);
        other.applySettings(fixture.tool.settingsJson());
        QVERIFY(other.shape() == Shape::Rectangle);
        other.applySettings({{QStringLiteral("shape"), 6}});
        QVERIFY(other.shape() == Shape::Rectangle);
        // What may change is set as for painting.
        fixture.workspace.setBrushSettings(ui::Workspace::Brush::Paint,
            {.onlyBetween = true, .lower = 500.0, .upper = 0.0, .overwriteUnlocked = true});
        const std::vector<QPointF> corners = fixture.square();
        fixture.drag(fixture.views.axial(), {corners[0], corners[2]}, false);
        QCOMPARE(*fixture.lastEdit().lower, 0.0);
        QCOMPARE(*fixture.lastEdit().upper, 500.0);
        QVERIFY(fixture.lastEdit().overwriteUnlocked);
    }

    void whatCannotBeFilledSaysWhy()
    {
        Fixture fixture;
        int failures = 0;
        connect(&fixture.workspace, &ui::Workspace::failed, this, [&failures] { ++failures; });
        QVERIFY(fixture.session().apply(test::newSegment(QStringLiteral("Liver"), 0x804020)));
        QVERIFY(fixture.session().apply(test::lockSegment(1)));
        QVERIFY(fixture.session().settle());
        fixture.workspace.setActiveSegment(1);
        QCOMPARE(fixture.tool.target(), QStringLiteral("Liver is locked"));
        fixture.drag(fixture.views.axial(), fixture.ring(), true);
        QCOMPARE(failures, 1);
        QVERIFY(fixture.voxels().empty());
        QCOMPARE(fixture.rows(), std::size_t(2));
    }

    /// A polygon is worth more than a drag: it stays until it is filled.
    void aPolygonThatCannotBeFilledStaysOpen()
    {
        Fixture fixture;
        int failures = 0;
        int said = 0;
        connect(&fixture.workspace, &ui::Workspace::failed, this, [&failures] { ++failures; });
        connect(&fixture.workspace, &ui::Workspace::said, this, [&said] { ++said; });
        QVERIFY(fixture.session().apply(test::newSegment(QStringLiteral("Liver"), 0x804020)));
        QVERIFY(fixture.session().apply(test::lockSegment(1)));
        QVERIFY(fixture.session().settle());
        fixture.workspace.setActiveSegment(1);
        fixture.tool.setShape(Shape::Polygon);
        ui::SliceView& view = fixture.views.axial();
        const std::vector<QPointF> corners = fixture.square();
        // Two corners are no polygon, but may become one.
        Fixture::click(view, corners[0]);
        Fixture::click(view, corners[1]);
        QTest::keyClick(&view, Qt::Key_Return);
        QCOMPARE(said, 1);
        Fixture::click(view, corners[2]);
        Fixture::click(view, corners[3]);
        QTest::keyClick(&view, Qt::Key_Return);
        QCOMPARE(failures, 1);
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.voxels().empty());
        QCOMPARE(fixture.rows(), std::size_t(2));
        QVERIFY(fixture.session().apply(test::lockSegment(1, false)));
        QVERIFY(fixture.session().settle());
        QTest::keyClick(&view, Qt::Key_Return);
        QVERIFY(fixture.session().settle());
        QCOMPARE(failures, 1);
        QVERIFY(fixture.voxels() == Fixture::squareVoxels());
        QCOMPARE(fixture.rows(), std::size_t(4));
        // Now it is done with.
        QVERIFY(!fixture.tool.canTakeStepBack());
        QTest::keyClick(&view, Qt::Key_Return);
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.rows(), std::size_t(4));
    }

    /// Undo takes the corners back one by one, and a step of the history only after them.
    void undoTakesACornerBack()
    {
        Fixture fixture;
        QAction& undo = fixture.window.actionTable()[QStringLiteral("edit.undo")];
        fixture.tool.setShape(Shape::Polygon);
        ui::SliceView& view = fixture.views.axial();
        const std::vector<QPointF> corners = fixture.square();
        // There is no history yet.
        QVERIFY(!undo.isEnabled());
        Fixture::click(view, corners[0]);
        QVERIFY(undo.isEnabled());
        undo.trigger();
        QVERIFY(!fixture.tool.canTakeStepBack());
        QVERIFY(!undo.isEnabled());

        QVERIFY(fixture.session().apply(test::newSegment(QStringLiteral("Liver"), 0x804020)));
        QVERIFY(fixture.session().settle());
        fixture.workspace.setActiveSegment(1);
        const core::RowId row = fixture.session().history().position();
        for (const QPointF& corner : corners)
            Fixture::click(view, corner);
        Fixture::click(view, fixture.pixel(view, {30.0, 35.0, 20.0}));
        QCOMPARE(undo.text(), QStringLiteral("Undo: last corner"));
        undo.trigger();
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().history().position(), row);
        QTest::keyClick(&view, Qt::Key_Return);
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.voxels() == Fixture::squareVoxels());
        QCOMPARE(fixture.rows(), std::size_t(2));
        // Closed, it is a step as any other.
        QVERIFY(undo.text() != QStringLiteral("Undo: last corner"));
        undo.trigger();
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().history().position(), row);
        QVERIFY(fixture.voxels().empty());
        // Of all corners nothing is left, and the segment is still there.
        for (const QPointF& corner : corners)
            Fixture::click(view, corner);
        for (std::size_t i = 0; i < corners.size(); ++i)
            undo.trigger();
        QVERIFY(!fixture.tool.canTakeStepBack());
        QVERIFY(fixture.session().settle());
        QCOMPARE(fixture.session().history().position(), row);
        undo.trigger();
        QVERIFY(fixture.session().settle());
        QVERIFY(fixture.session().document().segments.empty());
    }
};

BURIN_WINDOW_TEST(FillOutlineToolUiTest)

} // namespace fillOutlineToolUiTest

#include "FillOutlineToolUiTest.moc"
