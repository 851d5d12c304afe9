// SPDX-License-Identifier: Apache-2.0
#include "core/history/History.h"

#include "core/edits/EditNames.h"

#include <algorithm>
#include <set>
#include <utility>

namespace core {

std::vector<RowId> History::pathTo(RowId id) const
{
    std::vector<RowId> path;
    for (; id != 0; id = row(id).parent)
        path.push_back(id);
    std::reverse(path.begin(), path.end());
    return path;
}

std::vector<RowId> History::standing(RowId id) const
{
    // From the newest on, so that a row is known to stand before it takes others back.
    std::vector<RowId> stands;
    std::set<RowId> taken;
    for (; id != 0; id = row(id).parent) {
        if (taken.count(id) != 0)
            continue;
        stands.push_back(id);
        const std::vector<RowId> rows = rowsTakenBackBy(row(id).edit);
        taken.insert(rows.begin(), rows.end());
    }
    std::reverse(stands.begin(), stands.end());
    return stands;
}

std::vector<RowId> History::line() const
{
    RowId tip = m_position;
    while (const RowId next = m_lastChild[std::size_t(tip)])
        tip = next;
    return pathTo(tip);
}

RowId History::append(HistoryRow row)
{
    row.id = RowId(m_rows.size()) + 1;
    row.parent = m_position;
    m_rows.push_back(std::move(row));
    m_lastChild.push_back(0);
    moveTo(m_rows.back().id);
    return m_position;
}

void History::moveTo(RowId id)
{
    m_position = id;
    for (; id != 0; id = row(id).parent)
        m_lastChild[std::size_t(row(id).parent)] = id;
}

History History::restored(std::vector<HistoryRow> rows,
    const std::vector<std::pair<RowId, RowId>>& visited, RowId position)
{
    History history;
    history.m_rows = std::move(rows);
    history.m_lastChild.assign(history.m_rows.size() + 1, 0);
    for (const HistoryRow& row : history.m_rows)
        history.m_lastChild[std::size_t(row.parent)] = row.id;
    for (const auto& [parent, child] : visited)
        history.m_lastChild[std::size_t(parent)] = child;
    history.moveTo(position);
    return history;
}

} // namespace core
