// SPDX-License-Identifier: Apache-2.0
#include "ui/models/NumberedListModel.h"

#include "ui/workspace/Workspace.h"

#include <algorithm>
#include <utility>

namespace ui {

NumberedListModel::NumberedListModel(Workspace& workspace, QObject* parent)
    : QAbstractListModel(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionChanged, this, &NumberedListModel::refresh);
}

void NumberedListModel::refresh()
{
    std::vector<int> now;
    if (const core::EditSession* session = m_workspace.session())
        now = numbers(session->document());
    if (now != m_numbers) {
        beginResetModel();
        m_numbers = std::move(now);
        endResetModel();
    } else if (!m_numbers.empty()) {
        Q_EMIT dataChanged(index(0), index(int(m_numbers.size()) - 1));
    }
}

int NumberedListModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_numbers.size());
}

int NumberedListModel::rowOf(int number) const
{
    const auto found = std::find(m_numbers.begin(), m_numbers.end(), number);
    return found == m_numbers.end() ? -1 : int(found - m_numbers.begin());
}

int NumberedListModel::numberAt(const QModelIndex& index) const
{
    const bool known = m_workspace.session() && checkIndex(index, CheckIndexOption::IndexIsValid);
    return known ? m_numbers[std::size_t(index.row())] : 0;
}

bool NumberedListModel::apply(const core::Edit& edit)
{
    const auto applied = m_workspace.session()->apply(edit);
    if (!applied)
        m_workspace.fail(applied.error());
    return applied.has_value();
}

Qt::ItemFlags NumberedListModel::flags(const QModelIndex& index) const
{
    if (!index.isValid())
        return Qt::NoItemFlags;
    return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemNeverHasChildren;
}

} // namespace ui
