// SPDX-License-Identifier: Apache-2.0
#include "ui/menus/EditableButton.h"

#include "ui/base/MenuText.h"
#include "ui/base/Theme.h"
#include "ui/menus/EditableSection.h"
#include "ui/widgets/fields/FieldMenu.h"

#include <QAction>
#include <QMenu>

namespace ui {

namespace {

constexpr int longestStatePixels = 72; ///< so that the bar fits into 1280 pixels
constexpr int besidesTextPixels = 32; ///< frame and arrow

} // namespace

EditableButton::EditableButton(Workspace& workspace, QWidget* parent, In place)
    : QToolButton(parent)
    , m_workspace(workspace)
    , m_place(place)
{
    setObjectName(QStringLiteral("editableButton"));
    setFixedHeight(place == In::Bar ? theme::controlHeight : theme::rowHeight);
    if (place == In::Column)
        setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    setPopupMode(QToolButton::InstantPopup);
    setToolButtonStyle(Qt::ToolButtonTextOnly);
    auto* section = new EditableSection(workspace, this);
    section->setContentsMargins(
        theme::padding, theme::smallPadding, theme::padding, theme::smallPadding);
    setMenu(new FieldMenu(section, this));
    showState();
    connect(&workspace, &Workspace::editableChanged, this, &EditableButton::showState);
}

void EditableButton::showState()
{
    const QString now = m_workspace.editableText();
    const QString text = now.isEmpty() ? tr("all voxels") : now;
    const bool isInBar = m_place == In::Bar;
    const int widest = isInBar ? longestStatePixels : width() - besidesTextPixels;
    // In a column there is room to say what may change.
    const QString shown = now.isEmpty() && !isInBar ? tr("changes all voxels") : text;
    setText(fontMetrics().elidedText(shown, Qt::ElideRight, widest));
    setToolTip(tr("Which voxels may change: %1").arg(text));
}

void EditableButton::resizeEvent(QResizeEvent* event)
{
    QToolButton::resizeEvent(event);
    if (m_place == In::Column)
        showState();
}

void addEditableNote(QMenu& menu, QAction* before, Workspace& workspace)
{
    auto* note = new QAction(&menu);
    note->setObjectName(QStringLiteral("editableNote"));
    note->setEnabled(false);
    menu.insertAction(before, note);
    const auto show = [note, &workspace] {
        const QString text = workspace.editableText();
        note->setText(menuText(text));
        note->setVisible(!text.isEmpty());
    };
    QObject::connect(&menu, &QMenu::aboutToShow, note, show);
    show();
}

} // namespace ui
