// SPDX-License-Identifier: Apache-2.0
#include "ui/models/LayerListModel.h"

#include "ui/Workspace.h"

#include <algorithm>
#include <utility>

namespace ui {

LayerListModel::LayerListModel(Workspace& workspace, QObject* parent)
    : QAbstractListModel(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionChanged, this, &LayerListModel::refresh);
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::Layers)
                refresh();
        });
    connect(&workspace, &Workspace::activeLayerChanged, this, &LayerListModel::refresh);
    refresh();
}

void LayerListModel::refresh()
{
    std::vector<int> ids;
    if (const core::EditSession* session = m_workspace.session()) {
        for (const core::SculptLayer& layer : session->document().layers)
            ids.push_back(layer.id);
    }
    if (ids != m_ids) {
        beginResetModel();
        m_ids = std::move(ids);
        endResetModel();
    } else if (!m_ids.empty()) {
        Q_EMIT dataChanged(index(0), index(int(m_ids.size()) - 1));
    }
}

int LayerListModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_ids.size());
}

int LayerListModel::rowOf(int layer) const
{
    const auto found = std::find(m_ids.begin(), m_ids.end(), layer);
    return found == m_ids.end() ? -1 : int(found - m_ids.begin());
}

const core::SculptLayer* LayerListModel::layerAt(const QModelIndex& index) const
{
    const core::EditSession* session = m_workspace.session();
    if (!session || !checkIndex(index, CheckIndexOption::IndexIsValid))
        return nullptr;
    return session->document().layer(m_ids[std::size_t(index.row())]);
}

QVariant LayerListModel::data(const QModelIndex& index, int role) const
{
    const core::SculptLayer* layer = layerAt(index);
    if (!layer)
        return {};
    const bool carves = m_workspace.session()->document().carves(*layer);
    switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
        return layer->name;
    case Qt::AccessibleTextRole:
        return tr("%1, %2").arg(layer->name,
            layer->muted      ? tr("muted")
                : !carves     ? tr("left out")
                : layer->solo ? tr("solo")
                              : tr("carves"));
    case Qt::ToolTipRole:
        return layer->muted ? tr("%1 is muted: what it carves is shown").arg(layer->name)
            : !carves       ? tr("%1 is left out while another layer is solo").arg(layer->name)
                            : tr("%1\nThe eye mutes it; Alt: solo").arg(layer->name);
    case IdRole:
        return int(layer->id);
    case MutedRole:
        return layer->muted;
    case SoloRole:
        return layer->solo;
    case CarvesRole:
        return carves;
    case ActiveRole:
        return layer->id == m_workspace.activeLayer();
    default:
        return {};
    }
}

bool LayerListModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    const core::SculptLayer* layer = layerAt(index);
    if (!layer)
        return false;
    core::ChangeLayer edit;
    edit.layer = layer->id;
    if (role == Qt::EditRole) {
        const QString name = value.toString().trimmed();
        if (name.isEmpty() || name == layer->name)
            return false;
        edit.name = name;
    } else if (role == MutedRole) {
        edit.muted = value.toBool();
    } else if (role == SoloRole) {
        edit.solo = value.toBool();
    } else {
        return false;
    }
    const auto applied = m_workspace.session()->apply(edit);
    if (!applied)
        m_workspace.fail(applied.error());
    return applied.has_value();
}

Qt::ItemFlags LayerListModel::flags(const QModelIndex& index) const
{
    if (!index.isValid())
        return Qt::NoItemFlags;
    return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemNeverHasChildren;
}

} // namespace ui
