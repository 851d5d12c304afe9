// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/growth/SeedStroke.h"
#include "tests/support/fixtures/Pen.h"
#include "tests/support/fixtures/PointerStroke.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "ui/frame/PanelSection.h"
#include "ui/panels/ClippingPanel.h"
#include "ui/tools/growth/SeedTool.h"
#include "ui/tools/view/ClipTool.h"
#include "ui/views/ViewGrid.h"
#include "ui/widgets/RangeSlider.h"

#include <QCheckBox>
#include <QComboBox>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include <cmath>

namespace clippingUiTest {

namespace {

/// The small head, the panel unfolded and the tool in hand, seen from the front.
class ClippingFixture : public test::WindowFixture {
public:
    ClippingFixture()
        : test::WindowFixture(test::smallHead::volume())
        , tool(workspace)
        , view(window.views().volume())
        , panel(new ui::ClippingPanel(workspace, view))
    {
        window.addPanel(panel);
        window.showPanels(true);
        window.findChild<ui::PanelSection*>(QStringLiteral("ClippingPanel"))->setFolded(false);
        workspace.setActiveTool(&tool);
        ui::Workspace::VolumeDisplay display = workspace.volumeDisplay();
        display.surfaceThreshold = 300.0;
        workspace.setVolumeDisplay(display);
        view.lookFrom({0.0, -1.0, 0.0});
        QCoreApplication::sendPostedEvents(); // layouts and frames are posted events
    }
    template <class Widget> [[nodiscard]] Widget& part(const char* name) const
    {
        auto* found = panel->findChild<Widget*>(QLatin1String(name));
        if (!found)
            qFatal("no %s", name);
        return *found;
    }
    [[nodiscard]] const core::VolumeGeometry& geometry() const
    {
        return workspace.volume()->geometry;
    }
    [[nodiscard]] ui::ClipHandle handle(const ui::ImageView& in, int face) const
    {
        for (const ui::ClipHandle& each :
            ui::clipHandles(in.context(), workspace.clip(), geometry())) {
            if (each.face == face)
                return each;
        }
        qFatal("no handle");
    }
    /// Drags a handle outwards, in millimetres, and keeps holding.
    void pull(test::Pen& pen, const ui::ImageView& in, int face, double mm)
    {
        const ui::ClipHandle from = handle(in, face);
        pen.press(from.pixel, 1.0, 1000);
        pen.move(from.pixel + from.pixelsPerMm * mm * 0.4, 1.0, 1010);
        pen.move(from.pixel + from.pixelsPerMm * mm, 1.0, 1020);
    }
    [[nodiscard]] std::vector<std::optional<glm::ivec3>> seedsAt(const QPointF& pixel)
    {
        ui::SeedTool seeds(workspace);
        workspace.setActiveTool(&seeds);
        const std::size_t before = workspace.session()->history().rows().size();
        test::Pen pen(view);
        pen.press(pixel, 1.0, 5000);
        pen.release(pixel, 5010);
        std::vector<std::optional<glm::ivec3>> found;
        if (!workspace.session()->settle())
            qFatal("not settled");
        for (std::size_t i = before; i < workspace.session()->history().rows().size(); ++i) {
            const auto* stroke =
                workspace.session()->history().rows()[i].edit.as<core::SeedStroke>();
            for (std::size_t k = 0; stroke && k < stroke->pointsLps.size(); ++k)
                found.push_back(glm::ivec3(glm::round(geometry().toIndex(stroke->pointsLps[k]))));
        }
        workspace.setActiveTool(&tool);
        return found;
    }

    ui::ClipTool tool;
    ui::VolumeView& view;
    ui::ClippingPanel* panel;
};

bool isNear(double a, double b, double within)
{
    return std::abs(a - b) <= within;
}

} // namespace

class ClippingUiTest : public QObject {
    Q_OBJECT

    static void save(ui::MainWindow& window, const char* name)
    {
        const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS");
        if (!folder.isEmpty())
            window.grab().save(folder + QLatin1String(name));
    }

private Q_SLOTS:
    /// In the 3D view and in slices a face follows the pen by the millimetres that it moves.
    void facesFollowThePen()
    {
        ClippingFixture fixture;
        const core::ClipRegion whole = fixture.workspace.clip();
        const std::size_t rows = fixture.workspace.session()->history().rows().size();
        {
            test::Pen pen(fixture.view);
            fixture.pull(pen, fixture.view, 1, -9.0);
            QVERIFY(fixture.workspace.clip().box.on);
            QVERIFY(isNear(fixture.workspace.clip().box.maximum.x, 39.5 - 9.0, 0.02));
            pen.release({}, 1030);
        }
        {
            ui::SliceView& axial = fixture.window.views().axial();
            test::Pen pen(axial);
            fixture.pull(pen, axial, 2, -5.0);
            pen.release({}, 1030);
            QVERIFY(isNear(fixture.workspace.clip().box.minimum.y, -0.5 + 5.0, 0.02));
        }
        {
            // 1.5 mm a voxel; and no further than the volume.
            ui::SliceView& coronal = fixture.window.views().coronal();
            test::Pen pen(coronal);
            fixture.pull(pen, coronal, 5, -12.0);
            pen.release({}, 1030);
            QVERIFY(isNear(fixture.workspace.clip().box.maximum.z, 39.5 - 8.0, 0.02));
            fixture.pull(pen, coronal, 5, 40.0);
            QCOMPARE(fixture.workspace.clip().box.maximum.z, 39.5);
            pen.release({}, 1030);
            // Nor past the face across.
            fixture.pull(pen, coronal, 5, -200.0);
            QCOMPARE(fixture.workspace.clip().box.maximum.z, 0.5);
            fixture.tool.cancel();
            QCOMPARE(fixture.workspace.clip().box.maximum.z, 39.5);
        }
        QVERIFY(fixture.workspace.clip() != whole);
        QCOMPARE(fixture.workspace.session()->history().rows().size(), rows);
        const auto shown = std::get<gpu::VolumeScene>(fixture.view.context().scene);
        QVERIFY(shown.clip == fixture.workspace.clip());
        save(fixture.window, "/clipping.png");
    }

    void handlesAreDragged_data() { test::addMouseAndPen(); }
    void handlesAreDragged()
    {
        QFETCH(const test::DrawnBy, by);
        ClippingFixture fixture;
        const auto dragInwards = [&](ui::ImageView& in, int face, double mm) {
            const ui::ClipHandle from = fixture.handle(in, face);
            const QPointF way = from.pixelsPerMm * -mm;
            test::drawStroke(by, in, {from.pixel, from.pixel + way * 0.4, from.pixel + way});
        };
        dragInwards(fixture.view, 1, 9.0);
        QVERIFY(fixture.workspace.clip().box.on);
        QVERIFY(isNear(fixture.workspace.clip().box.maximum.x, 39.5 - 9.0, 0.02));
        dragInwards(fixture.window.views().axial(), 2, 5.0);
        QVERIFY(isNear(fixture.workspace.clip().box.minimum.y, -0.5 + 5.0, 0.02));
        QVERIFY(isNear(fixture.workspace.clip().box.maximum.x, 39.5 - 9.0, 0.02));
    }

    /// Beside the handles the tool leaves the view to itself.
    void besideTheHandlesTheViewTurns()
    {
        ClippingFixture fixture;
        const glm::dvec3 before = fixture.view.camera().towardsViewer;
        const core::ClipRegion clip = fixture.workspace.clip();
        const QPointF beside(24.0, fixture.view.height() / 2.0 + 60.0);
        test::Pen pen(fixture.view);
        pen.press(beside, 1.0, 100);
        pen.move(beside + QPointF(40.0, 0.0), 1.0, 110);
        pen.release(beside + QPointF(40.0, 0.0), 120);
        QVERIFY(glm::length(fixture.view.camera().towardsViewer - before) > 0.1);
        QVERIFY(fixture.workspace.clip() == clip);
    }

    void planesArePlacedFlippedAndMoved()
    {
        ClippingFixture fixture;
        fixture.workspace.setCrosshairLps({4.0, -3.0, 6.0});
        fixture.view.lookFrom(glm::normalize(glm::dvec3(1.0, -1.0, 0.0)));
        fixture.part<QCheckBox>("clipPlane0").click();
        const auto plane = [&] { return fixture.workspace.clip().planes[0]; };
        QVERIFY(plane().on);
        QVERIFY(plane().pointLps == glm::dvec3(4.0, -3.0, 6.0));
        const glm::dvec3 normal = plane().normalLps;
        QVERIFY(glm::length(normal - fixture.view.camera().towardsViewer) < 1e-9);
        // The slider moves it along its normal.
        auto& offset = fixture.part<QSlider>("clipOffset0");
        offset.setValue(offset.value() - 35);
        const glm::dvec3 moved = plane().pointLps - glm::dvec3(4.0, -3.0, 6.0);
        QVERIFY(isNear(glm::dot(moved, normal), -3.5, 0.06));
        QVERIFY(glm::length(moved - glm::dot(moved, normal) * normal) < 1e-9);
        fixture.part<QToolButton>("clipFlip0").click();
        QVERIFY(plane().normalLps == -normal);
        fixture.view.lookFrom({0.0, 0.0, 1.0});
        fixture.part<QToolButton>("clipLook0").click();
        QVERIFY(glm::length(fixture.view.camera().towardsViewer + normal) < 1e-9);
        fixture.view.lookFrom({0.0, -1.0, 0.0});
        fixture.part<QToolButton>("clipPlace0").click();
        QVERIFY(glm::length(plane().normalLps - glm::dvec3(0.0, -1.0, 0.0)) < 1e-9);
        QCOMPARE(fixture.panel->summary(), QStringLiteral("1 plane"));
        // Off and on again it is the same plane.
        const core::ClipPlane placed = plane();
        fixture.part<QCheckBox>("clipPlane0").click();
        QVERIFY(!plane().on);
        fixture.view.lookFrom({1.0, 0.0, 0.0});
        fixture.part<QCheckBox>("clipPlane0").click();
        QVERIFY(plane() == placed);
        save(fixture.window, "/clip-plane.png");
        fixture.part<QToolButton>("clipReset").click();
        QVERIFY(!fixture.workspace.clip().any());
    }

    void slidersAreMillimetres()
    {
        ClippingFixture fixture;
        auto& slider = fixture.part<ui::RangeSlider>("clipAxis2"); // 40 voxels of 1.5 mm
        QCOMPARE(slider.upper(), 60.0);
        const auto at = [&](double mm) {
            return QPoint(int(std::lround(slider.xOf(mm))), slider.height() / 2);
        };
        QTest::mousePress(&slider, Qt::LeftButton, {}, at(45.0));
        QTest::mouseRelease(&slider, Qt::LeftButton, {}, at(45.0));
        QVERIFY(fixture.part<QCheckBox>("clipBox").isChecked());
        QVERIFY(isNear(fixture.workspace.clip().box.maximum.z, 29.5, 0.7));
        QCOMPARE(fixture.workspace.clip().box.minimum.z, -0.5);
        // Arrow keys go on from there by a voxel.
        const double before = fixture.workspace.clip().box.maximum.z;
        QTest::keyClick(&slider, Qt::Key_Left);
        QVERIFY(isNear(fixture.workspace.clip().box.maximum.z, before - 1.0, 1e-9));
        // The lower handle stops a voxel before the upper one.
        QTest::mousePress(&slider, Qt::LeftButton, {}, at(2.0));
        QTest::mouseMove(&slider, at(59.0));
        QTest::mouseRelease(&slider, Qt::LeftButton, {}, at(59.0));
        const core::ClipRegion::Box box = fixture.workspace.clip().box;
        QVERIFY(isNear(box.maximum.z - box.minimum.z, 1.0, 1e-9));
    }

    /// Who presses undo after a clip means the clip, and not the step before it.
    void undoTakesBackTheClip()
    {
        ClippingFixture fixture;
        core::EditSession& session = *fixture.workspace.session();
        QVERIFY(session.apply(test::newSegment(QStringLiteral("First"))));
        QVERIFY(session.settle());
        const auto trigger = [&fixture](const char* id) {
            QAction& action = fixture.window.actionTable()[QLatin1String(id)];
            QVERIFY2(action.isEnabled(), id);
            action.trigger();
            QVERIFY(fixture.workspace.session()->settle());
        };
        const auto text = [&fixture](const char* id) {
            return fixture.window.actionTable()[QLatin1String(id)].text();
        };
        const auto segments = [&session] { return session.document().segments.size(); };
        const core::ClipRegion whole = fixture.workspace.clip();
        test::Pen pen(fixture.view);
        fixture.pull(pen, fixture.view, 1, -9.0);
        pen.release({}, 1030);
        const core::ClipRegion once = fixture.workspace.clip();
        QVERIFY(once != whole);
        fixture.pull(pen, fixture.view, 1, -4.0);
        pen.release({}, 1030);
        const core::ClipRegion twice = fixture.workspace.clip();
        QVERIFY(twice != once);
        // A drag that is called off is none.
        fixture.pull(pen, fixture.view, 0, -4.0);
        fixture.tool.cancel();
        QVERIFY(fixture.workspace.clip() == twice);
        QCOMPARE(text("edit.undo"), QStringLiteral("Undo: Clip"));
        trigger("edit.undo");
        QVERIFY(fixture.workspace.clip() == once);
        trigger("edit.undo");
        QVERIFY(fixture.workspace.clip() == whole);
        QCOMPARE(segments(), std::size_t(1));
        QCOMPARE(text("edit.redo"), QStringLiteral("Redo: Clip"));
        trigger("edit.redo");
        QVERIFY(fixture.workspace.clip() == once);
        trigger("edit.undo");
        // Then what was before the clips.
        QVERIFY(text("edit.undo") != QStringLiteral("Undo: Clip"));
        trigger("edit.undo");
        QCOMPARE(segments(), std::size_t(0));
        QVERIFY(fixture.workspace.clip() == whole);
        // A step that follows a clip comes first, and a clip from elsewhere is nobody's step.
        fixture.part<QToolButton>("clipReset").click();
        fixture.workspace.setClip(once);
        trigger("edit.redo");
        QCOMPARE(segments(), std::size_t(1));
        QVERIFY(fixture.workspace.clip() == once);
        fixture.part<QToolButton>("clipReset").click();
        QVERIFY(session.apply(test::newSegment(QStringLiteral("Second"))));
        QVERIFY(session.settle());
        trigger("edit.undo");
        QCOMPARE(segments(), std::size_t(1));
        QVERIFY(fixture.workspace.clip() == whole);
        trigger("edit.undo");
        QVERIFY(fixture.workspace.clip() == once);
        QCOMPARE(segments(), std::size_t(1));
    }

    /// A seed goes to what the picture shows: behind a plane, or on the cut itself.
    void seedsLandOnWhatIsLeft()
    {
        ClippingFixture fixture;
        const QPointF middle(fixture.view.width() / 2.0, fixture.view.height() / 2.0);
        auto seeds = fixture.seedsAt(middle);
        QCOMPARE(seeds.size(), std::size_t(1));
        QVERIFY(seeds[0]->y < 7); // the bone's front, at y = -16 mm
        core::ClipRegion clip = fixture.workspace.clip();
        clip.planes[2] = {{0.0, -9.0, 0.0}, {0.0, -1.0, 0.0}, true};
        fixture.workspace.setClip(clip);
        seeds = fixture.seedsAt(middle);
        QCOMPARE(seeds.size(), std::size_t(1));
        QVERIFY(seeds[0]->y > 30); // brain is below the threshold: the bone at the back
        // In bone the cut itself is what is seen.
        clip.planes[2].pointLps.y = -14.4;
        fixture.workspace.setClip(clip);
        seeds = fixture.seedsAt(middle);
        QCOMPARE(seeds.size(), std::size_t(1));
        QVERIFY(seeds[0]->y == 5 || seeds[0]->y == 6);
        clip.box.maximum.y = 3.0;
        clip.box.on = true;
        fixture.workspace.setClip(clip);
        QVERIFY(fixture.seedsAt(middle).empty());
    }

    /// The grey scale of the slices reaches the 3D view only where it shows.
    void cutFacesFollowTheirChoice()
    {
        ClippingFixture fixture;
        const auto scene = [&] { return std::get<gpu::VolumeScene>(fixture.view.context().scene); };
        auto& faces = fixture.part<QComboBox>("cutFaces");
        const auto choose = [&](gpu::CutFaces choice) {
            faces.setCurrentIndex(int(choice));
            Q_EMIT faces.activated(int(choice));
        };
        choose(gpu::CutFaces::GreyValues);
        fixture.workspace.setWindowLevel({77.0, 333.0});
        QVERIFY(scene().cutFaces == gpu::CutFaces::GreyValues);
        QVERIFY((scene().faceWindow == core::WindowLevel{77.0, 333.0}));
        choose(gpu::CutFaces::Material);
        const auto before = scene();
        fixture.workspace.setWindowLevel({11.0, 333.0});
        QVERIFY(scene() == before);
    }
};

BURIN_WINDOW_TEST(ClippingUiTest)

} // namespace clippingUiTest

#include "ClippingUiTest.moc"
