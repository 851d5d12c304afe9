// SPDX-License-Identifier: Apache-2.0
#include "app/window/Application.h"
#include "core/edits/kinds/layers/AddLayer.h"
#include "core/edits/kinds/surface/DropSurface.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/nifti/NiftiWriter.h"
#include "core/session/EditSession.h"
#include "core/session/SessionDisplay.h"
#include "core/sessionfile/SessionFile.h"
#include "core/study/StudyLoader.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/SurfaceCases.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/tools/contour/ContourTool.h"
#include "ui/tools/growth/FloodFillTool.h"
#include "ui/tools/growth/ShrinkTool.h"
#include "ui/tools/nudge/NudgeTool.h"
#include "ui/tools/outline/FillOutlineTool.h"
#include "ui/tools/scissors/SegmentScissorsTool.h"
#include "ui/tools/sculpt/PeelTool.h"
#include "ui/tools/sculpt/ScissorsTool.h"
#include "ui/tools/view/MeasureTool.h"
#include "ui/views/ViewGrid.h"
#include "ui/window/MainWindow.h"
#include "ui/window/display/DisplayState.h"
#include "ui/workspace/Chunks.h"
#include "ui/workspace/CuttingPlane.h"
#include "ui/workspace/LayerLooks.h"
#include "ui/workspace/Pieces.h"
#include "ui/workspace/Refinement.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

namespace displayStateUiTest {

namespace {

constexpr int patience = 120000; ///< ms; only a hang takes that long

ui::DisplayState& displayOf(ui::MainWindow& window)
{
    return *window.findChild<ui::DisplayState*>();
}

std::vector<QImage> pictures(const ui::MainWindow& window)
{
    std::vector<QImage> images;
    for (const ui::ImageView* view : window.views().views())
        images.push_back(view->picture());
    return images;
}

} // namespace

/// How the window looks at a session comes back with it, and is no step of undo.
class DisplayStateUiTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QByteArray m_hash;

    QString path(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    QString session() const { return path("s.burin"); }
    QJsonObject kept() const
    {
        return (*core::SessionFile::open(session(), core::SessionFile::Access::ReadOnly))
            ->contents()
            .display;
    }

    std::unique_ptr<app::Application> opened() const
    {
        auto application = *app::Application::create();
        ui::MainWindow& window = application->window();
        window.resize(1400, 860);
        window.show();
        window.opener().openSession(session());
        if (!QTest::qWaitFor(
                [&] { return application->workspace().session() != nullptr; }, patience))
            qFatal("the session does not open");
        return application;
    }
    static void waitForPictures(const ui::MainWindow& window)
    {
        if (!QTest::qWaitFor([&] { return window.views().refined(); }, patience))
            qFatal("the views do not become still");
    }
    static void save(ui::MainWindow& window, const char* name)
    {
        const QString folder = qEnvironmentVariable("BURIN_SCREENSHOTS");
        if (!folder.isEmpty())
            window.grab().save(folder + QLatin1String(name));
    }

    static inline const ui::Workspace::DrillSettings drill{.radiusMm = 3.5,
        .depthMm = 12.5,
        .throughGaps = true,
        .shape = core::ToolMask::Kind::Rounded,
        .heightRatio = 0.25,
        .rotationDegrees = -40.0,
        .softnessMm = 1.5,
        .turnsWithPen = false,
        .foreshortened = true,
        .mode = core::DrillMode::Rate,
        .floorMm = 22.5,
        .pressureExponent = 3,
        .laserDepthMm = 9.5,
        .sweep = ui::Workspace::Sweep::UpDown,
        .freehand = true,
        .outline = {{-1.0, -0.25}, {1.0, -0.25}, {0.125, 0.25}}};

    /// Everything that can be set, to something else than it is at the start.
    static void changeEverything(app::Application& application)
    {
        ui::Workspace& workspace = application.workspace();
        ui::ViewGrid& views = application.window().views();
        workspace.setCrosshairLps({3.0, -2.0, 131.0});
        workspace.setWindowLevel({210.0, 1800.0});
        workspace.setViewOptions({.showPatient = false,
            .showCrosshair = false,
            .showSegments = true,
            .showCarved = false,
            .carvedAsHole = true,
            .showBarriers = false,
            .inverted = true,
            .colours = gpu::ColourMap::HotIron,
            .interpolation = gpu::Interpolation::Nearest,
            .slabMode = gpu::SlabMode::Minimum,
            .slabMm = 12.25,
            .referenceLines = true,
            .linkedPlaces = true,
            .suspendedBodies = true});
        ui::Workspace::VolumeDisplay volume = workspace.volumeDisplay();
        volume.mode = gpu::RenderMode::Dvr;
        volume.surfaceThreshold = 444.0;
        volume.transferFunction = {
            {{-100.0, 0x204060, 0.0}, {35.0, 0xC06040, 0.02}, {900.5, 0xFFFFEE, 0.6}}};
        volume.mipWindow = {500.0, 700.0};
        volume.xrayWindow = {-400.0, 900.0};
        volume.cutFaces = gpu::CutFaces::GreyValues;
        workspace.setVolumeDisplay(volume);
        core::ClipRegion clip = workspace.clip();
        clip.box.minimum.x += 0.75;
        clip.box.maximum.z -= 0.5;
        clip.box.on = true;
        clip.planes[1] = {{1.0, 2.0, 130.0}, glm::normalize(glm::dvec3(1.0, -2.0, 0.5)), true};
        workspace.setClip(clip);
        workspace.pieces().setLook(1,
            {.visible = false,
                .opacity = 0.4,
                .rgb = 0x80FF90,
                .tissue = true,
                .map = {{{0.0, 0x204060, 0.0}, {90.0, 0xC06040, 0.5}}}});
        workspace.layerLooks().setLook(1, {.hides = 0.35, .softness = 0.8});
        workspace.setActiveSegment(2);
        workspace.setActiveLayer(2);
        workspace.setDrillSettings(drill);
        application.window().findChild<ui::PeelTool*>()->setDepthMm(7.5);
        application.window().findChild<ui::FillOutlineTool*>()->setShape(
            ui::FillOutlineTool::Shape::Ellipse);
        application.window().findChild<ui::MeasureTool*>()->setKind(ui::MeasureTool::Kind::Angle);
        application.window().findChild<ui::FloodFillTool*>()->setSettings(
            {.in3D = true, .corners = true, .tolerance = 72.0});
        application.window().findChild<ui::NudgeTool*>()->setSettings(
            {.radiusMm = 5.5, .fits = false, .radiusByPressure = true});
        application.window().findChild<ui::ShrinkTool*>()->applySettings(
            {{QStringLiteral("byPressure"), true}, {QStringLiteral("reachMm"), 4.5}});
        application.window().findChild<ui::ContourTool*>()->setSettings(
            {.bubbleMm = 6.5, .smoothness = 71, .generations = 33});
        application.window().findChild<ui::ScissorsTool*>()->setSettings(
            {.limited = true, .depthMm = 33.0, .firstLayerOnly = true});
        application.window().findChild<ui::SegmentScissorsTool*>()->setSettings(
            {.does = ui::SegmentScissorsTool::Does::FillInside, .depthMm = 4.5});
        workspace.setBrushSettings(ui::Workspace::Brush::Paint,
            {.radiusMm = 6.5,
                .disc = false,
                .onlyBetween = true,
                .lower = -7.0,
                .upper = 80.5,
                .overwriteUnlocked = true,
                .followsEdges = true,
                .edgeTolerance = 37.5,
                .toleranceByPressure = true});
        workspace.setBrushSettings(
            ui::Workspace::Brush::Carve, {.radiusMm = 2.5, .disc = true, .square = true});
        workspace.setBrushSettings(ui::Workspace::Brush::Barrier, {.radiusMm = 1.5, .disc = true});
        workspace.setGrowSettings({.lower = 15.0,
            .upper = 333.0,
            .overwriteUnlocked = true,
            .generationsPerSecond = 20.0});
        workspace.session()->display().setSegmentVisible(1, false);
        ui::Camera camera = views.volume().camera();
        camera.orbit(50.0, 20.0);
        camera.heightMm *= 0.7;
        camera.targetLps += glm::dvec3(2.0, 0.0, -1.0);
        views.volume().setCamera(camera);
        views.axial().setPlace({.centreLps = {4.0, 1.0, 0.0}, .mmPerPixel = 0.05});
        ui::Chunks::Look chunks = workspace.chunks().look();
        chunks.count += 100;
        chunks.opacity = 0.7f;
        workspace.chunks().setLook(chunks);
        workspace.plane().cutAcross({1.0, 2.0, 118.0}, {0.3, 1.0, 0.4});
        workspace.plane().setLook({.shown = true, .opacity = 0.4f, .clipsAbove = true});
        views.planes().turnOthers(ui::SliceOrientation::Axial, 0.3);
        views.planes().turnOne(ui::SliceOrientation::Coronal, ui::SliceOrientation::Sagittal, -0.2);
        views.sagittal().setTurn({true, 3});
        views.coronal().setPlace({.centreLps = {0.0, 0.0, 130.0}, .mmPerPixel = 0.08});
        for (ui::Tool* tool : application.window().findChildren<ui::Tool*>()) {
            if (tool->iconName() != QLatin1String("seed"))
                continue;
            tool->applySettings(
                {{QStringLiteral("byPressure"), true}, {QStringLiteral("reachMm"), 3.5}});
            workspace.setActiveTool(tool);
        }
    }

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        for (const char* name : {"XDG_STATE_HOME", "XDG_CONFIG_HOME"})
            qputenv(name, path(name).toUtf8());
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, path("settings"));

        const core::LoadedVolume small = test::smallStudy();
        std::vector<std::int16_t> values;
        for (const std::uint16_t code : small.codes)
            values.push_back(std::int16_t(small.volume.encoding.value(code)));
        QVERIFY(core::writeNifti(path("small.nii.gz"),
            {.geometry = small.volume.geometry, .voxels = values, .description = {}}));
        reference::ReferenceEngine oracle;
        auto session = *core::EditSession::create(
            oracle, *core::loadVolume(path("small.nii.gz")), {.file = this->session()});
        for (const core::Edit& edit : test::manyEdits())
            QVERIFY(session->apply(edit));
        QVERIFY(session->apply(core::AddLayer{.name = QStringLiteral("Approach")}));
        QVERIFY(session->settle());
        m_hash = session->stateHash();
    }

    void everythingComesBack()
    {
        QJsonObject before;
        std::vector<QImage> picturesBefore;
        {
            const auto application = opened();
            const std::size_t rows = application->workspace().session()->history().rows().size();
            const QJsonObject initial = displayOf(application->window()).composed();
            changeEverything(*application);
            before = displayOf(application->window()).composed();
            // Nothing of it was changed in vain.
            for (const QString& field : before.keys()) {
                if (field != QLatin1String("showSegments"))
                    QVERIFY2(before[field] != initial[field], qPrintable(field));
            }
            for (const char* tool : {"drill", "tools"}) {
                const QJsonObject now = before[QLatin1String(tool)].toObject();
                for (const QString& field : now.keys())
                    QVERIFY2(now[field] != initial[QLatin1String(tool)][field], qPrintable(field));
            }
            QCOMPARE(before.size(), initial.size());
            QCOMPARE(application->workspace().session()->history().rows().size(), rows);
            waitForPictures(application->window());
            picturesBefore = pictures(application->window());
            save(application->window(), "/display-before.png");
        }
        QCOMPARE(kept(), before);
        const auto application = opened();
        ui::Workspace& workspace = application->workspace();
        QCOMPARE(displayOf(application->window()).composed(), before);
        QCOMPARE(workspace.windowLevel(), (core::WindowLevel{210.0, 1800.0}));
        QCOMPARE(workspace.volumeDisplay().transferFunction.points[1].rgb, 0xC06040U);
        QCOMPARE(workspace.growSettings().generationsPerSecond, 20.0);
        QVERIFY(workspace.drillSettings() == drill);
        QCOMPARE(application->window().findChild<ui::PeelTool*>()->depthMm(), 7.5);
        QVERIFY(application->window().findChild<ui::FillOutlineTool*>()->shape()
            == ui::FillOutlineTool::Shape::Ellipse);
        QVERIFY((application->window().findChild<ui::FloodFillTool*>()->settings()
            == ui::FloodFillTool::Settings{.in3D = true, .corners = true, .tolerance = 72.0}));
        QVERIFY((application->window().findChild<ui::NudgeTool*>()->settings()
            == ui::NudgeTool::Settings{.radiusMm = 5.5, .fits = false, .radiusByPressure = true}));
        const QJsonObject shrink =
            application->window().findChild<ui::ShrinkTool*>()->settingsJson();
        QVERIFY(shrink[QStringLiteral("byPressure")].toBool());
        QCOMPARE(shrink[QStringLiteral("reachMm")].toDouble(), 4.5);
        QVERIFY((application->window().findChild<ui::ContourTool*>()->settings()
            == ui::ContourSettings{.bubbleMm = 6.5, .smoothness = 71, .generations = 33}));
        const auto& scissors = application->window().findChild<ui::ScissorsTool*>()->settings();
        QVERIFY(scissors.limited && scissors.depthMm == 33.0 && scissors.firstLayerOnly);
        QVERIFY((application->window().findChild<ui::SegmentScissorsTool*>()->settings()
            == ui::SegmentScissorsTool::Settings{
                .does = ui::SegmentScissorsTool::Does::FillInside, .depthMm = 4.5}));
        const auto& paint = workspace.brushSettings(ui::Workspace::Brush::Paint);
        QVERIFY((paint
            == ui::Workspace::BrushSettings{.radiusMm = 6.5,
                .disc = false,
                .onlyBetween = true,
                .lower = -7.0,
                .upper = 80.5,
                .overwriteUnlocked = true,
                .followsEdges = true,
                .edgeTolerance = 37.5,
                .toleranceByPressure = true}));
        QCOMPARE(workspace.brushSettings(ui::Workspace::Brush::Carve).radiusMm, 2.5);
        QVERIFY(workspace.brushSettings(ui::Workspace::Brush::Carve).disc);
        QVERIFY(workspace.brushSettings(ui::Workspace::Brush::Carve).square);
        QCOMPARE(workspace.brushSettings(ui::Workspace::Brush::Barrier).radiusMm, 1.5);
        QCOMPARE(workspace.activeLayer(), 2);
        QCOMPARE(workspace.activeTool()->iconName(), QStringLiteral("seed"));
        QVERIFY(!workspace.session()->document().segment(1)->visible);
        QVERIFY(workspace.session()->document().segment(2)->visible);
        waitForPictures(application->window());
        save(application->window(), "/display-after.png");
        QVERIFY(pictures(application->window()) == picturesBefore);
        QCOMPARE(workspace.session()->stateHash(), m_hash);
    }

    /// One view alone, the 3D view turned but still showing everything.
    void layoutComesBack()
    {
        glm::dvec3 from(0.0);
        {
            const auto application = opened();
            ui::ViewGrid& views = application->window().views();
            views.maximise(&views.volume());
            views.volume().lookFrom({1.0, 0.0, 0.0});
            from = views.volume().camera().towardsViewer;
        }
        const auto application = opened();
        ui::ViewGrid& views = application->window().views();
        QCOMPARE(views.maximised(), static_cast<ui::ImageView*>(&views.volume()));
        QVERIFY(views.volume().camera().towardsViewer == from);
        QVERIFY(views.volume().fitted());
        QVERIFY(!views.axial().place());
    }

    /// Translucent segments come back; a session without any does not speak of them.
    void opacitiesComeBack()
    {
        const auto named = [](app::Application& application) {
            return displayOf(application.window())
                .composed()[QLatin1String("views")]
                .toObject()
                .contains(QLatin1String("segments"));
        };
        {
            const auto application = opened();
            QVERIFY(!named(*application));
            const std::size_t rows = application->workspace().session()->history().rows().size();
            application->workspace().setSegmentOpacity(2, 45);
            QVERIFY(named(*application));
            QCOMPARE(application->workspace().session()->history().rows().size(), rows);
        }
        {
            const auto application = opened();
            QCOMPARE(application->workspace().segmentOpacity(2), 45);
            QCOMPARE(application->workspace().segmentOpacity(1), 100);
            QCOMPARE(int(application->workspace().segmentDisplay().transparencyPercent[2]), 55);
            QCOMPARE(application->workspace().session()->stateHash(), m_hash);
            application->workspace().setSegmentOpacity(2, 100);
        }
        const auto application = opened();
        QVERIFY(application->workspace().segmentOpacities().empty());
        QVERIFY(!named(*application));
    }

    /// What the user has chosen in the menu comes back; a session with the usual way does not speak
    /// of it.
    void theInterpolationComesBack()
    {
        const auto choose = [](app::Application& application, const char* id) {
            application.window().actionTable()[QLatin1String(id)].trigger();
        };
        const auto chosen = [](app::Application& application) {
            return application.workspace().viewOptions().interpolation;
        };
        {
            const auto application = opened();
            QVERIFY(!chosen(*application));
            choose(*application, "view.interpolationCubic");
        }
        QCOMPARE(kept()[QLatin1String("views")][QLatin1String("interpolation")].toString(),
            QStringLiteral("cubic"));
        {
            const auto application = opened();
            QVERIFY(chosen(*application) == gpu::Interpolation::Cubic);
            ui::MainWindow& window = application->window();
            QVERIFY(window.actionTable()[QStringLiteral("view.interpolationCubic")].isChecked());
            QVERIFY(std::get<gpu::SliceScene>(window.views().axial().context().scene).interpolation
                == gpu::Interpolation::Cubic);
            QCOMPARE(application->workspace().session()->stateHash(), m_hash);
            choose(*application, "view.interpolationUsual");
        }
        QVERIFY(
            !kept()[QLatin1String("views")].toObject().contains(QLatin1String("interpolation")));
        const auto application = opened();
        QVERIFY(!chosen(*application));
    }

    /// Views that draw segments in their own way do so again; one that no longer does is as all.
    void looksOfViewsComeBack()
    {
        using Look = ui::Workspace::SegmentLook;
        const Look outline{.drawing = ui::Workspace::SegmentDrawing::Outline};
        {
            const auto application = opened();
            const ui::ViewGrid& views = application->window().views();
            QVERIFY(views.coronal().segmentLook().isUsual());
            views.coronal().setSegmentLook(outline);
            views.plane().setSegmentLook({.fillPercent = 80});
        }
        {
            const auto application = opened();
            const ui::ViewGrid& views = application->window().views();
            QVERIFY(views.coronal().segmentLook() == outline);
            QVERIFY(views.plane().segmentLook() == (Look{.fillPercent = 80}));
            QVERIFY(views.axial().segmentLook().isUsual());
            views.coronal().setSegmentLook({});
            views.plane().setSegmentLook({});
        }
        const auto application = opened();
        QVERIFY(application->window().views().coronal().segmentLook().isUsual());
        QVERIFY(!displayOf(application->window())
                     .composed()[QLatin1String("views")]
                     .toObject()
                     .contains(QLatin1String("segmentLooks")));
    }

    /// The cutting plane where it was, and the pen view beside the stage.
    void thePlaneComesBack()
    {
        ui::CuttingPlane::Pose pose;
        {
            const auto application = opened();
            ui::CuttingPlane& plane = application->workspace().plane();
            plane.cutAcross({1.0, 2.0, 118.0}, {0.3, 1.0, 0.4});
            pose = plane.pose();
            application->window().views().arrange(ui::ViewGrid::Layout::PenAndStage);
            application->window().views().plane().setPlace(
                {.centreLps = {4.0, 1.0, 118.0}, .mmPerPixel = 0.04});
        }
        const auto application = opened();
        const ui::ViewGrid& views = application->window().views();
        const ui::CuttingPlane& plane = application->workspace().plane();
        QVERIFY(plane.look().shown);
        for (const auto& [was, is] : {std::pair(pose.centreLps, plane.pose().centreLps),
                 std::pair(pose.rightLps, plane.pose().rightLps),
                 std::pair(pose.downLps, plane.pose().downLps)})
            QVERIFY(glm::distance(was, is) < 1e-9);
        QCOMPARE(views.arrangement(), ui::ViewGrid::Layout::PenAndStage);
        QVERIFY(views.plane().isVisible() && !views.axial().isVisible());
        QCOMPARE(views.plane().place()->mmPerPixel, 0.04);
    }

    /// What the volume stepped back from for the surface comes back with the end of refining, also
    /// after a restart; and what the user has chosen meanwhile stays.
    void whatRefiningHidComesBack_data()
    {
        QTest::addColumn<int>("chosen");
        QTest::addColumn<int>("expected");
        using gpu::Context;
        QTest::newRow("stepped back") << -1 << int(Context::CutAway);
        QTest::newRow("chosen: both") << int(Context::Translucent) << int(Context::Translucent);
        QTest::newRow("chosen: segments only") << int(Context::Hidden) << int(Context::Hidden);
    }
    void whatRefiningHidComesBack()
    {
        QFETCH(int, chosen);
        QFETCH(int, expected);
        const auto show = [](ui::Workspace& workspace, gpu::Context context) {
            ui::Workspace::VolumeDisplay display = workspace.volumeDisplay();
            display.context = context;
            workspace.setVolumeDisplay(display);
        };
        const auto apply = [](ui::Workspace& workspace, const core::Edit& edit) {
            QVERIFY(workspace.session()->apply(edit));
            QVERIFY(workspace.session()->settle());
            QCoreApplication::processEvents();
        };
        {
            const auto application = opened();
            ui::Workspace& workspace = application->workspace();
            show(workspace, gpu::Context::CutAway);
            apply(workspace, test::ballMask(workspace.volume()->geometry.size, 6.0));
            const int label = workspace.session()->document().segments.back().label;
            apply(workspace, core::LaySurface{.segment = label, .vertices = 800});
            QCOMPARE(workspace.volumeDisplay().context, gpu::Context::Hidden);
            if (chosen >= 0) {
                show(workspace, gpu::Context::Opaque);
                show(workspace, gpu::Context(chosen));
            }
        }
        const auto application = opened();
        ui::Workspace& workspace = application->workspace();
        QCoreApplication::processEvents();
        QVERIFY(workspace.refinement().surface().has_value());
        QCOMPARE(int(workspace.volumeDisplay().context),
            chosen >= 0 ? chosen : int(gpu::Context::Hidden));
        apply(workspace, core::DropSurface{});
        QCOMPARE(int(workspace.volumeDisplay().context), expected);
    }

    /// Looking alone writes nothing; neither does a session that was never looked at lack anything.
    void lookingLeavesTheFileAlone()
    {
        QFile file(session());
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray untouched = file.readAll();
        {
            const auto application = opened();
        }
        QVERIFY(file.seek(0));
        QVERIFY(kept().isEmpty());
        QCOMPARE(file.size(), untouched.size());
    }

    /// Changes reach the file while the session is open, without being told of each.
    void isKeptWhileTheSessionIsOpen()
    {
        const auto application = opened();
        application->workspace().setWindowLevel({123.0, 456.0});
        QTRY_VERIFY_WITH_TIMEOUT(
            !application->workspace().session()->display().kept().isEmpty(), patience);
        QCOMPARE(application->workspace()
                     .session()
                     ->display()
                     .kept()[QLatin1String("window")][QLatin1String("centre")]
                     .toDouble(),
            123.0);
    }

    void passesOverWhatMakesNoSense_data()
    {
        QTest::addColumn<QByteArray>("json");
        QTest::newRow("nothing") << QByteArray("{}");
        QTest::newRow("of a later Burin") << QByteArray("{'hologram':{'depth':3}}");
        QTest::newRow("other types")
            << QByteArray("{'crosshairLps':'here','window':7,'inverted':'yes','volume':[1,2],"
                          "'views':'four','activeSegment':'one','tool':9,'drill':[],"
                          "'growth':null,'tools':[3]}");
        QTest::newRow("out of range")
            << QByteArray("{'crosshairLps':[1,2],'window':{'centre':'x','width':-1},"
                          "'activeSegment':99,'tool':'chainsaw','clip':{'box':{'minimum':[9,9,9],'"
                          "maximum':[1,1,1],'on':true},"
                          "'planes':[{'normalLps':[0,0,0],'on':true}]},'volume':{'mode':'hologram',"
                          "'transferFunction':[{'value':3,'color':'#fff','opacity':2}]},"
                          "'views':{'alone':'ceiling','interpolation':'sinc',"
                          "'axial':{'mmPerPixel':-1},"
                          "'segments':[3,{'segment':700,'opacityPercent':9},"
                          "{'segment':1,'opacityPercent':'half'}],'volume':"
                          "{'up':[0,0,0],'towardsViewer':[1,1,1],'heightMm':-3}},"
                          "'drill':{'shape':9,'sweep':-1,'rate':'often','freehand':true,"
                          "'outline':[[0,0],[1,'far']]},"
                          "'tools':{'peel':{'depthMm':'deep'},'carve-scissors':7},"
                          "'growth':{'lower':9,'upper':-9}}");
    }
    void passesOverWhatMakesNoSense()
    {
        QFETCH(QByteArray, json);
        const QJsonObject foreign = QJsonDocument::fromJson(json.replace('\'', '"')).object();
        QCOMPARE(foreign.isEmpty(), json == "{}");
        QJsonObject initial;
        {
            const auto application = opened();
            initial = displayOf(application->window()).composed();
            application->workspace().session()->display().keep(foreign);
        }
        QCOMPARE(kept(), foreign);
        {
            const auto application = opened();
            QCOMPARE(displayOf(application->window()).composed(), initial);
            application->workspace().setWindowLevel({1.0, 2.0});
        }
        // What is not understood stays, as does what it was laid over.
        QJsonObject expected = foreign;
        initial[QStringLiteral("window")] =
            QJsonObject{{QStringLiteral("centre"), 1.0}, {QStringLiteral("width"), 2.0}};
        for (const QString& field : initial.keys())
            expected[field] = initial[field];
        QCOMPARE(kept(), expected);
    }
};

BURIN_WINDOW_TEST(DisplayStateUiTest)

} // namespace displayStateUiTest

#include "DisplayStateUiTest.moc"
