// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/lists/LayerDelegate.h"

#include "ui/base/Theme.h"
#include "ui/models/LayerListModel.h"

#include <cmath>

namespace ui {

EyeRowDelegate::Row LayerDelegate::row(const QModelIndex& index) const
{
    const bool active = index.data(LayerListModel::ActiveRole).toBool();
    const bool muted = index.data(LayerListModel::MutedRole).toBool();
    const bool solo = index.data(LayerListModel::SoloRole).toBool();
    const bool carves = index.data(LayerListModel::CarvesRole).toBool();
    const double hides = index.data(LayerListModel::HidesRole).toDouble();
    return {.active = active,
        .eyeOpen = !muted,
        .counts = carves,
        .state = muted    ? tr("muted")
            : !carves     ? tr("left out")
            : hides < 1.0 ? tr("hides %1 %").arg(std::lround(100.0 * hides))
            : solo        ? tr("solo")
            : active      ? tr("carved")
                          : QString(),
        // An active layer that does not carve takes no stroke: the user must know why.
        .stateColour = !carves && active ? theme::caution
            : solo                       ? theme::accent
                                         : theme::secondary};
}

void LayerDelegate::eyeClicked(
    QAbstractItemModel& model, const QModelIndex& index, Qt::KeyboardModifiers modifiers)
{
    const bool solo = modifiers.testFlag(Qt::ControlModifier);
    const int role = solo ? LayerListModel::SoloRole : LayerListModel::MutedRole;
    model.setData(index, !index.data(role).toBool(), role);
}

} // namespace ui
