// SPDX-License-Identifier: Apache-2.0
#include "ui/frame/StepMessage.h"

#include "core/session/EditSession.h"
#include "ui/frame/MessageBar.h"
#include "ui/workspace/Workspace.h"

namespace ui {

void dismissAtNextStep(MessageBar& bar, Workspace& workspace)
{
    const core::EditSession* session = workspace.session();
    if (!session)
        return;
    auto* waiting = new QObject(&bar);
    QObject::connect(&workspace, &Workspace::documentChanged, waiting,
        [&bar, &workspace, waiting, said = bar.sentence(),
            position = session->history().position()] {
            const core::EditSession* now = workspace.session();
            if (bar.sentence() == said) {
                if (now && now->history().position() == position)
                    return;
                bar.dismiss();
            }
            waiting->deleteLater();
        });
}

} // namespace ui
