// SPDX-License-Identifier: Apache-2.0
#include "ui/menus/EditableButton.h"

#include "ui/base/Theme.h"
#include "ui/menus/EditableSection.h"

#include <QMenu>
#include <QWidgetAction>

namespace ui {

namespace {

constexpr int longestStatePixels = 72; ///< so that the bar fits into 1280 pixels

} // namespace

EditableButton::EditableButton(Workspace& workspace, QWidget* parent)
    : QToolButton(parent)
    , m_workspace(workspace)
{
    setObjectName(QStringLiteral("editableButton"));
    setFixedHeight(theme::controlHeight);
    setPopupMode(QToolButton::InstantPopup);
    setToolButtonStyle(Qt::ToolButtonTextOnly);
    auto* menu = new QMenu(this);
    auto* section = new EditableSection(workspace, menu);
    section->setContentsMargins(
        theme::padding, theme::smallPadding, theme::padding, theme::smallPadding);
    auto* action = new QWidgetAction(menu);
    action->setDefaultWidget(section);
    menu->addAction(action);
    setMenu(menu);
    showState();
    connect(&workspace, &Workspace::editableChanged, this, &EditableButton::showState);
}

void EditableButton::showState()
{
    const QString now = m_workspace.editableText();
    const QString text = now.isEmpty() ? tr("all voxels") : now;
    setText(fontMetrics().elidedText(text, Qt::ElideRight, longestStatePixels));
    setToolTip(tr("Which voxels may change: %1").arg(text));
}

EditableNote::EditableNote(Workspace& workspace, QWidget* parent)
    : QLabel(parent)
    , m_workspace(workspace)
{
    setObjectName(QStringLiteral("editableNote"));
    setFont(theme::smallFont());
    setTextFormat(Qt::PlainText);
    setWordWrap(true);
    setProperty("role", QStringLiteral("caution"));
    showState();
    connect(&workspace, &Workspace::editableChanged, this, &EditableNote::showState);
}

void EditableNote::showState()
{
    setText(m_workspace.editableText());
    setVisible(!text().isEmpty());
}

} // namespace ui
