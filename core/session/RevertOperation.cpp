// SPDX-License-Identifier: Apache-2.0
#include "core/session/RevertOperation.h"

#include "core/edits/DocumentEdits.h"
#include "core/session/RowReach.h"

#include <algorithm>
#include <bitset>
#include <iterator>
#include <utility>

namespace core {

namespace {

tl::unexpected<Error> refused(const QString& reason)
{
    return failure(ErrorCode::StepsEntangled, reason);
}

QString titled(const HistoryRow& row)
{
    return QStringLiteral("'%1' (row %2)").arg(row.name).arg(row.id);
}

std::vector<BrickKey> keysOf(const std::vector<BrickImage>& images)
{
    std::vector<BrickKey> keys;
    keys.reserve(images.size());
    for (const BrickImage& image : images)
        keys.push_back(image.key);
    return keys;
}

/// Whether segments that are locked keep their voxels.
Result<void> checkLocks(const Document& document, const std::vector<BrickChange>& now,
    const std::vector<BrickImage>& then)
{
    std::bitset<256> touched; // labels that lose or gain a voxel
    for (std::size_t brick = 0; brick < now.size(); ++brick) {
        if (now[brick].key.field != Field::Labels)
            continue;
        const std::vector<std::uint8_t>& held = now[brick].after;
        const std::vector<std::uint8_t>& coming = then[brick].bytes;
        for (std::size_t i = 0; i < std::size_t(BrickGrid::voxelsPerBrick); ++i) {
            const std::uint8_t a = held.empty() ? 0 : held[i];
            const std::uint8_t b = coming.empty() ? 0 : coming[i];
            if (a != b)
                touched.set(a).set(b);
        }
    }
    for (const Segment& segment : document.segments) {
        if (segment.locked && touched.test(segment.label))
            return failure(ErrorCode::SegmentLocked, segment.name);
    }
    return {};
}

} // namespace

RevertOperation::RevertOperation(RevertRows edit, RowId again)
    : m_edit(std::move(edit))
    , m_again(again)
{
}

bool RevertOperation::isTakenBack(RowId row) const
{
    return std::binary_search(m_edit.rows.begin(), m_edit.rows.end(), row);
}

void RevertOperation::start(SessionState& state)
{
    if (const Result<void> checked = checkRows(state); !checked)
        return giveUp(state, checked.error());
    const std::vector<RowId> path = state.history.pathTo(state.history.position());
    m_path.assign(std::find(path.begin(), path.end(), m_edit.rows.front()), path.end());
    for (const RowId row : m_path) {
        if (isTakenBack(row) || std::holds_alternative<RevertRows>(state.history.row(row).edit))
            m_toLoad.push_back(row);
    }
    loadNext(state);
}

Result<void> RevertOperation::checkRows(const SessionState& state) const
{
    const std::vector<RowId> path = state.history.pathTo(state.history.position());
    for (const RowId id : m_edit.rows) {
        if (std::find(path.begin(), path.end(), id) == path.end())
            return refused(QStringLiteral("row %1 is not among the steps done so far").arg(id));
        const HistoryRow& row = state.history.row(id);
        if (changesDocumentOnly(row.edit))
            return refused(QStringLiteral("%1 changed no voxel").arg(titled(row)));
        if (changedPart(row.edit))
            return refused(QStringLiteral("%1 changed the list of segments too").arg(titled(row)));
    }
    return {};
}

void RevertOperation::loadNext(SessionState& state)
{
    if (!m_toLoad.empty()) {
        state.worker->load(m_toLoad.back());
        return;
    }
    if (const Result<void> checked = checkReach(state); !checked)
        return giveUp(state, checked.error());
    layOver(state);
}

void RevertOperation::takeDifferences(
    SessionState& state, Result<std::vector<BrickImage>>&& differences)
{
    if (!differences)
        return giveUp(state, differences.error());
    m_differences[m_toLoad.back()] = *std::move(differences);
    m_toLoad.pop_back();
    loadNext(state);
}

Result<void> RevertOperation::checkReach(const SessionState& state) const
{
    std::map<BrickKey, RowId> taken; // and the row that wrote it first
    for (const RowId id : m_path) {
        const HistoryRow& row = state.history.row(id);
        const auto differences = m_differences.find(id);
        if (isTakenBack(id)) {
            for (const BrickKey& key : keysOf(differences->second))
                taken.emplace(key, id);
            continue;
        }
        if (changesDocumentOnly(row.edit))
            continue;
        const RowReach reach(row.edit, state.document,
            differences == m_differences.end() ? std::vector<BrickKey>()
                                               : keysOf(differences->second));
        for (const auto& [key, first] : taken) {
            if (reach.covers(key))
                return refused(QStringLiteral("%1 wrote or read the same place after %2")
                                   .arg(titled(row), titled(state.history.row(first))));
        }
    }
    return {};
}

void RevertOperation::layOver(SessionState& state)
{
    std::vector<BrickImage> taken;
    for (auto& [row, differences] : m_differences) {
        if (isTakenBack(row))
            std::move(differences.begin(), differences.end(), std::back_inserter(taken));
    }
    m_differences.clear();
    m_swap.start(state, std::move(taken), [&state](const auto& now, const auto& then) {
        return checkLocks(state.document, now, then);
    });
}

void RevertOperation::takeResult(SessionState& state, EngineResult&& result)
{
    std::optional<Result<EngineResult>> swapped = m_swap.takeResult(state, std::move(result));
    if (!swapped)
        return;
    if (*swapped)
        finish(state, **std::move(swapped));
    else
        giveUp(state, swapped->error());
}

void RevertOperation::finish(SessionState& state, EngineResult&& result)
{
    m_done = true;
    if (m_again != 0)
        state.complete(m_again, std::move(result.changes));
    else if (!result.changes.empty())
        state.commit(m_edit, std::move(result.changes), result.statistics, std::nullopt);
    state.tell(DocumentChange::What::Growth);
}

void RevertOperation::giveUp(SessionState& state, const Error& error)
{
    state.fail(error);
    m_done = true;
}

} // namespace core
