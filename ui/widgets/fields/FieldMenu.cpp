// SPDX-License-Identifier: Apache-2.0
#include "ui/widgets/fields/FieldMenu.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWidgetAction>

namespace ui {

FieldMenu::FieldMenu(QWidget* form, QWidget* parent)
    : QMenu(parent)
{
    auto* action = new QWidgetAction(this);
    action->setDefaultWidget(form);
    addAction(action);
}

void FieldMenu::mousePressEvent(QMouseEvent* event)
{
    // QMenu would take a click that no field takes for a choice of the form, and close the menu.
    if (!rect().contains(event->position().toPoint()))
        QMenu::mousePressEvent(event);
}

void FieldMenu::mouseReleaseEvent(QMouseEvent* event)
{
    if (!rect().contains(event->position().toPoint()))
        QMenu::mouseReleaseEvent(event);
}

void FieldMenu::keyPressEvent(QKeyEvent* event)
{
    // QMenu passes the tab key on to here before it looks for fields.
    if (event->key() == Qt::Key_Tab || event->key() == Qt::Key_Backtab)
        focusNextPrevChild(event->key() == Qt::Key_Tab);
    else
        QMenu::keyPressEvent(event);
}

bool FieldMenu::focusNextPrevChild(bool next)
{
    return QWidget::focusNextPrevChild(next);
}

} // namespace ui
