// SPDX-License-Identifier: Apache-2.0
#include "ui/tasks/UndoOnly.h"

#include "core/edits/kinds/history/RevertRows.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/base/RowTitleText.h"
#include "ui/workspace/Workspace.h"

#include <QPointer>

namespace ui {

void undoOnlyLast(Workspace& workspace, const core::Touch& touch, const QString& place)
{
    core::EditSession* session = workspace.session();
    if (!session)
        return;
    session->questions().lastTouching(
        touch, [shared = QPointer<Workspace>(&workspace), place](core::RowId row) {
            core::EditSession* now = shared ? shared->session() : nullptr;
            if (!now)
                return;
            if (row == 0) {
                shared->say(Workspace::tr("There is no step to undo %1").arg(place));
                return;
            }
            const QString name = nameOf(now->history().row(row));
            if (const auto applied = now->apply(core::RevertRows{{row}}); !applied)
                shared->fail(applied.error());
            else
                shared->say(Workspace::tr("Undoing only %1; Ctrl+Z brings it back").arg(name));
        });
}

} // namespace ui
