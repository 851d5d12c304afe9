// SPDX-License-Identifier: Apache-2.0
#include "ui/base/Actions.h"

#include "ui/base/Icons.h"

#include <QMenu>
#include <QStringList>
#include <QWidget>

namespace ui {

Actions::Actions(QWidget& window)
    : QObject(&window)
    , m_window(window)
{
}

QAction& Actions::add(Entry entry)
{
    Q_ASSERT_X(!m_actions.contains(entry.id), "Actions", qPrintable(entry.id));
    auto* action = new QAction(entry.text, this);
    action->setObjectName(entry.id);
    action->setShortcuts(entry.keys);
    if (!entry.tip.isEmpty())
        action->setToolTip(entry.tip);
    if (!entry.icon.isEmpty())
        action->setIcon(stateIcon(entry.icon));
    action->setIconVisibleInMenu(false);
    action->setCheckable(bool(entry.checked));
    connect(action, &QAction::triggered, this, [this, run = entry.run] {
        run();
        refresh();
    });
    m_window.addAction(action);
    m_actions.insert(entry.id, action);
    m_entries.push_back(std::move(entry));
    return *action;
}

QAction& Actions::operator[](const QString& id) const
{
    QAction* action = m_actions.value(id);
    Q_ASSERT_X(action, "Actions", qPrintable(id));
    return *action;
}

std::vector<QAction*> Actions::all() const
{
    std::vector<QAction*> actions;
    for (const Entry& entry : m_entries)
        actions.push_back(&(*this)[entry.id]);
    return actions;
}

void Actions::fill(QMenu& menu, const QStringList& ids)
{
    connect(&menu, &QMenu::aboutToShow, this, &Actions::refresh, Qt::UniqueConnection);
    for (const QString& id : ids) {
        if (id.isEmpty())
            menu.addSeparator();
        else
            menu.addAction(&(*this)[id]);
    }
}

void Actions::refresh()
{
    for (const Entry& entry : m_entries) {
        QAction& action = (*this)[entry.id];
        if (entry.possible)
            action.setEnabled(entry.possible());
        if (entry.checked)
            action.setChecked(entry.checked());
        if (entry.currentText)
            action.setText(entry.currentText());
    }
}

} // namespace ui
