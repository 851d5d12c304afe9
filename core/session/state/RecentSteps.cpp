// SPDX-License-Identifier: Apache-2.0
#include "core/session/state/RecentSteps.h"

namespace core {

namespace {

std::size_t bytesOf(const std::vector<BrickChange>& changes)
{
    std::size_t sum = sizeof(BrickChange) * changes.size();
    for (const BrickChange& change : changes)
        sum += change.before.size() + change.after.size();
    return sum;
}

} // namespace

void RecentSteps::setMostBytes(std::size_t bytes)
{
    m_mostBytes = bytes;
    shrink();
}

void RecentSteps::keep(RowId row, const Changes& changes, bool takenBack)
{
    if (const auto known = m_places.find(row); known != m_places.end()) {
        m_bytes -= known->second->bytes;
        m_steps.erase(known->second);
    }
    m_places[row] = m_steps.insert(m_steps.end(),
        {.row = row, .changes = changes, .takenBack = takenBack, .bytes = bytesOf(*changes)});
    m_bytes += m_steps.back().bytes;
    shrink();
}

std::optional<std::vector<BrickImage>> RecentSteps::images(RowId row, bool withRow)
{
    const auto found = m_places.find(row);
    if (found == m_places.end())
        return std::nullopt;
    const Step& step = *found->second;
    m_steps.splice(m_steps.end(), m_steps, found->second);
    std::vector<BrickImage> images;
    images.reserve(step.changes->size());
    for (const BrickChange& change : *step.changes)
        images.push_back({change.key, withRow != step.takenBack ? change.after : change.before});
    return images;
}

void RecentSteps::shrink()
{
    while (m_bytes > m_mostBytes) {
        m_bytes -= m_steps.front().bytes;
        m_places.erase(m_steps.front().row);
        m_steps.pop_front();
    }
}

} // namespace core
