// SPDX-License-Identifier: Apache-2.0
#include "core/session/ChunkWorker.h"

#include <algorithm>
#include <utility>

namespace core {

namespace {

constexpr std::int64_t voxelsAtOnce = std::int64_t(1) << 21; ///< frames come in between

} // namespace

ChunkWorker::ChunkWorker(
    EditEngine& engine, const VolumeGeometry& geometry, std::function<void()> wakeUp)
    : m_engine(engine)
    , m_geometry(geometry)
    , m_wakeUp(std::move(wakeUp))
{
}

ChunkWorker::~ChunkWorker()
{
    drop();
}

void ChunkWorker::drop()
{
    if (m_job)
        m_job->progress.cancel();
    m_job.reset();
    m_map.reset();
    m_failure.reset();
    m_row = 0;
}

void ChunkWorker::want(RowId row, const Chunks& edit)
{
    if (m_row == row)
        return;
    drop();
    m_row = row;
    Result<OwnedBox> owned = ownedBox(edit, m_geometry);
    if (!owned) {
        m_failure = owned.error();
        m_news = true;
        return;
    }
    m_job = std::make_shared<Job>();
    m_job->owned = *std::move(owned);
    ask(m_job);
}

void ChunkWorker::ask(const std::shared_ptr<Job>& job)
{
    const VoxelBox& box = job->owned.box;
    const glm::ivec3 size = box.maximum - box.minimum;
    const auto slices =
        int(std::max<std::int64_t>(1, voxelsAtOnce / (std::int64_t(size.x) * size.y)));
    job->codes.reserve(job->owned.owners.size());
    for (int z = box.minimum.z; z < box.maximum.z; z += slices) {
        VoxelBox part = box;
        part.minimum.z = z;
        part.maximum.z = std::min(z + slices, box.maximum.z);
        m_asked.emplace(m_engine.submit(ReadCodes{part}), job);
        ++job->questions;
    }
}

bool ChunkWorker::take(const EngineResult& result)
{
    const auto asked = m_asked.find(result.ticket);
    if (asked == m_asked.end())
        return false;
    const std::shared_ptr<Job> job = std::move(asked->second);
    m_asked.erase(asked);
    if (job != m_job)
        return true; // nobody wants it any more
    if (result.error) {
        m_failure = result.error;
        m_job.reset();
        m_news = true;
        return true;
    }
    // Answers come in the order of the questions.
    job->codes.insert(job->codes.end(), result.codes.begin(), result.codes.end());
    if (--job->questions == 0)
        m_thread.post([this, job] { workOut(*job); });
    return true;
}

void ChunkWorker::workOut(Job& job)
{
    const VoxelBox& box = job.owned.box;
    Result<ChunkTree> tree = ChunkTree::of(
        {.size = box.maximum - box.minimum, .codes = job.codes, .owners = job.owned.owners},
        job.progress);
    Result<Map> outcome = tree
        ? Result<Map>(std::make_shared<const ChunkMap>(m_geometry.size, box, *std::move(tree)))
        : Result<Map>(tl::unexpected(tree.error()));
    {
        const std::lock_guard lock(m_mutex);
        job.outcome = std::move(outcome);
    }
    if (m_wakeUp && !job.progress.cancelled())
        m_wakeUp();
}

bool ChunkWorker::collect()
{
    if (!m_job)
        return std::exchange(m_news, false);
    std::optional<Result<Map>> outcome;
    {
        const std::lock_guard lock(m_mutex);
        outcome = std::exchange(m_job->outcome, std::nullopt);
    }
    if (!outcome)
        return false;
    m_job.reset();
    if (*outcome)
        m_map = **std::move(outcome);
    else
        m_failure = outcome->error();
    return true;
}

ChunkWorker::Map ChunkWorker::map(RowId row) const
{
    return row == m_row ? m_map : nullptr;
}

std::optional<Error> ChunkWorker::whyNot(RowId row) const
{
    return row == m_row ? m_failure : std::nullopt;
}

} // namespace core
