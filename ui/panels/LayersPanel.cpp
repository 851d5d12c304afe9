// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/LayersPanel.h"

#include "ui/Icons.h"
#include "ui/LayerActions.h"
#include "ui/Workspace.h"
#include "ui/models/LayerListModel.h"
#include "ui/panels/LayerDelegate.h"

#include <QAction>
#include <QListView>
#include <QMenu>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {

namespace {

constexpr int mostRows = 4;

} // namespace

LayersPanel::LayersPanel(Workspace& workspace, QWidget* parent)
    : Panel(parent)
    , m_workspace(workspace)
    , m_model(new LayerListModel(workspace, this))
    , m_view(new QListView(this))
    , m_add(new QAction(stateIcon(QStringLiteral("add")), tr("Add sculpt layer"), this))
{
    m_add->setObjectName(QStringLiteral("addLayer"));
    addAction(m_add);
    m_view->setObjectName(QStringLiteral("layerList"));
    m_view->setAccessibleName(tr("Sculpt layers"));
    m_view->setModel(m_model);
    m_view->setItemDelegate(new LayerDelegate(m_view));
    m_view->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    m_view->setMouseTracking(true);
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    m_view->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_view);

    connect(m_add, &QAction::triggered, this, &LayersPanel::add);
    connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this,
        [this](const QModelIndex& current) {
            if (current.isValid())
                m_workspace.setActiveLayer(current.data(LayerListModel::IdRole).toInt());
        });
    connect(m_view, &QListView::customContextMenuRequested, this, &LayersPanel::showMenu);
    connect(m_model, &QAbstractItemModel::dataChanged, this, &LayersPanel::refresh);
    connect(m_model, &QAbstractItemModel::modelReset, this, &LayersPanel::refresh);
    refresh();
}

QString LayersPanel::title() const
{
    return tr("Sculpt layers");
}

QString LayersPanel::summary() const
{
    const int count = m_model->rowCount();
    int muted = 0;
    for (int row = 0; row < count; ++row)
        muted += m_model->index(row).data(LayerListModel::MutedRole).toBool() ? 1 : 0;
    if (muted > 0)
        return tr("%1 of %2 muted").arg(muted).arg(count);
    return count == 0 ? QString() : count == 1 ? tr("1 layer") : tr("%1 layers").arg(count);
}

void LayersPanel::refresh()
{
    m_add->setEnabled(m_workspace.session() != nullptr);
    m_view->setFixedHeight(std::clamp(m_model->rowCount(), 1, mostRows) * LayerDelegate::rowHeight);
    const int active = m_model->rowOf(m_workspace.activeLayer());
    if (active >= 0 && m_view->currentIndex().row() != active)
        m_view->setCurrentIndex(m_model->index(active));
    Q_EMIT summaryChanged(summary());
}

void LayersPanel::add()
{
    if (const auto added = addLayer(m_workspace); !added)
        m_workspace.fail(added.error());
    else
        Q_EMIT unfoldAsked();
}

void LayersPanel::move(const QModelIndex& index, int by)
{
    const core::MoveLayer edit{
        .layer = index.data(LayerListModel::IdRole).toInt(), .place = index.row() + 1 + by};
    if (const auto moved = m_workspace.session()->apply(edit); !moved)
        m_workspace.fail(moved.error());
}

void LayersPanel::showMenu(const QPoint& position)
{
    const QPersistentModelIndex index = m_view->indexAt(position);
    if (!index.isValid())
        return;
    QMenu menu(this);
    const bool muted = index.data(LayerListModel::MutedRole).toBool();
    menu.addAction(tr("Rename"), this, [this, index] { m_view->edit(index); });
    menu.addAction(muted ? tr("Unmute") : tr("Mute"), this,
        [this, index, muted] { m_model->setData(index, !muted, LayerListModel::MutedRole); });
    menu.addSeparator();
    QAction* up = menu.addAction(tr("Move up"), this, [this, index] { move(index, -1); });
    up->setEnabled(index.row() > 0);
    QAction* down = menu.addAction(tr("Move down"), this, [this, index] { move(index, 1); });
    down->setEnabled(index.row() + 1 < m_model->rowCount());
    menu.exec(m_view->viewport()->mapToGlobal(position));
}

} // namespace ui
