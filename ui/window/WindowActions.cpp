// SPDX-License-Identifier: Apache-2.0
#include "ui/window/WindowActions.h"

#include "core/edits/kinds/layers/ChangeLayer.h"
#include "ui/dialogs/KeysDialog.h"
#include "ui/dialogs/MaskOrderDialog.h"
#include "ui/dialogs/PenTesterDialog.h"
#include "ui/dialogs/SegmentDialogs.h"
#include "ui/dialogs/study/OpenDialogs.h"
#include "ui/frame/MessageBar.h"
#include "ui/input/Tool.h"
#include "ui/menus/SegmentEntries.h"
#include "ui/menus/SegmentViews.h"
#include "ui/report/AuditSaver.h"
#include "ui/tasks/MaskImporter.h"
#include "ui/window/EditActions.h"
#include "ui/window/MainWindow.h"
#include "ui/window/PacsActions.h"
#include "ui/window/ViewActions.h"
#include "ui/workspace/LayerActions.h"
#include "ui/workspace/SegmentActions.h"

#include <QApplication>
#include <QDesktopServices>
#include <QUrl>

namespace ui {

namespace {

/// Takes a row back, unless something else was done since or stands open: undo would take that.
void undoIfLast(Workspace& workspace, core::RowId row)
{
    core::EditSession* session = workspace.session();
    if (!session)
        return;
    const bool isOther = session->transactionOpen() && !session->openIsPreview();
    if (isOther || !session->idle() || session->history().position() != row)
        workspace.say(
            Actions::tr("The history has gone on since; Ctrl+Z takes back its last step"));
    else if (const auto undone = session->undo(); !undone)
        workspace.fail(undone.error());
}

void addFileActions(MainWindow& window)
{
    Actions& actions = window.actionTable();
    Workspace& workspace = window.workspace();
    actions.add({.id = QStringLiteral("file.openFolder"),
        .text = Actions::tr("Open study folder …"),
        .keys = {QKeySequence::Open},
        .icon = QStringLiteral("open"),
        .run = [&window] { askForFolder(window.opener(), window); }});
    actions.add({.id = QStringLiteral("file.openFile"),
        .text = Actions::tr("Open file …"),
        .keys = {QKeySequence(QStringLiteral("Ctrl+Shift+O"))},
        .run = [&window] { askForFile(window.opener(), window); }});
    actions.add({.id = QStringLiteral("file.openSession"),
        .text = Actions::tr("Open session …"),
        .run = [&window] { askForSession(window.opener(), window); }});
    auto* audit = new AuditSaver(workspace, &window);
    QObject::connect(audit, &AuditSaver::failed, &workspace, &Workspace::fail);
    QObject::connect(audit, &AuditSaver::saved, &window, [&window](const QString& path) {
        window.messages().show(MessageBar::Kind::Notice,
            Actions::tr("The audit report is in %1.").arg(path), Actions::tr("Show it"),
            [path] { QDesktopServices::openUrl(QUrl::fromLocalFile(path)); });
    });
    actions.add({.id = QStringLiteral("file.auditReport"),
        .text = Actions::tr("Audit report …"),
        .tip = Actions::tr("Who did what and when in this session, checked, to print or keep"),
        .run = [audit] { audit->ask(); },
        .possible = [&workspace] { return workspace.session() != nullptr; }});
    MaskImporter& importer = window.importer();
    askForOrderOf(importer, window);
    QObject::connect(&importer, &MaskImporter::failed, &workspace, &Workspace::fail);
    QObject::connect(&importer, &MaskImporter::imported, &window,
        [&window, &workspace](const QString& rowName, const QStringList& notes) {
            if (!workspace.session()->document().segments.empty())
                static_cast<void>(ensureActiveSegment(workspace)); // it can be cleaned up at once
            const auto kind =
                notes.isEmpty() ? MessageBar::Kind::Notice : MessageBar::Kind::Caution;
            const auto row = core::RowId(workspace.session()->history().rows().size());
            window.messages().show(kind,
                (QStringList{rowName + QLatin1Char('.')} + notes).join(QLatin1Char(' ')),
                Actions::tr("Undo"), [&workspace, row] { undoIfLast(workspace, row); });
            if (kind == MessageBar::Kind::Notice)
                window.messages().dismissAtNextStep(workspace);
        });
    QObject::connect(
        &importer, &MaskImporter::nothingTaken, &window, [&window](const QString& path) {
            window.messages().show(MessageBar::Kind::Notice,
                Actions::tr("%1: segments that are here have all of its voxels already; nothing "
                            "was taken.")
                    .arg(path));
        });
    actions.add({.id = QStringLiteral("file.importMask"),
        .text = Actions::tr("Import mask …"),
        .tip = Actions::tr("Segments from a file of another program, laid on this study: DICOM "
                           "SEG or RTSTRUCT, NIfTI, NRRD, MetaImage, STL, OBJ, PLY or glTF"),
        .run = [&importer] { importer.ask(); },
        .possible = [&workspace,
                        &importer] { return workspace.session() != nullptr && !importer.busy(); }});
    actions.add({.id = QStringLiteral("file.importMaskFolder"),
        .text = Actions::tr("Import masks of a folder …"),
        .tip = Actions::tr("All mask files of a folder as one step, as networks write them: a file "
                           "for each structure, which gives it its name"),
        .run = [&importer] { importer.askForFolder(); },
        .possible = [&workspace,
                        &importer] { return workspace.session() != nullptr && !importer.busy(); }});
    actions.add({.id = QStringLiteral("file.demonstration"),
        .text = Actions::tr("Open the demonstration study"),
        .icon = QStringLiteral("demo"),
        .run = [&window] { Q_EMIT window.demonstrationRequested(); }});
    actions.add({.id = QStringLiteral("file.saveAs"),
        .text = Actions::tr("Save session as …"),
        .keys = {QKeySequence(QStringLiteral("Ctrl+Shift+S"))},
        .tip = Actions::tr("Every step is on disk already; this moves the session to a file of "
                           "your own, with the study's images if you like"),
        .run = [&window] { window.saveSessionAs(); },
        .possible =
            [&workspace] {
                return workspace.session() && !workspace.session()->file().isEmpty();
            }});
    actions.add({.id = QStringLiteral("file.close"),
        .text = Actions::tr("Close study"),
        .keys = {QKeySequence(QStringLiteral("Ctrl+W"))},
        .run = [&window] { window.closeStudy(); },
        .possible = [&window,
                        &workspace] { return workspace.session() || window.opener().busy(); }});
    actions.add({.id = QStringLiteral("file.quit"),
        .text = Actions::tr("Quit"),
        .keys = {QKeySequence(QStringLiteral("Ctrl+Q"))},
        .run = [] { QApplication::closeAllWindows(); }});
    actions.add({.id = QStringLiteral("help.keys"),
        .text = Actions::tr("Mouse, pen and keys"),
        .keys = {QKeySequence(QStringLiteral("F1"))},
        .run = [&window] { KeysDialog(window.actionTable(), &window).exec(); }});
    actions.add({.id = QStringLiteral("help.pen"),
        .text = Actions::tr("Pen tester"),
        .run = [&window] { PenTesterDialog(&window).exec(); }});
    actions.add({.id = QStringLiteral("help.about"),
        .text = Actions::tr("About Burin"),
        .run = [&window] { window.showAbout(); }});
}

void addToolActions(MainWindow& window)
{
    Actions& actions = window.actionTable();
    Workspace& workspace = window.workspace();
    actions.add({.id = QStringLiteral("tool.navigate"),
        .text = Actions::tr("Navigate"),
        .keys = {QKeySequence(QStringLiteral("V"))},
        .icon = QStringLiteral("navigate"),
        .run = [&workspace] { workspace.setActiveTool(nullptr); },
        .possible = [&workspace] { return workspace.volume() != nullptr; },
        .checked = [&workspace] { return workspace.activeTool() == nullptr; }});
    const auto radius = [&workspace](int steps) {
        return [&workspace, steps] { workspace.activeTool()->changeRadius(steps); };
    };
    const auto hasTool = [&workspace] { return workspace.volume() && workspace.activeTool(); };
    actions.add({.id = QStringLiteral("tool.larger"),
        .text = Actions::tr("Larger mask"),
        .keys = {QKeySequence(QStringLiteral("]"))},
        .run = radius(1),
        .possible = hasTool});
    actions.add({.id = QStringLiteral("tool.smaller"),
        .text = Actions::tr("Smaller mask"),
        .keys = {QKeySequence(QStringLiteral("["))},
        .run = radius(-1),
        .possible = hasTool});
}

void addListActions(MainWindow& window)
{
    Actions& actions = window.actionTable();
    Workspace& workspace = window.workspace();
    const auto isOpen = [&workspace] { return workspace.session() != nullptr; };
    const auto activeSegment = [&workspace]() -> const core::Segment* {
        const core::EditSession* session = workspace.session();
        return session ? session->document().segment(workspace.activeSegment()) : nullptr;
    };
    const auto activeLayer = [&workspace]() -> const core::SculptLayer* {
        const core::EditSession* session = workspace.session();
        return session ? session->document().layer(workspace.activeLayer()) : nullptr;
    };
    actions.add({.id = QStringLiteral("segments.add"),
        .text = Actions::tr("Add segment"),
        .run =
            [&workspace] {
                if (const auto added = addSegment(workspace); !added)
                    workspace.fail(added.error());
            },
        .possible = isOpen});
    for (const SegmentAction& each : segmentActions()) {
        actions.add({.id = QLatin1String(each.id),
            .text = each.text,
            .run = [&workspace, &each] { each.run(workspace, workspace.activeSegment()); },
            .possible =
                [activeSegment, isOpen, &workspace, &each] {
                    if (each.whyNot && !each.whyNot(workspace).isEmpty())
                        return false;
                    const core::Segment* segment = activeSegment();
                    return segment ? each.onlyReads || !segment->locked
                                   : each.makesFirst && isOpen();
                },
            .currentText = [activeSegment, &each] { return namedText(each, activeSegment()); }});
    }
    openSegmentDialogs(workspace, window);
    actions.add({.id = QStringLiteral("layers.add"),
        .text = Actions::tr("Add sculpt layer"),
        .run =
            [&workspace] {
                if (const auto added = addLayer(workspace); !added)
                    workspace.fail(added.error());
            },
        .possible = isOpen});
    actions.add({.id = QStringLiteral("layers.mute"),
        .text = Actions::tr("Mute sculpt layer"),
        .run =
            [&workspace, activeLayer] {
                const core::SculptLayer* layer = activeLayer();
                const auto muted = workspace.session()->apply(
                    core::ChangeLayer{.layer = layer->id, .muted = !layer->muted});
                if (!muted)
                    workspace.fail(muted.error());
            },
        .possible = [activeLayer] { return activeLayer() != nullptr; },
        .checked = [activeLayer] { return activeLayer() && activeLayer()->muted; },
        .currentText =
            [activeLayer] {
                const core::SculptLayer* layer = activeLayer();
                return layer ? Actions::tr("Mute layer '%1'").arg(layer->name)
                             : Actions::tr("Mute sculpt layer");
            }});
    actions.add({.id = QStringLiteral("layers.solo"),
        .text = Actions::tr("Solo sculpt layer"),
        .run =
            [&workspace, activeLayer] {
                const core::SculptLayer* layer = activeLayer();
                const auto changed = workspace.session()->apply(
                    core::ChangeLayer{.layer = layer->id, .solo = !layer->solo});
                if (!changed)
                    workspace.fail(changed.error());
            },
        .possible = [activeLayer] { return activeLayer() != nullptr; },
        .checked = [activeLayer] { return activeLayer() && activeLayer()->solo; },
        .currentText =
            [activeLayer] {
                const core::SculptLayer* layer = activeLayer();
                return layer ? Actions::tr("Solo layer '%1'").arg(layer->name)
                             : Actions::tr("Solo sculpt layer");
            }});
    actions.add({.id = QStringLiteral("layers.toSegment"),
        .text = Actions::tr("New segment of what the layer has carved"),
        .run = [&workspace] { layerToSegment(workspace, workspace.activeLayer(), std::nullopt); },
        .possible = [activeLayer] { return activeLayer() != nullptr; }});
    actions.add({.id = QStringLiteral("segments.seen"),
        .text = Actions::tr("New segment of what I see in 3D"),
        .run = [&workspace] { segmentWhatIsSeen(workspace, std::nullopt); },
        .possible = isOpen});
}

} // namespace

void addWindowActions(MainWindow& window)
{
    addFileActions(window);
    addPacsActions(window);
    addEditActions(window);
    addToolActions(window);
    addViewActions(window);
    addSegmentViews(window.actionTable(), window.workspace());
    addListActions(window);
}

} // namespace ui
