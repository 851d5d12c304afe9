// SPDX-License-Identifier: Apache-2.0
#include "core/session/state/CommitWorker.h"

#include "core/base/Guarded.h"

#include <chrono>
#include <thread>
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
    post([this, bricks = std::move(bricks)] { m_hash.update(bricks); });
}

/// Work that may be done over.
void CommitWorker::post(std::function<void()> work)
{
    m_thread.post([this, work = std::move(work)] { attempt(work); },
        [this](const Error& error) {
            m_failed = true;
            report({.error = error});
        });
}

/// Memory may be there again in a moment; a row that is not completed ends the session.
void CommitWorker::attempt(const std::function<void()>& work)
{
    constexpr int tries = 5;
    constexpr std::chrono::milliseconds pause{20};
    if (m_failed)
        return;
    for (int i = 1; i < tries; ++i) {
        if (guarded(work))
            return;
        std::this_thread::sleep_for(pause);
    }
    work();
}

void CommitWorker::commit(RowId row, Changes changes, QByteArray documentJson)
{
    post([this, row, changes = std::move(changes), json = std::move(documentJson)] {
        m_hash.update(*changes);
        complete(row, json, makeDelta(*changes, m_grid));
    });
}

void CommitWorker::commit(
    RowId row, std::shared_ptr<const SurfaceStep> step, QByteArray documentJson)
{
    post([this, row, step = std::move(step), json = std::move(documentJson)] {
        complete(row, json, packed(*step));
    });
}

void CommitWorker::complete(RowId row, const QByteArray& documentJson, BrickDelta delta)
{
    Report done{.row = row,
        .deltaBytes = delta.bytes(),
        .stateHash = m_hash.root(documentJson),
        .differences = {}};
    {
        // So that nothing is thrown behind what cannot be done over.
        const std::lock_guard lock(m_mutex);
        m_reports.reserve(m_reports.size() + 1);
    }
    if (m_file)
        m_file->completeRow(row, done.stateHash, delta);
    else
        m_deltas[row] = std::move(delta);
    report(std::move(done));
}

void CommitWorker::move(Changes changes)
{
    post([this, changes = std::move(changes)] { m_hash.update(*changes); });
}

void CommitWorker::load(RowId row, bool words)
{
    m_thread.post(
        [this, row, words] {
            report({.row = row,
                .deltaBytes = 0,
                .stateHash = {},
                .differences = differencesOf(row, words)});
        },
        [this, row](
            const Error& error) { report({.row = row, .differences = tl::unexpected(error)}); });
}

Result<RowDifferences> CommitWorker::differencesOf(RowId row, bool words)
{
    Result<std::vector<BrickImage>> images = imagesOf(row);
    if (!images)
        return tl::unexpected(images.error());
    RowDifferences differences;
    if (words)
        differences.words = changedWords(*images, m_grid);
    differences.images = *std::move(images);
    return differences;
}

Result<std::vector<BrickImage>> CommitWorker::imagesOf(RowId row)
{
    if (!m_file)
        return expandDelta(m_deltas[row], m_grid);
    const Result<BrickDelta> delta = m_file->readDelta(row);
    if (!delta)
        return tl::unexpected(delta.error());
    Result<std::vector<BrickImage>> differences = expandDelta(*delta, m_grid);
    if (!differences)
        return failure(ErrorCode::SessionDamaged, m_file->path(),
            Clause::saying("row %1: %2", row, differences.error().arguments.value(0)));
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
