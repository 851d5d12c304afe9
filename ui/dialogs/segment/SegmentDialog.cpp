// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/segment/SegmentDialog.h"

#include "core/session/EditSession.h"
#include "ui/base/TabOrder.h"
#include "ui/base/Theme.h"
#include "ui/menus/EditableButton.h"
#include "ui/widgets/FittingLabel.h"
#include "ui/workspace/Workspace.h"

#include <QVBoxLayout>

namespace ui {

SegmentDialog::SegmentDialog(
    Workspace& workspace, const QString& title, const QString& name, QWidget* parent)
    : QDialog(parent, Qt::Tool) // so that the window's keys, undo above all, work in it, too
    , m_workspace(workspace)
    , m_whose(new FittingLabel(Qt::AlignLeft, this))
    , m_column(new QVBoxLayout(this))
{
    setWindowTitle(title);
    m_column->setContentsMargins(24, 20, 24, 16);
    m_column->setSpacing(theme::smallPadding);
    m_column->setSizeConstraint(QLayout::SetFixedSize);
    m_whose->setObjectName(name + QStringLiteral("Whose"));
    m_whose->setFont(theme::headingFont());
    m_column->addWidget(m_whose);
    connect(&workspace, &Workspace::sessionChanged, this, &QDialog::reject);
}

const core::Segment* SegmentDialog::segment() const
{
    const core::EditSession* session = m_workspace.session();
    return session ? session->document().segment(m_label) : nullptr;
}

void SegmentDialog::addEditable()
{
    m_column->addWidget(new EditableButton(m_workspace, this, EditableButton::In::Column));
}

void SegmentDialog::bringUp()
{
    tabAsLaidOut(*this);
    show();
    raise();
    activateWindow();
}

void SegmentDialog::showState()
{
    const core::Segment* shown = segment();
    m_whose->setText(shown ? shown->name : QString());
}

} // namespace ui
