// SPDX-License-Identifier: Apache-2.0
#include "ui/window/PieceActions.h"

#include "ui/views/ViewGrid.h"
#include "ui/window/MainWindow.h"
#include "ui/workspace/Pieces.h"
#include "ui/workspace/Workspace.h"

#include <QAction>

namespace ui {

void addPieceActions(MainWindow& window)
{
    Workspace& workspace = window.workspace();
    MainWindow::connect(&workspace.pieces(), &Pieces::activeChanged, &window,
        [&window] { window.actionTable().refresh(); });
    Actions& actions = window.actionTable();
    const auto layer = [&workspace]() -> const core::SculptLayer* {
        return workspace.session() ? workspace.session()->document().layer(workspace.activeLayer())
                                   : nullptr;
    };
    const auto liftable = [&workspace, layer] {
        return layer() && !workspace.session()->document().pieceOfLayer(layer()->id);
    };
    QAction& lift = actions.add({.id = QStringLiteral("pieces.lift"),
        .text = Actions::tr("Lift last cut as a piece"),
        .keys = {QKeySequence(QStringLiteral("Ctrl+L"))},
        .run = [&workspace] { workspace.pieces().liftLast(workspace.activeLayer()); },
        .possible = liftable});
    // A key that is held would lift one cut after the other.
    lift.setAutoRepeat(false);
    actions.add({.id = QStringLiteral("pieces.liftLayer"),
        .text = Actions::tr("Lift whole layer as a piece"),
        .keys = {QKeySequence(QStringLiteral("Ctrl+Shift+L"))},
        .run = [&workspace] { workspace.pieces().lift(workspace.activeLayer()); },
        .possible = liftable,
        .currentText =
            [layer] {
                return layer() ? Actions::tr("Lift all of layer '%1' as a piece").arg(layer()->name)
                               : Actions::tr("Lift whole layer as a piece");
            }});
    actions.add({.id = QStringLiteral("pieces.lid"),
        .text = Actions::tr("Open piece like a lid"),
        .run =
            [&workspace, &window] {
                workspace.pieces().openLikeALid(
                    workspace.pieces().active(), window.views().volume().camera().up);
            },
        .possible = [&workspace] { return workspace.pieces().active() != 0; }});
    actions.add({.id = QStringLiteral("pieces.home"),
        .text = Actions::tr("Send all pieces home"),
        .keys = {QKeySequence(QStringLiteral("Ctrl+H"))},
        .run = [&workspace] { workspace.pieces().sendHome(); },
        .possible = [&workspace] { return !workspace.pieces().allHome(); }});
}

} // namespace ui
