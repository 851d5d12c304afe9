// SPDX-License-Identifier: Apache-2.0
#include "core/session/RevertOperation.h"

#include "core/edits/DocumentEdits.h"
#include "core/session/RowReach.h"

#include <algorithm>
#include <bitset>
#include <utility>

namespace core {

namespace {

tl::unexpected<Error> refused(const QString& reason)
{
    return failure(ErrorCode::StepsEntangled, reason);
}

QString titled(const HistoryRow& row)
{
    return QStringLiteral("step %1 ('%2')").arg(row.id).arg(row.name);
}

std::vector<BrickKey> keysOf(const std::vector<BrickImage>& images)
{
    std::vector<BrickKey> keys;
    keys.reserve(images.size());
    for (const BrickImage& image : images)
        keys.push_back(image.key);
    return keys;
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
            return refused(QStringLiteral("step %1 is not among the steps done so far").arg(id));
        const HistoryRow& row = state.history.row(id);
        if (changesDocumentOnly(row.edit))
            return refused(QStringLiteral("%1 changed no voxel").arg(titled(row)));
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
    read(state);
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

void RevertOperation::read(SessionState& state)
{
    std::vector<BrickKey> keys;
    for (const auto& [row, differences] : m_differences) {
        if (!isTakenBack(row))
            continue;
        for (const BrickImage& difference : differences)
            keys.push_back(difference.key);
    }
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    m_reading = state.engine.submit(ReadBricks{std::move(keys)});
}

void RevertOperation::takeResult(SessionState& state, EngineResult&& result)
{
    const bool read = m_reading && result.ticket == *m_reading;
    const bool swapped = m_swapping && result.ticket == *m_swapping;
    if (!read && !swapped)
        return;
    if (result.error)
        return giveUp(state, *result.error);
    if (swapped)
        return finish(state, std::move(result));

    std::map<BrickKey, BrickImage> images;
    for (const BrickChange& now : result.changes)
        images[now.key] = {now.key, now.after};
    for (const auto& [row, differences] : m_differences) {
        if (!isTakenBack(row))
            continue;
        for (const BrickImage& difference : differences)
            images[difference.key] = exclusiveOr(images[difference.key], difference);
    }
    m_differences.clear();
    if (const Result<void> checked = checkLocks(state, images, result.changes); !checked)
        return giveUp(state, checked.error());
    SwapBricks swap;
    for (auto& [key, image] : images)
        swap.bricks.push_back(std::move(image));
    m_reading.reset();
    m_swapping = state.engine.submit(std::move(swap));
}

Result<void> RevertOperation::checkLocks(const SessionState& state,
    const std::map<BrickKey, BrickImage>& images, const std::vector<BrickChange>& now) const
{
    std::bitset<256> touched; // labels that lose or gain a voxel
    for (const BrickChange& brick : now) {
        if (brick.key.field != Field::Labels)
            continue;
        const std::vector<std::uint8_t>& then = images.at(brick.key).bytes;
        for (std::size_t i = 0; i < std::size_t(BrickGrid::voxelsPerBrick); ++i) {
            const std::uint8_t a = brick.after.empty() ? 0 : brick.after[i];
            const std::uint8_t b = then.empty() ? 0 : then[i];
            if (a != b)
                touched.set(a).set(b);
        }
    }
    for (const Segment& segment : state.document.segments) {
        if (segment.locked && touched.test(segment.label))
            return refused(QStringLiteral("segment '%1' is locked").arg(segment.name));
    }
    return {};
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
