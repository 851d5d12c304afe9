// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/HistoryPanel.h"

#include "ui/Theme.h"
#include "ui/Workspace.h"
#include "ui/models/HistoryModel.h"
#include "ui/panels/HistoryDelegate.h"

#include <QListView>
#include <QMenu>
#include <QVBoxLayout>

namespace ui {

HistoryPanel::HistoryPanel(Workspace& workspace, QWidget* parent)
    : Panel(parent)
    , m_workspace(workspace)
    , m_model(new HistoryModel(workspace, this))
    , m_view(new QListView(this))
{
    m_view->setObjectName(QStringLiteral("historyList"));
    m_view->setAccessibleName(tr("History"));
    m_view->setModel(m_model);
    m_view->setItemDelegate(new HistoryDelegate(m_view));
    m_view->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_view->setMouseTracking(true);
    m_view->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_view->setMinimumHeight(2 * theme::rowHeight);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_view);

    // activated: double click and Return alike.
    connect(m_view, &QListView::activated, this, &HistoryPanel::goTo);
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_view, &QListView::customContextMenuRequested, this, &HistoryPanel::showMenu);
    connect(m_model, &HistoryModel::currentRowChanged, this, [this](int row) {
        if (row >= 0)
            m_view->scrollTo(m_model->index(row));
        Q_EMIT summaryChanged(summary());
    });
}

QString HistoryPanel::title() const
{
    return tr("History");
}

QString HistoryPanel::summary() const
{
    return m_model->summary();
}

void HistoryPanel::goTo(const QModelIndex& index)
{
    core::EditSession* session = m_workspace.session();
    if (!session || !index.isValid())
        return;
    const auto row = core::RowId(index.data(HistoryModel::RowIdRole).toLongLong());
    if (const auto gone = session->goTo(row); !gone)
        m_workspace.fail(gone.error());
}

void HistoryPanel::undoOnly(const QModelIndex& index)
{
    core::EditSession* session = m_workspace.session();
    if (!session || !index.isValid())
        return;
    const auto row = core::RowId(index.data(HistoryModel::RowIdRole).toLongLong());
    if (const auto applied = session->apply(core::RevertRows{{row}}); !applied)
        m_workspace.fail(applied.error());
}

void HistoryPanel::showMenu(const QPoint& position)
{
    const QModelIndex index = m_view->indexAt(position);
    if (!index.isValid())
        return;
    const bool current = index.data(HistoryModel::CurrentRole).toBool();
    const bool changedVoxels = index.data(HistoryModel::VoxelsRole).toBool();
    const bool undone = index.data(HistoryModel::UndoneRole).toBool();
    QMenu menu(this);
    menu.addAction(tr("Go to this step"), this, [this, index] { goTo(index); })
        ->setEnabled(!current);
    menu.addAction(tr("Undo only this step"), this, [this, index] { undoOnly(index); })
        ->setEnabled(changedVoxels && !undone);
    menu.exec(m_view->viewport()->mapToGlobal(position));
}

} // namespace ui
