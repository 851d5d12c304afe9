// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "ui/tools/view/CuttingPlaneTool.h"
#include "ui/views/ViewGrid.h"

#include <QApplication>
#include <QCheckBox>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QSlider>
#include <QToolButton>
#include <QtTest>

#include <cmath>
#include <memory>

namespace cuttingPlaneToolUiTest {

namespace {

bool isNear(const glm::dvec3& a, const glm::dvec3& b, double within = 1e-9)
{
    return glm::distance(a, b) <= within;
}

bool atRightAngles(const ui::CuttingPlane::Pose& pose)
{
    return std::abs(glm::dot(pose.rightLps, pose.downLps)) < 1e-12
        && std::abs(glm::length(pose.rightLps) - 1.0) < 1e-12
        && std::abs(glm::length(pose.downLps) - 1.0) < 1e-12;
}

/// A vessel of 3 mm radius, brighter than what is around it, along a direction through the middle.
core::LoadedVolume vesselAlong(const glm::dvec3& directionLps)
{
    core::LoadedVolume loaded = test::smallHead::volume();
    const core::VolumeGeometry& geometry = loaded.volume.geometry;
    const glm::dvec3 along = glm::normalize(directionLps);
    std::size_t at = 0;
    for (int z = 0; z < geometry.size.z; ++z) {
        for (int y = 0; y < geometry.size.y; ++y) {
            for (int x = 0; x < geometry.size.x; ++x) {
                const glm::dvec3 lps = geometry.toWorld(glm::dvec3(x, y, z));
                const double apart = glm::length(lps - glm::dot(lps, along) * along);
                loaded.codes[at++] = std::uint16_t(1000.0 + 400.0 / (1.0 + std::exp(apart - 3.0)));
            }
        }
    }
    return loaded;
}

/// The small head with the tool in hand, seen from the front and a little from above.
class PlaneFixture : public test::WindowFixture {
public:
    explicit PlaneFixture(core::LoadedVolume volume = test::smallHead::volume())
        : test::WindowFixture(std::move(volume))
        , tool(workspace)
        , plane(workspace.plane())
        , views(window.views())
        , options(tool.createOptions(&window))
    {
        workspace.setActiveTool(&tool);
        views.volume().lookFrom(glm::normalize(glm::dvec3(0.2, -1.0, 0.5)));
    }
    [[nodiscard]] ui::PlaneHandle handle(const ui::ImageView& in, int id) const
    {
        for (const ui::PlaneHandle& each : ui::planeHandles(in.context(), plane)) {
            if (each.id == id)
                return each;
        }
        qFatal("no handle");
    }
    void drag(ui::ImageView& in, const QPointF& from, const QPointF& to,
        Qt::KeyboardModifiers modifiers = {}, bool lift = true)
    {
        const auto post = [&](QEvent::Type type, const QPointF& at, Qt::MouseButton button,
                              Qt::MouseButtons buttons) {
            QMouseEvent event(type, at, in.mapToGlobal(at), button, buttons, modifiers);
            QApplication::sendEvent(&in, &event);
        };
        post(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
        for (int i = 1; i <= 10; ++i)
            post(QEvent::MouseMove, from + (to - from) * (0.1 * i), Qt::NoButton, Qt::LeftButton);
        if (lift)
            post(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
    }
    template <class Widget> [[nodiscard]] Widget& part(const char* name) const
    {
        auto* found = options->findChild<Widget*>(QLatin1String(name));
        if (!found)
            qFatal("no %s", name);
        return *found;
    }
    void clickAt(ui::ImageView& in, const glm::dvec3& lps)
    {
        test::Pen pen(in);
        const QPointF at = in.context().toPixel(lps);
        pen.press(at, 1.0, 3000);
        pen.release(at, 3010);
    }

    ui::CuttingPlaneTool tool;
    ui::CuttingPlane& plane;
    ui::ViewGrid& views;
    QWidget* options;
};

} // namespace

/// The cutting plane: where it is put, and who shows it.
class CuttingPlaneToolUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void takingTheToolShowsThePlane()
    {
        test::WindowFixture fixture(test::smallHead::volume());
        ui::CuttingPlaneTool tool(fixture.workspace);
        QVERIFY(!fixture.workspace.plane().look().shown);
        QVERIFY(!std::get<gpu::VolumeScene>(fixture.window.views().volume().context().scene).plane);
        fixture.workspace.setActiveTool(&tool);
        QVERIFY(fixture.workspace.plane().look().shown);
        const auto scene =
            std::get<gpu::VolumeScene>(fixture.window.views().volume().context().scene);
        QVERIFY(scene.plane);
        // As large as what it cuts: 40 voxels of 1 mm each way.
        QVERIFY(std::abs(scene.plane->halfSizeMm.x - 20.0) < 1e-9);
        QVERIFY(std::abs(scene.plane->halfSizeMm.y - 20.0) < 1e-9);
    }

    void theSquareHandleMovesIt()
    {
        PlaneFixture fixture;
        for (ui::ImageView* view : {static_cast<ui::ImageView*>(&fixture.views.coronal()),
                 static_cast<ui::ImageView*>(&fixture.views.volume())}) {
            const ui::CuttingPlane::Pose before = fixture.plane.pose();
            const ui::PlaneHandle handle = fixture.handle(*view, 0);
            fixture.drag(*view, handle.pixel, handle.pixel + handle.pixelsPerUnit * 7.0);
            QVERIFY(isNear(
                fixture.plane.pose().centreLps, before.centreLps + 7.0 * before.normalLps(), 1e-6));
            QVERIFY(fixture.plane.pose().rightLps == before.rightLps);
        }
    }

    void roundHandlesTurnItWithThePointer()
    {
        PlaneFixture fixture;
        ui::SliceView& coronal = fixture.views.coronal();
        const glm::dvec3 centre = fixture.plane.pose().centreLps;
        const QPointF middle = coronal.context().toPixel(centre);
        const ui::PlaneHandle handle = fixture.handle(coronal, 2);
        // A quarter of a turn less a little, round the middle.
        test::Pen pen(coronal);
        pen.press(handle.pixel, 1.0, 1000);
        const QPointF arm = handle.pixel - middle;
        constexpr double degrees = 60.0;
        for (int i = 1; i <= 30; ++i) {
            const double angle = glm::radians(degrees * i / 30.0);
            pen.move(middle
                    + QPointF(arm.x() * std::cos(angle) - arm.y() * std::sin(angle),
                        arm.x() * std::sin(angle) + arm.y() * std::cos(angle)),
                1.0, quint64(1000 + 10 * i));
        }
        pen.release({}, 2000);
        const glm::dvec3 normal = fixture.plane.pose().normalLps();
        const double turned = glm::degrees(std::acos(std::abs(normal.z)));
        QVERIFY2(std::abs(turned - degrees) < 3.0, qPrintable(QString::number(turned)));
        QVERIFY(std::abs(normal.y) < 1e-9);
        QVERIFY(atRightAngles(fixture.plane.pose()));
        QVERIFY(fixture.plane.pose().centreLps == centre);

        // In the 3D view the place that is held goes with the pointer.
        const ui::CuttingPlane::Pose before = fixture.plane.pose();
        const ui::PlaneHandle inSpace = fixture.handle(fixture.views.volume(), 3);
        fixture.drag(
            fixture.views.volume(), inSpace.pixel, inSpace.pixel + inSpace.pixelsPerUnit * 0.2);
        const double moved =
            glm::degrees(std::acos(glm::dot(before.normalLps(), fixture.plane.pose().normalLps())));
        QVERIFY2(std::abs(moved - glm::degrees(0.2)) < 1.5, qPrintable(QString::number(moved)));
        QVERIFY(atRightAngles(fixture.plane.pose()));
    }

    void besideTheHandlesTheViewTurns()
    {
        PlaneFixture fixture;
        const ui::CuttingPlane::Pose before = fixture.plane.pose();
        const glm::dvec3 from = fixture.views.volume().camera().towardsViewer;
        fixture.drag(fixture.views.volume(), {30.0, 30.0}, {90.0, 30.0});
        QVERIFY(fixture.plane.pose() == before);
        QVERIFY(fixture.views.volume().camera().towardsViewer != from);
    }

    void escapeLetsGo()
    {
        PlaneFixture fixture;
        const ui::CuttingPlane::Pose before = fixture.plane.pose();
        const ui::PlaneHandle handle = fixture.handle(fixture.views.coronal(), 0);
        fixture.drag(fixture.views.coronal(), handle.pixel,
            handle.pixel + handle.pixelsPerUnit * 5.0, {}, false);
        QVERIFY(fixture.plane.pose() != before);
        QTest::keyClick(&fixture.views.coronal(), Qt::Key_Escape);
        QVERIFY(fixture.plane.pose() == before);
    }

    void thePenViewShowsItAndTurnsIt()
    {
        PlaneFixture fixture;
        fixture.views.arrange(ui::ViewGrid::Layout::PenAndStage);
        ui::PlaneView& pen = fixture.views.plane();
        QVERIFY(pen.isVisible() && fixture.views.volume().isVisible());
        QVERIFY(!fixture.views.axial().isVisible() && !fixture.views.coronal().isVisible());
        QTRY_VERIFY(std::abs(pen.width() - fixture.views.volume().width()) <= 2);
        const auto scene = [&] { return std::get<gpu::SliceScene>(pen.context().scene); };
        QVERIFY(scene().interpolation == gpu::Interpolation::Cubic);
        QVERIFY(std::get<gpu::SliceScene>(fixture.views.axial().context().scene).interpolation
            == gpu::Interpolation::Linear);
        QVERIFY(isNear(scene().rightLps, fixture.plane.pose().rightLps));

        const QPointF middle = pen.rect().toRectF().center();
        fixture.drag(pen, middle, middle + QPointF(50.0, 0.0));
        const glm::dvec3 normal = fixture.plane.pose().normalLps();
        QVERIFY(std::abs(glm::degrees(std::acos(normal.z)) - 20.0) < 1e-6);
        QVERIFY(isNear(glm::cross(scene().rightLps, scene().downLps), normal));
        // Within itself by Ctrl: what is seen goes with the pointer.
        const glm::dvec3 held = pen.context().toLps(middle + QPointF(100.0, 0.0));
        fixture.drag(
            pen, middle + QPointF(100.0, 0.0), middle + QPointF(98.0, 20.0), Qt::ControlModifier);
        QVERIFY(isNear(fixture.plane.pose().normalLps(), normal, 1e-9));
        const QPointF now = pen.context().toPixel(held);
        QVERIFY2(std::hypot(now.x() - middle.x() - 98.0, now.y() - middle.y() - 20.0) < 3.0,
            qPrintable(
                QStringLiteral("%1 %2").arg(now.x() - middle.x()).arg(now.y() - middle.y())));
        // The wheel goes along its normal, a step that the voxels have.
        const glm::dvec3 before = fixture.plane.pose().centreLps;
        pen.goToSlice(pen.sliceNumber() + 2);
        const glm::dvec3 way = fixture.plane.pose().centreLps - before;
        QVERIFY(glm::length(way) > 1.0);
        QVERIFY(glm::length(way - glm::dot(way, normal) * normal) < 1e-9);
    }

    void thePenViewStandsInAWindowOfItsOwn()
    {
        PlaneFixture fixture;
        fixture.views.setPenApart(true);
        ui::PlaneView& pen = fixture.views.plane();
        QVERIFY(pen.isVisible() && pen.window() != &fixture.window);
        QVERIFY(fixture.views.axial().isVisible() && fixture.views.coronal().isVisible());
        // It is one of the views all the same: it gets pictures.
        QTRY_VERIFY(pen.quality().has_value());
        pen.window()->close();
        QVERIFY(!fixture.views.isPenApart());
        QCOMPARE(pen.window(), static_cast<QWidget*>(&fixture.window));
        QVERIFY(!pen.isVisible());
        fixture.views.arrange(ui::ViewGrid::Layout::PenAndStage);
        QVERIFY(pen.isVisible());
        fixture.views.setPenApart(true);
        QVERIFY(pen.isVisible() && fixture.views.volume().isVisible());
        fixture.views.setPenApart(false);
        QVERIFY(pen.isVisible());
        fixture.views.arrange(ui::ViewGrid::Layout::Four);
        QVERIFY(!pen.isVisible() && fixture.views.axial().isVisible());
    }

    void threePointsMakeAPlane()
    {
        PlaneFixture fixture;
        fixture.part<QToolButton>("planeThreePoints").click();
        QCOMPARE(fixture.tool.aim(), ui::CuttingPlaneTool::Aim::ThreePoints);
        const glm::dvec3 a(8.0, 0.0, 3.0);
        const glm::dvec3 b(-8.0, 0.0, -3.0);
        const glm::dvec3 c(0.0, 9.0, 2.0);
        fixture.workspace.setCrosshairLps(glm::dvec3(0.0));
        fixture.clickAt(fixture.views.coronal(), a);
        fixture.clickAt(fixture.views.coronal(), b);
        QCOMPARE(fixture.tool.aim(), ui::CuttingPlaneTool::Aim::ThreePoints);
        fixture.clickAt(fixture.views.sagittal(), c);
        QCOMPARE(fixture.tool.aim(), ui::CuttingPlaneTool::Aim::Handles);
        QVERIFY(!fixture.part<QToolButton>("planeThreePoints").isChecked());
        for (const glm::dvec3& point : {a, b, c})
            QVERIFY(std::abs(glm::dot(
                        point - fixture.plane.pose().centreLps, fixture.plane.pose().normalLps()))
                < 1e-9);
        QVERIFY(atRightAngles(fixture.plane.pose()));
        // Seen from the side it was seen from.
        QVERIFY(fixture.plane.pose().normalLps().z > 0.0);

        // On a line there is none.
        const ui::CuttingPlane::Pose before = fixture.plane.pose();
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        fixture.tool.setAim(ui::CuttingPlaneTool::Aim::ThreePoints);
        for (const double x : {-5.0, 0.0, 5.0})
            fixture.clickAt(fixture.views.coronal(), {x, 0.0, x});
        QVERIFY(fixture.plane.pose() == before);
        QVERIFY(said.last().first().toString().contains(QStringLiteral("on a line")));
    }

    void acrossAVessel()
    {
        const glm::dvec3 along = glm::normalize(glm::dvec3(1.0, 1.0, 2.0));
        PlaneFixture fixture(vesselAlong(along));
        fixture.part<QToolButton>("planeAcross").click();
        fixture.clickAt(fixture.views.axial(), {0.3, -0.2, 0.0});
        QCOMPARE(fixture.tool.aim(), ui::CuttingPlaneTool::Aim::Handles);
        QVERIFY(fixture.workspace.session()->settle());
        QVERIFY(std::abs(glm::dot(fixture.plane.pose().normalLps(), along)) > 0.995);
        QVERIFY(isNear(fixture.plane.pose().centreLps, {0.3, -0.2, 0.0}, 0.8));
        // The normal keeps its sense.
        QVERIFY(fixture.plane.pose().normalLps().z > 0.0);
    }

    void uprightOnASurface()
    {
        PlaneFixture fixture;
        fixture.tool.setAim(ui::CuttingPlaneTool::Aim::Across);
        // The outside of the skull, from the front.
        fixture.clickAt(fixture.views.axial(), {0.0, -16.0, 0.0});
        const glm::dvec3 outwards(0.0, -1.0, 0.0);
        QVERIFY(fixture.workspace.session()->settle());
        QVERIFY(isNear(fixture.plane.pose().centreLps, {0.0, -16.0, 0.0}, 0.8));
        QVERIFY2(std::abs(glm::dot(fixture.plane.pose().normalLps(), outwards)) < 0.05,
            qPrintable(QString::number(fixture.plane.pose().normalLps().y)));
        // Nothing runs in the air.
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        fixture.tool.setAim(ui::CuttingPlaneTool::Aim::Across);
        fixture.views.axial().goToSlice(3);
        const ui::CuttingPlane::Pose before = fixture.plane.pose();
        fixture.clickAt(fixture.views.axial(),
            fixture.views.axial().context().toLps(
                fixture.views.axial().context().toPixel({-16.0, -16.0, 0.0})));
        QVERIFY(fixture.workspace.session()->settle());
        QVERIFY(!said.isEmpty());
        QVERIFY(fixture.plane.pose() == before);
    }

    void whatLiesAboveIsClipped()
    {
        PlaneFixture fixture;
        const auto scene = [&] {
            return std::get<gpu::VolumeScene>(fixture.views.volume().context().scene);
        };
        QVERIFY(!scene().clip.any());
        fixture.part<QCheckBox>("planeClips").setChecked(true);
        QVERIFY(scene().clip.any());
        // Axial slices are looked at from the feet.
        const core::ClipPlane clip = scene().clip.planes.front();
        QVERIFY(clip.on && isNear(clip.normalLps, {0.0, 0.0, -1.0}));
        fixture.part<QToolButton>("planeFlip").click();
        QVERIFY(isNear(scene().clip.planes.front().normalLps, {0.0, 0.0, 1.0}));
        // It is no clip plane of the user's.
        QVERIFY(!fixture.workspace.clip().any());
        fixture.part<QSlider>("planeOpacity").setValue(40);
        QVERIFY(std::abs(scene().plane->opacity - 0.4f) < 1e-6f);
    }

    void posesAreUpright()
    {
        for (const glm::dvec3& towards : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0),
                 glm::dvec3(0, 0, 1), glm::dvec3(-1, 2, 0.5), glm::dvec3(0.1, 0.1, -1)}) {
            const auto pose = ui::CuttingPlane::poseFacing(glm::dvec3(1.0), towards);
            QVERIFY(atRightAngles(pose));
            QVERIFY(isNear(pose.normalLps(), glm::normalize(towards), 1e-12));
            // Feet or back towards the bottom.
            QVERIFY(pose.downLps.z < 1e-12 || pose.downLps.y > 0.0);
        }
        // Axial as axial slices are.
        const auto axial = ui::CuttingPlane::poseFacing(glm::dvec3(0.0), {0.0, 0.0, 1.0});
        QVERIFY(isNear(axial.rightLps, {1.0, 0.0, 0.0}) && isNear(axial.downLps, {0.0, 1.0, 0.0}));
    }
};

BURIN_WINDOW_TEST(CuttingPlaneToolUiTest)

} // namespace cuttingPlaneToolUiTest

#include "CuttingPlaneToolUiTest.moc"
