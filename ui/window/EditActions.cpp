// SPDX-License-Identifier: Apache-2.0
#include "ui/window/EditActions.h"

#include "ui/base/MenuText.h"
#include "ui/base/RowTitleText.h"
#include "ui/dialogs/AuthorDialog.h"
#include "ui/dialogs/session/HistoryMemoryDialog.h"
#include "ui/input/Tool.h"
#include "ui/models/ViewStepText.h"
#include "ui/tasks/UndoOnly.h"
#include "ui/window/MainWindow.h"
#include "ui/workspace/ViewSteps.h"

namespace ui {

namespace {

/// What is drawn corner by corner is undone so, too.
bool drawsStepwise(const Workspace& workspace)
{
    return workspace.activeTool() && workspace.activeTool()->canTakeStepBack();
}

QString nameOfStep(const ViewSteps::Step& step, const Workspace& workspace)
{
    const core::EditSession* session = workspace.session();
    return menuText(viewStepText(step, session ? &session->document() : nullptr));
}

void carryOut(Workspace& workspace, core::Result<void> (core::EditSession::*step)())
{
    core::EditSession* session = workspace.session();
    if (!session)
        return;
    // A stroke under the pen would be what an impatient undo means.
    if (workspace.activeTool())
        workspace.activeTool()->putAway();
    if (const auto done = (session->*step)(); !done)
        workspace.fail(done.error());
}

} // namespace

void addEditActions(MainWindow& window)
{
    Actions& actions = window.actionTable();
    Workspace& workspace = window.workspace();
    actions.add({.id = QStringLiteral("edit.undo"),
        .text = Actions::tr("Undo"),
        .keys = {QKeySequence(QStringLiteral("Ctrl+Z"))},
        .icon = QStringLiteral("undo"),
        .run =
            [&workspace] {
                if (drawsStepwise(workspace))
                    workspace.activeTool()->takeStepBack();
                else if (workspace.viewSteps().undoable())
                    workspace.viewSteps().undo();
                else
                    carryOut(workspace, &core::EditSession::undo);
            },
        .possible =
            [&workspace] {
                return drawsStepwise(workspace) || workspace.viewSteps().undoable()
                    || (workspace.session() && workspace.session()->history().canUndo());
            },
        .currentText =
            [&workspace] {
                if (drawsStepwise(workspace))
                    return Actions::tr("Undo: %1").arg(workspace.activeTool()->stepText());
                if (const auto shown = workspace.viewSteps().undoable())
                    return Actions::tr("Undo: %1").arg(nameOfStep(*shown, workspace));
                if (!workspace.session() || !workspace.session()->history().canUndo())
                    return Actions::tr("Undo");
                const core::History& history = workspace.session()->history();
                return Actions::tr("Undo: %1")
                    .arg(menuText(nameOf(history.row(history.position()))));
            }});
    actions.add({.id = QStringLiteral("edit.redo"),
        .text = Actions::tr("Redo"),
        .keys = {QKeySequence(QStringLiteral("Ctrl+Y")),
            QKeySequence(QStringLiteral("Ctrl+Shift+Z"))},
        .icon = QStringLiteral("redo"),
        .run =
            [&workspace] {
                if (workspace.viewSteps().redoable())
                    workspace.viewSteps().redo();
                else
                    carryOut(workspace, &core::EditSession::redo);
            },
        .possible =
            [&workspace] {
                return workspace.viewSteps().redoable()
                    || (workspace.session() && workspace.session()->history().canRedo());
            },
        .currentText =
            [&workspace] {
                if (const auto shown = workspace.viewSteps().redoable())
                    return Actions::tr("Redo: %1").arg(nameOfStep(*shown, workspace));
                if (!workspace.session() || !workspace.session()->history().canRedo())
                    return Actions::tr("Redo");
                const core::History& history = workspace.session()->history();
                return Actions::tr("Redo: %1")
                    .arg(menuText(nameOf(history.row(history.redoTarget()))));
            }});
    const auto activeSegment = [&workspace]() -> const core::Segment* {
        const core::EditSession* session = workspace.session();
        return session ? session->document().segment(workspace.activeSegment()) : nullptr;
    };
    actions.add({.id = QStringLiteral("edit.undoOnlySegment"),
        .text = Actions::tr("Undo last step of segment only"),
        .keys = {QKeySequence(QStringLiteral("Ctrl+Alt+Z"))},
        .tip = Actions::tr("Takes back the last step that changed the active segment, and keeps "
                           "what came after it"),
        .run =
            [&workspace, activeSegment] {
                const core::Segment* segment = activeSegment();
                undoOnlyLast(workspace, {.segment = segment->label},
                    Actions::tr("in '%1'").arg(segment->name));
            },
        .possible = [activeSegment] { return activeSegment() != nullptr; },
        .currentText =
            [activeSegment] {
                const core::Segment* segment = activeSegment();
                return segment
                    ? Actions::tr("Undo last step of '%1' only").arg(menuText(segment->name))
                    : Actions::tr("Undo last step of segment only");
            }});
    actions.add({.id = QStringLiteral("edit.author"),
        .text = Actions::tr("Name in the audit trail …"),
        .run = [&window] { AuthorDialog(&window).exec(); }});
    actions.add({.id = QStringLiteral("edit.historyMemory"),
        .text = Actions::tr("Memory for history …"),
        .run = [&window] { HistoryMemoryDialog(window.workspace(), &window).exec(); }});
}

} // namespace ui
