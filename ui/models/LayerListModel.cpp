// SPDX-License-Identifier: Apache-2.0
#include "ui/models/LayerListModel.h"

#include "core/edits/kinds/layers/ChangeLayer.h"
#include "ui/workspace/LayerLooks.h"
#include "ui/workspace/Workspace.h"

namespace ui {

LayerListModel::LayerListModel(Workspace& workspace, QObject* parent)
    : NumberedListModel(workspace, parent)
{
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::Layers)
                refresh();
        });
    connect(&workspace, &Workspace::activeLayerChanged, this, &LayerListModel::refresh);
    connect(&workspace.layerLooks(), &LayerLooks::changed, this, &LayerListModel::refresh);
    refresh();
}

std::vector<int> LayerListModel::numbers(const core::Document& document) const
{
    std::vector<int> ids;
    for (const core::SculptLayer& layer : document.layers)
        ids.push_back(layer.id);
    return ids;
}

const core::SculptLayer* LayerListModel::layerAt(const QModelIndex& index) const
{
    const int id = numberAt(index);
    return id == 0 ? nullptr : m_workspace.session()->document().layer(id);
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
                            : tr("%1\nThe eye mutes it; Ctrl: solo").arg(layer->name);
    case IdRole:
        return int(layer->id);
    case MutedRole:
        return layer->muted;
    case SoloRole:
        return layer->solo;
    case CarvesRole:
        return carves;
    case HidesRole:
        return m_workspace.layerLooks().look(layer->id).hides;
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
    return apply(edit);
}

} // namespace ui
