// SPDX-License-Identifier: Apache-2.0
#include "core/session/CommitWorker.h"

#include <utility>

namespace core {

CommitWorker::CommitWorker(const BrickGrid& grid, SessionFile* file, std::function<void()> wakeUp)
    : m_grid(grid)
    , m_file(file)
    , m_wakeUp(std::move(wakeUp))
{
}

void CommitWorker::start(std::vector<BrickImage> bricks)
{
    m_thread.post([this, bricks = std::move(bricks)] { m_hash.update(bricks); });
}

void CommitWorker::commit(RowId row, Changes changes, QByteArray documentJson)
{
    m_thread.post([this, row, changes = std::move(changes), json = std::move(documentJson)] {
        m_hash.update(*changes);
        complete(row, json, makeDelta(*changes, m_grid));
    });
}

void CommitWorker::commit(
    RowId row, std::shared_ptr<const SurfaceStep> step, QByteArray documentJson)
{
    m_thread.post([this, row, step = std::move(step), json = std::move(documentJson)] {
        complete(row, json, packed(*step));
    });
}

void CommitWorker::complete(RowId row, const QByteArray& documentJson, BrickDelta delta)
{
    Report done{.row = row,
        .deltaBytes = delta.bytes(),
        .stateHash = m_hash.root(documentJson),
        .differences = {}};
    if (m_file)
        m_file->completeRow(row, done.stateHash, delta);
    else
        m_deltas[row] = std::move(delta);
    report(std::move(done));
}

void CommitWorker::move(Changes changes)
{
    m_thread.post([this, changes = std::move(changes)] { m_hash.update(*changes); });
}

void CommitWorker::load(RowId row)
{
    m_thread.post([this, row] {
        report({.row = row, .deltaBytes = 0, .stateHash = {}, .differences = differencesOf(row)});
    });
}

Result<std::vector<BrickImage>> CommitWorker::differencesOf(RowId row)
{
    if (!m_file)
        return expandDelta(m_deltas[row], m_grid);
    const Result<BrickDelta> delta = m_file->readDelta(row);
    if (!delta)
        return tl::unexpected(delta.error());
    Result<std::vector<BrickImage>> differences = expandDelta(*delta, m_grid);
    if (!differences)
        return failure(ErrorCode::SessionDamaged, m_file->path(),
            QStringLiteral("row %1: %2").arg(row).arg(differences.error().arguments.value(0)));
    return differences;
}

void CommitWorker::report(Report report)
{
    {
        const std::lock_guard lock(m_mutex);
        m_reports.push_back(std::move(report));
    }
    if (m_wakeUp)
        m_wakeUp();
}

std::vector<CommitWorker::Report> CommitWorker::collect()
{
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_reports, {});
}

QByteArray CommitWorker::stateHash(const QByteArray& documentJson)
{
    QByteArray hash;
    m_thread.run([&] { hash = m_hash.root(documentJson); });
    return hash;
}

} // namespace core
