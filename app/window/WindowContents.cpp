// SPDX-License-Identifier: Apache-2.0
#include "app/window/WindowContents.h"

#include "core/session/SessionStorage.h"
#include "ui/dialogs/export/CarvedExportDialog.h"
#include "ui/dialogs/export/DeidentifySessionDialog.h"
#include "ui/dialogs/export/ExportDialog.h"
#include "ui/dialogs/export/Screenshot.h"
#include "ui/frame/LoadingBar.h"
#include "ui/frame/MendingStrip.h"
#include "ui/frame/MessageBar.h"
#include "ui/measure/MeasuredRegions.h"
#include "ui/panels/ClippingPanel.h"
#include "ui/panels/SeriesDoctorPanel.h"
#include "ui/panels/TimeSlider.h"
#include "ui/panels/VolumePanel.h"
#include "ui/panels/contour/ContourPanel.h"
#include "ui/panels/growth/GrowthActions.h"
#include "ui/panels/growth/GrowthPanel.h"
#include "ui/panels/history/HistoryPanel.h"
#include "ui/panels/lists/CleanUpPanel.h"
#include "ui/panels/lists/LayersPanel.h"
#include "ui/panels/lists/MeasurementsPanel.h"
#include "ui/panels/lists/PiecesPanel.h"
#include "ui/panels/lists/SegmentsPanel.h"
#include "ui/panels/lists/StatisticsPanel.h"
#include "ui/panels/refine/ChunksPanel.h"
#include "ui/panels/refine/ComparePanel.h"
#include "ui/panels/refine/LookFirstSection.h"
#include "ui/panels/refine/MendingSteps.h"
#include "ui/panels/refine/RefineActions.h"
#include "ui/panels/refine/RefinePanel.h"
#include "ui/settings/StudyOpener.h"
#include "ui/tools/contour/ContourTool.h"
#include "ui/tools/growth/BarrierTool.h"
#include "ui/tools/growth/FloodFillTool.h"
#include "ui/tools/growth/PaintTool.h"
#include "ui/tools/growth/SeedTool.h"
#include "ui/tools/growth/ShrinkTool.h"
#include "ui/tools/nudge/NudgeTool.h"
#include "ui/tools/outline/FillOutlineTool.h"
#include "ui/tools/refine/ChunkTool.h"
#include "ui/tools/refine/RefineTool.h"
#include "ui/tools/scissors/SegmentScissorsTool.h"
#include "ui/tools/sculpt/CarveBrushTool.h"
#include "ui/tools/sculpt/DrillTool.h"
#include "ui/tools/sculpt/LaserTool.h"
#include "ui/tools/sculpt/PeelTool.h"
#include "ui/tools/sculpt/PieceTool.h"
#include "ui/tools/sculpt/ScissorsTool.h"
#include "ui/tools/view/ClipTool.h"
#include "ui/tools/view/CuttingPlaneTool.h"
#include "ui/tools/view/MeasureTool.h"
#include "ui/tools/view/UndoHereTool.h"
#include "ui/views/ViewGrid.h"
#include "ui/views/VolumeView.h"
#include "ui/window/KeyframeRecorder.h"
#include "ui/window/MainWindow.h"
#include "ui/window/PieceActions.h"
#include "ui/window/SpaceSteering.h"
#include "ui/window/display/DisplayState.h"
#include "ui/window/display/TimeSteps.h"
#include "ui/workspace/SegmentActions.h"
#include "ui/workspace/Workspace.h"

#include <QAction>
#include <QMenu>

#include <optional>
#include <vector>

namespace app {

namespace {

/// The brush with its own key as an eraser.
void addErase(ui::MainWindow& window, ui::PaintTool& paint)
{
    ui::Workspace& workspace = window.workspace();
    const auto isTaken = [&workspace, &paint] {
        return workspace.activeTool() == &paint && paint.erases();
    };
    QAction& action = window.actionTable().add({.id = QStringLiteral("tool.erase"),
        .text = ui::Actions::tr("Erase"),
        .keys = {QKeySequence(QStringLiteral("E"))},
        .run =
            [&workspace, &paint, isTaken] {
                const bool taken = !isTaken();
                paint.setErases(taken);
                workspace.setActiveTool(taken ? &paint : nullptr);
            },
        .possible = [&workspace] { return workspace.volume() != nullptr; },
        .checked = isTaken});
    window.growMenu().addAction(&action);
}

std::vector<ui::Tool*> addTools(ui::MainWindow& window)
{
    ui::Workspace& workspace = window.workspace();
    auto* drill = new ui::DrillTool(workspace, &window);
    auto* laser = new ui::LaserTool(workspace, &window);
    auto* peel = new ui::PeelTool(workspace, &window);
    auto* scissors = new ui::ScissorsTool(workspace, &window);
    auto* carve = new ui::CarveBrushTool(workspace, &window);
    auto* clip = new ui::ClipTool(workspace, &window);
    auto* piece = new ui::PieceTool(workspace, &window);
    ui::addPieceActions(window);
    auto* seed = new ui::SeedTool(workspace, &window);
    auto* shrink = new ui::ShrinkTool(workspace, &window);
    auto* paint = new ui::PaintTool(workspace, &window);
    auto* nudge = new ui::NudgeTool(workspace, &window);
    auto* outline = new ui::FillOutlineTool(workspace, &window);
    auto* flood = new ui::FloodFillTool(workspace, &window);
    auto* contour = new ui::ContourTool(workspace, &window);
    auto* snip = new ui::SegmentScissorsTool(workspace, &window);
    auto* barrier = new ui::BarrierTool(workspace, &window);
    auto* refine = new ui::RefineTool(workspace, &window);
    auto* plane = new ui::CuttingPlaneTool(workspace, &window);
    auto* chunks = new ui::ChunkTool(workspace, &window);
    auto* measure = new ui::MeasureTool(workspace, &window);
    auto* undoHere = new ui::UndoHereTool(workspace, &window);
    window.addToolGroup();
    window.addTool(*drill, window.sculptMenu(), QKeySequence(QStringLiteral("T")));
    window.addTool(*laser, window.sculptMenu(), QKeySequence(QStringLiteral("A")));
    window.addTool(*peel, window.sculptMenu(), QKeySequence(QStringLiteral("O")));
    window.addTool(*scissors, window.sculptMenu(), QKeySequence(QStringLiteral("K")));
    window.addTool(*carve, window.sculptMenu(), QKeySequence(QStringLiteral("C")));
    window.addTool(*clip, window.sculptMenu(), QKeySequence(QStringLiteral("Shift+C")));
    window.addTool(*piece, window.sculptMenu(), QKeySequence(QStringLiteral("M")));
    window.actionTable().fill(window.sculptMenu(),
        {QString(), QStringLiteral("layers.add"), QStringLiteral("layers.mute"),
            QStringLiteral("layers.solo"), QString(), QStringLiteral("layers.toSegment"),
            QStringLiteral("segments.seen"), QString(), QStringLiteral("pieces.lift"),
            QStringLiteral("pieces.liftLayer"), QStringLiteral("pieces.lid"),
            QStringLiteral("pieces.home")});
    window.addToolGroup();
    window.addTool(*seed, window.growMenu(), QKeySequence(QStringLiteral("S")));
    window.addTool(*shrink, window.growMenu(), QKeySequence(QStringLiteral("X")));
    window.addTool(*paint, window.growMenu(), QKeySequence(QStringLiteral("B")));
    addErase(window, *paint);
    window.addTool(*nudge, window.growMenu(), QKeySequence(QStringLiteral("J")));
    window.addTool(*outline, window.growMenu(), QKeySequence(QStringLiteral("D")));
    window.addTool(*flood, window.growMenu(), QKeySequence(QStringLiteral("Shift+D")));
    window.addTool(*contour, window.growMenu(), QKeySequence(QStringLiteral("Shift+E")));
    window.addTool(*snip, window.growMenu(), QKeySequence(QStringLiteral("Shift+K")));
    window.addTool(*barrier, window.growMenu(), QKeySequence(QStringLiteral("Shift+B")));
    window.addToolGroup();
    window.addTool(*refine, window.refineMenu(), QKeySequence(QStringLiteral("F")));
    window.addTool(*plane, window.refineMenu(), QKeySequence(QStringLiteral("P")));
    window.addTool(*chunks, window.refineMenu(), QKeySequence(QStringLiteral("Shift+F")));
    window.addToolGroup();
    window.addTool(*measure, window.editMenu(), QKeySequence(QStringLiteral("L")));
    window.addToolGroup();
    window.addTool(*undoHere, window.editMenu(), QKeySequence(QStringLiteral("U")));
    return {drill, laser, peel, scissors, carve, clip, piece, seed, shrink, paint, nudge, outline,
        flood, contour, snip, barrier, refine, plane, chunks, measure, undoHere};
}

void addDoctor(ui::MainWindow& window)
{
    auto* doctor = new ui::SeriesDoctorPanel(window.workspace());
    window.addPanel(doctor);
    QObject::connect(doctor, &ui::SeriesDoctorPanel::reopenRequested, &window,
        [&window](
            const QString& path, const QString& series) { window.opener().open(path, series); });
    QAction& action = window.actionTable().add({.id = QStringLiteral("file.seriesDoctor"),
        .text = ui::Actions::tr("Series doctor …"),
        .run = [&window, doctor] { window.bringUp(*doctor); },
        .possible = [doctor] { return doctor->hasSomething(); }});
    window.fileMenu().insertAction(
        &window.actionTable()[QStringLiteral("file.importMask")], &action);
}

/// The strip that leads from an imported mask to its export, with what its buttons do.
ui::MendingSteps& addMending(ui::MainWindow& window, ui::ComparePanel& panel)
{
    ui::Workspace& workspace = window.workspace();
    ui::Actions& actions = window.actionTable();
    auto* steps = new ui::MendingSteps(workspace, panel, window.mendingStrip());
    actions.add({.id = QStringLiteral("mending.look"),
        .text = ui::Actions::tr("Places to look at first"),
        .tip = ui::Actions::tr("Lists places of the active segment that may be wrong"),
        .run =
            [&window, &workspace, &panel] {
                static_cast<void>(ui::ensureActiveSegment(workspace));
                window.bringUp(panel);
                panel.lookFirst().lookOnce();
            },
        .possible =
            [&workspace] {
                return workspace.session() && !workspace.session()->document().segments.empty();
            }});
    actions.add({.id = QStringLiteral("mending.compare"),
        .text = ui::Actions::tr("Compare with what was imported"),
        .run =
            [&window, &workspace, &panel] {
                static_cast<void>(ui::ensureActiveSegment(workspace));
                window.bringUp(panel);
                if (!panel.comparison().isImported())
                    panel.comparison().takeImported();
            },
        .possible =
            [steps, &workspace] {
                return steps->hasMask() && workspace.session()
                    && !workspace.session()->document().segments.empty();
            }});
    actions.add({.id = QStringLiteral("mending.strip"),
        .text = ui::Actions::tr("Steps of mending a mask"),
        .tip = ui::Actions::tr("A strip over the views, while there is an imported mask"),
        .run = [steps] { steps->setWanted(!steps->isWanted()); },
        .checked = [steps] { return steps->isWanted(); }});
    actions.fill(window.segmentsMenu(),
        {QString(), QStringLiteral("file.importMask"), QStringLiteral("mending.look"),
            QStringLiteral("mending.compare"), QStringLiteral("mending.strip")});
    QObject::connect(steps, &ui::MendingSteps::changed, &actions, &ui::Actions::refresh);
    using Step = ui::MendingStrip::Step;
    QObject::connect(
        &window.mendingStrip(), &ui::MendingStrip::stepRequested, &window, [&window](Step step) {
            ui::Actions& all = window.actionTable();
            switch (step) {
            case Step::Look:
                return all[QStringLiteral("mending.look")].trigger();
            case Step::Mend: {
                QAction& chunks = all[QStringLiteral("tool.chunks")];
                // Taken once more it would be put away, though its panel may be out of sight.
                if (chunks.isChecked())
                    chunks.trigger();
                return chunks.trigger();
            }
            case Step::Compare:
                return all[QStringLiteral("mending.compare")].trigger();
            case Step::Export:
                return all[QStringLiteral("file.export")].trigger();
            }
        });
    return *steps;
}

/// The panels that something else of the window needs.
struct NamedPanels {
    ui::ComparePanel& compare;
    ui::StatisticsPanel& statistics;
};

/// @param format none: the first that is possible
void openExport(ui::MainWindow& window, ui::MendingSteps& mending,
    std::optional<core::ExportFormat> format = std::nullopt)
{
    auto* dialog = new ui::ExportDialog(window.workspace(), &window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    if (format)
        dialog->choose(*format);
    QObject::connect(
        dialog, &ui::ExportDialog::exported, &mending, &ui::MendingSteps::noteExported);
    dialog->open();
}

void addExport(ui::MainWindow& window, ui::MendingSteps& mending, ui::StatisticsPanel& statistics)
{
    ui::Workspace& workspace = window.workspace();
    QObject::connect(&statistics, &ui::StatisticsPanel::exportRequested, &window,
        [&window, &mending] { openExport(window, mending, core::ExportFormat::Csv); });
    QAction& action = window.actionTable().add({.id = QStringLiteral("file.export"),
        .text = ui::Actions::tr("Export segments …"),
        .keys = {QKeySequence(QStringLiteral("Ctrl+E"))},
        .icon = QStringLiteral("export"),
        .run = [&window, &mending] { openExport(window, mending); },
        .possible =
            [&workspace] {
                return workspace.session() && !workspace.session()->document().segments.empty();
            }});
    QAction& carved = window.actionTable().add({.id = QStringLiteral("file.exportCarved"),
        .text = ui::Actions::tr("Export carved volume …"),
        .run =
            [&window, &workspace] {
                auto* dialog = new ui::CarvedExportDialog(workspace, &window);
                dialog->setAttribute(Qt::WA_DeleteOnClose);
                dialog->open();
            },
        .possible = [&workspace] { return workspace.session() != nullptr; }});
    QAction& deidentified = window.actionTable().add({.id = QStringLiteral("file.deidentify"),
        .text = ui::Actions::tr("Save de-identified session as …"),
        .run =
            [&window, &workspace] {
                auto* dialog = new ui::DeidentifySessionDialog(workspace, &window);
                dialog->setAttribute(Qt::WA_DeleteOnClose);
                dialog->open();
            },
        .possible =
            [&workspace] {
                core::EditSession* session = workspace.session();
                return session && !session->file().isEmpty() && !session->storage().whyNoFile();
            }});
    QAction& picture = window.actionTable().add({.id = QStringLiteral("file.savePicture"),
        .text = ui::Actions::tr("Save picture of the window …"),
        .run =
            [&window, &workspace] {
                const QString verdict = ui::askAndSavePicture(workspace, window);
                if (!verdict.isEmpty())
                    window.messages().show(ui::MessageBar::Kind::Notice, verdict);
            },
        .possible = [&workspace] { return workspace.session() != nullptr; }});
    QMenu& menu = window.fileMenu();
    for (QAction* each : {&action, &carved, &picture})
        menu.insertAction(&window.actionTable()[QStringLiteral("file.toPacs")], each);
    menu.insertAction(&window.actionTable()[QStringLiteral("file.auditReport")], &deidentified);
    window.views().addToMenus([saving = &picture](QMenu& ofView) { ofView.addAction(saving); });
    window.actionTable().refresh();
}

/// How other points of a series in time are opened.
void addTimes(ui::MainWindow& window, ui::TimeSteps& steps)
{
    ui::Actions& actions = window.actionTable();
    QAction& toPrevious = actions.add({.id = QStringLiteral("file.previousTime"),
        .text = ui::Actions::tr("Previous point in time"),
        .keys = {QKeySequence(QStringLiteral("Ctrl+PgUp"))},
        .tip = ui::Actions::tr("Opens it with its own session; this one stays with its point"),
        .run = [&steps] { steps.go(-1); },
        .possible = [&steps] { return steps.hasPoint(-1); }});
    QAction& toNext = actions.add({.id = QStringLiteral("file.nextTime"),
        .text = ui::Actions::tr("Next point in time"),
        .keys = {QKeySequence(QStringLiteral("Ctrl+PgDown"))},
        .tip = ui::Actions::tr("Opens it with its own session; this one stays with its point"),
        .run = [&steps] { steps.go(1); },
        .possible = [&steps] { return steps.hasPoint(1); }});
    const ui::TimeSlider& points = window.findChild<ui::SeriesDoctorPanel*>()->times();
    QAction& play = actions.add({.id = QStringLiteral("file.playTimes"),
        .text = ui::Actions::tr("Play points in time"),
        .tip = ui::Actions::tr("Opens one point after the other until it is paused; a right click "
                               "on the slider of the series doctor chooses how fast"),
        .run =
            [&steps, &points] {
                steps.isPlaying() ? steps.pause() : steps.play(points.pointsPerSecond());
            },
        .possible =
            [&steps] { return steps.isPlaying() || steps.hasPoint(1) || steps.hasPoint(-1); },
        .currentText =
            [&steps] {
                return steps.isPlaying() ? ui::Actions::tr("Pause at this point in time")
                                         : ui::Actions::tr("Play points in time");
            }});
    QAction* import = &actions[QStringLiteral("file.importMask")];
    for (QAction* each : {&toPrevious, &toNext, &play})
        window.fileMenu().insertAction(import, each);
    window.fileMenu().insertSeparator(import);
    QObject::connect(&points, &ui::TimeSlider::requested, &steps, &ui::TimeSteps::openPoint);
    QObject::connect(&points, &ui::TimeSlider::playRequested, &steps, &ui::TimeSteps::play);
    QObject::connect(&points, &ui::TimeSlider::pauseRequested, &steps, &ui::TimeSteps::pause);
    QObject::connect(&steps, &ui::TimeSteps::playingChanged, &points, &ui::TimeSlider::showPlaying);
    QObject::connect(&steps, &ui::TimeSteps::playingChanged, &actions, &ui::Actions::refresh);
    // Over the pictures a bar would come and go with each point.
    constexpr int longMs = 2000;
    QObject::connect(&steps, &ui::TimeSteps::playingChanged, &window,
        [&window](bool plays) { window.loading().showAfter(plays ? longMs : 0); });
    actions.refresh();
}

NamedPanels addPanels(ui::MainWindow& window)
{
    ui::Workspace& workspace = window.workspace();
    addDoctor(window);
    window.addPanel(new ui::SegmentsPanel(workspace));
    window.addPanel(new ui::CleanUpPanel(workspace));
    auto* growth = new ui::GrowthPanel(workspace);
    window.addPanel(growth);
    window.addPanel(new ui::ContourPanel(workspace, *window.findChild<ui::ContourTool*>()));
    window.growMenu().addSeparator();
    window.actionTable().fill(
        window.growMenu(), ui::addGrowthActions(window.actionTable(), *growth, workspace));
    window.addPanel(new ui::RefinePanel(workspace));
    window.refineMenu().addSeparator();
    window.actionTable().fill(
        window.refineMenu(), ui::addRefineActions(window.actionTable(), workspace));
    auto* compare = new ui::ComparePanel(workspace);
    window.addPanel(compare);
    window.addPanel(new ui::ChunksPanel(workspace));
    window.addPanel(new ui::HistoryPanel(workspace));
    window.addPanel(new ui::MeasurementsPanel(workspace));
    auto* statistics = new ui::StatisticsPanel(workspace);
    window.addPanel(statistics);
    window.addPanel(new ui::LayersPanel(workspace));
    window.addPanel(new ui::PiecesPanel(workspace, window.views().volume()));
    window.addPanel(new ui::VolumePanel(workspace));
    window.addPanel(new ui::ClippingPanel(workspace, window.views().volume()));
    return {*compare, *statistics};
}

} // namespace

void addContents(ui::MainWindow& window)
{
    ui::Workspace& workspace = window.workspace();
    const std::vector<ui::Tool*> tools = addTools(window);
    const NamedPanels panels = addPanels(window);
    addExport(window, addMending(window, panels.compare), panels.statistics);
    new ui::MeasuredRegions(workspace, &window);
    new ui::SpaceSteering(window);
    new ui::KeyframeRecorder(workspace, window.views().volume());
    // The last to hear of a session: the others have set themselves up by then.
    auto* display = new ui::DisplayState(workspace, window.views(), tools, &window);
    addTimes(
        window, *new ui::TimeSteps(workspace, window.opener(), *display, window.views(), &window));
}

} // namespace app
