// SPDX-License-Identifier: Apache-2.0
#include "ui/frame/ReadOnlyMark.h"

#include "ui/base/Theme.h"
#include "ui/workspace/Workspace.h"

namespace ui {

ReadOnlyMark::ReadOnlyMark(Workspace& workspace, QWidget* parent)
    : QLabel(parent)
    , m_workspace(workspace)
{
    setFont(theme::smallFont());
    setTextFormat(Qt::PlainText);
    setStyleSheet(
        QStringLiteral("color: %1; background: %2; border-radius: %3px; padding: 1px 8px;")
            .arg(theme::window.name(), theme::caution.name())
            .arg(theme::cornerRadius));
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Maximum);
    connect(&workspace, &Workspace::sessionChanged, this, &ReadOnlyMark::follow);
    connect(&workspace, &Workspace::sessionSaved, this, &ReadOnlyMark::follow);
    follow();
}

void ReadOnlyMark::follow()
{
    const core::EditSession* session = m_workspace.session();
    const QString why = session ? session->whyReadOnly() : QString();
    setVisible(!why.isEmpty());
    if (why.isEmpty())
        return;
    setText(tr("Read-only: %1").arg(why));
    setToolTip(tr("%1\nIt can be looked at in every state, not edited. "
                  "File > Save session as … gives a copy that can be edited.")
                   .arg(session->file()));
}

} // namespace ui
