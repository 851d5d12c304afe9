// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/views/Measurements.h"
#include "core/session/EditSession.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/SurfaceWindow.h"
#include "tests/support/program/TestProgram.h"
#include "ui/views/PlaneView.h"
#include "ui/views/SliceView.h"
#include "ui/views/ViewGrid.h"
#include "ui/views/VolumeView.h"
#include "ui/workspace/Chunks.h"
#include "ui/workspace/CuttingPlane.h"
#include "ui/workspace/Refinement.h"

#include <QImage>
#include <QtTest>

namespace nextStudyUiTest {

namespace {

/// A window in which much of what views can show of a study is shown.
class UsedWindow : public test::SurfaceWindow {
public:
    UsedWindow()
    {
        apply(test::WorkspaceFixture::middleSeed(1));
        apply(core::AddMeasurement{.fromLps = glm::dvec3(-5.0), .toLps = glm::dvec3(5.0)});
        settle();
        ui::CuttingPlane::Look plane = workspace.plane().look();
        plane.shown = true;
        workspace.plane().setLook(plane);
        workspace.chunks().divide(8.0);
        settle();
        const auto areDivided = [this] {
            session().poll();
            return workspace.chunks().map() && session().settle()
                && !workspace.chunks().isCounting();
        };
        QVERIFY(QTest::qWaitFor(areDivided, 60000));
        core::ClipRegion clip = workspace.clip();
        clip.box.maximum.x -= 4.0;
        workspace.setClip(clip);
        ui::Workspace::GrowSettings growth = workspace.growSettings();
        growth.boxed = true;
        growth.box = core::GrowBox{.fromLps = glm::dvec3(-8.0), .toLps = glm::dvec3(8.0)};
        workspace.setGrowSettings(growth);
        workspace.setEditableSettings({.on = true});
        workspace.setWarnAfter(2);
        workspace.setSegmentOpacity(1, 50);
        workspace.refinement().addContour(
            {glm::dvec3(8.0, -4.0, 0.0), glm::dvec3(12.0, 0.0, 0.0), glm::dvec3(8.0, 4.0, 0.0)});
        ui::Workspace::VolumeDisplay display = workspace.volumeDisplay();
        display.context = gpu::Context::Translucent;
        workspace.setVolumeDisplay(display);
        window.views().axial().setTurn(window.views().axial().turn().flippedTopBottom());
        window.views().volume().lookFrom({1.0, 0.0, 0.0});
        workspace.setCrosshairLps(workspace.crosshairLps() + glm::dvec3(3.0, 2.0, 1.5));
        workspace.setPointedLps(workspace.crosshairLps());
        window.views().sagittal().setSegmentLook({.fillPercent = 80});
        QCoreApplication::processEvents();
    }
    void openTheNext()
    {
        workspace.setActiveTool(nullptr);
        workspace.setSession(nullptr);
        auto next = core::EditSession::create(engine, test::smallHead::volume(), {});
        if (!next)
            qFatal("the session could not be made");
        workspace.setSession(std::move(*next));
        QCoreApplication::processEvents();
    }
    [[nodiscard]] gpu::FrameRequest drawn(const ui::ImageView& view) const
    {
        return frames.lastRequest(view.viewId());
    }
};

QImage pictureOf(ui::ImageView& view)
{
    return view.grab().toImage();
}

} // namespace

/// What views show of a study goes with it.
class NextStudyUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }
    void nothingOfTheLastOneIsDrawn();
};

void NextStudyUiTest::nothingOfTheLastOneIsDrawn()
{
    test::WindowFixture fresh(test::smallHead::volume());
    UsedWindow used;
    const auto isShown = [&used](const ui::ImageView& view) {
        return std::visit(
            [](const auto& scene) { return scene.chunks != nullptr; }, used.drawn(view).scene);
    };
    QVERIFY(isShown(used.window.views().axial()) && isShown(used.window.views().volume()));
    QVERIFY(std::get<gpu::VolumeScene>(used.drawn(used.window.views().volume()).scene).surface);

    used.openTheNext();
    QVERIFY(used.workspace.clip() == fresh.workspace.clip());
    QVERIFY(!used.workspace.pointedLps());
    QVERIFY(!used.workspace.growSettings().boxed && !used.workspace.growSettings().box);
    QVERIFY(!used.workspace.editableSettings().on);
    QVERIFY(used.workspace.refinement().contours().empty());
    QVERIFY(used.workspace.plane().look() == fresh.workspace.plane().look());
    const auto before = fresh.window.views().views();
    const auto after = used.window.views().views();
    for (std::size_t i = 0; i < after.size(); ++i) {
        if (!after[i]->isVisible())
            continue;
        const char* const name = after[i]->metaObject()->className();
        gpu::FrameRequest expected = fresh.frames.lastRequest(before[i]->viewId());
        gpu::FrameRequest now = used.drawn(*after[i]);
        // Lists of seeds are equal only if they are the same one.
        for (gpu::FrameRequest* request : {&expected, &now}) {
            if (auto* scene = std::get_if<gpu::VolumeScene>(&request->scene)) {
                QVERIFY(!scene->seeds || scene->seeds->empty());
                scene->seeds.reset();
            }
        }
        QVERIFY2(!std::visit([](const auto& scene) { return scene.chunks; }, now.scene), name);
        QVERIFY2(now.scene == expected.scene, name);
        QVERIFY2(now.segments == expected.segments, name);
        QTRY_COMPARE(pictureOf(*after[i]), pictureOf(*before[i])); // once it is at rest
    }
}

BURIN_WINDOW_TEST(NextStudyUiTest)

} // namespace nextStudyUiTest

#include "NextStudyUiTest.moc"
