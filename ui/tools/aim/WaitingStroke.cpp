// SPDX-License-Identifier: Apache-2.0
#include "ui/tools/aim/WaitingStroke.h"

#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/ResumeGrowth.h"
#include "core/session/EditSession.h"
#include "ui/workspace/Workspace.h"

#include <QCoreApplication>

namespace ui {

void sayStrokeWaits(Workspace& workspace)
{
    workspace.say(QCoreApplication::translate("ui::WaitingStroke",
        "The stroke before waits for what is being worked out: draw again once it is there"));
}

void sayStrokeCameTooLate(Workspace& workspace)
{
    workspace.say(QCoreApplication::translate("ui::WaitingStroke",
        "The stroke before was dropped: another one was begun before its place was known"));
}

QString waitingStrokeText()
{
    return QCoreApplication::translate("ui::WaitingStroke", "the stroke that is about to come");
}

bool isStrokeOpen(const core::EditSession& session)
{
    return session.transactionOpen() && !session.openIsPreview()
        && !session.isOpen<core::GrowSteps>() && !session.isOpen<core::ResumeGrowth>();
}

} // namespace ui
