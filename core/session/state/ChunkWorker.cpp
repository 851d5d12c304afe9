// SPDX-License-Identifier: Apache-2.0
#include "core/session/state/ChunkWorker.h"

#include "core/edits/kinds/chunks/ChunkVoxels.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/engine/EditEngine.h"
#include "core/engine/EngineCommands.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <new>
#include <utility>

namespace core {

namespace {

constexpr std::int64_t voxelsAtOnce = std::int64_t(1) << 21; ///< frames come in between

/// Of the work, in the order of ChunkTree::of(); up to which per cent of the whole, about.
constexpr int fetched = 5;
constexpr std::array stepEnds{fetched, 35, 65, 100};

tl::unexpected<Error> tooLarge(const VoxelBox& box)
{
    if (box.empty()) // it is not even known
        return failure(ErrorCode::OutOfMemory,
            Clause::saying("what belongs to whom around the segment cannot be unpacked here"));
    const glm::ivec3 size = box.maximum - box.minimum;
    return failure(ErrorCode::OutOfMemory,
        Clause::saying("%1 million voxels are too many to be divided into chunks here; a smaller "
                       "margin takes less",
            (std::int64_t(size.x) * size.y * size.z >> 20) + 1));
}

} // namespace

/// From the edit to the answer; the thread's until it is prepared, and from the last answered
/// question on.
struct ChunkWorker::Job {
    Job()
        : progress([this](ProgressStep now, int done, int total) { note(now, done, total); })
    {
    }
    void note(ProgressStep now, int done, int total)
    {
        const std::lock_guard lock(mutex);
        if (isRough)
            return; // its steps come again
        if (now != stage.step) {
            stage.step = now;
            step = std::min(step + 1, stepEnds.size() - 1);
        }
        const int from = stepEnds[step - 1];
        stage.percent = from + int(std::int64_t(stepEnds[step] - from) * done / std::max(1, total));
    }

    [[nodiscard]] ChunkSource source() const
    {
        return {.size = owned.box.maximum - owned.box.minimum,
            .codes = codes,
            .owners = owned.owners,
            .probabilities = owned.probabilities,
            .likely = owned.segment};
    }

    OwnedBox owned; ///< the thread's until it is prepared
    std::vector<std::uint16_t> codes;
    std::size_t asked = 0;
    std::size_t questions = 0; ///< that are not answered
    Progress progress;
    std::mutex mutex;
    bool prepared = false; ///< under mutex, like the rest: the codes can be asked for
    std::optional<Result<Map>> outcome;
    Coarse coarse;
    bool isRough = false; ///< coarse chunks are being computed
    ChunkStage stage;
    std::size_t step = 0; ///< of stepEnds
};

ChunkWorker::ChunkWorker(EditEngine& engine, const VolumeGeometry& geometry,
    std::function<void()> wakeUp, std::int64_t coarseFrom)
    : m_engine(engine)
    , m_geometry(geometry)
    , m_wakeUp(std::move(wakeUp))
    , m_coarseFrom(coarseFrom)
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
    m_coarse.reset();
    m_failure.reset();
    m_isUnreported = false;
    m_row = 0;
}

void ChunkWorker::want(RowId row, const DivideSegment& edit)
{
    if (m_row == row)
        return;
    drop();
    m_row = row;
    m_job = std::make_shared<Job>();
    m_thread.post([this, job = m_job, edit] { prepare(*job, edit); },
        [this, job = m_job](const Error& error) { setOutcome(*job, tl::unexpected(error)); });
}

void ChunkWorker::finishPreparing()
{
    if (m_job && m_job->asked == 0)
        m_thread.finish();
}

/// On the worker's thread: what the edit holds is unpacked, of millions of voxels perhaps.
void ChunkWorker::prepare(Job& job, const DivideSegment& edit) const
{
    if (job.progress.cancelled())
        return; // nobody wants it any more
    try {
        Result<OwnedBox> owned = ownedBox(edit, m_geometry);
        if (!owned)
            return setOutcome(job, tl::unexpected(owned.error()));
        job.owned = *std::move(owned);
        job.codes.reserve(job.owned.owners.size());
    } catch (const std::bad_alloc&) {
        return setOutcome(job, tooLarge(job.owned.box));
    }
    {
        const std::lock_guard lock(job.mutex);
        job.prepared = true;
    }
    if (m_wakeUp && !job.progress.cancelled())
        m_wakeUp();
}

void ChunkWorker::ask(const std::shared_ptr<Job>& job)
{
    const VoxelBox& box = job->owned.box;
    const glm::ivec3 size = box.maximum - box.minimum;
    const auto slices =
        int(std::max<std::int64_t>(1, voxelsAtOnce / (std::int64_t(size.x) * size.y)));
    for (int z = box.minimum.z; z < box.maximum.z; z += slices) {
        VoxelBox part = box;
        part.minimum.z = z;
        part.maximum.z = std::min(z + slices, box.maximum.z);
        m_asked.emplace(m_engine.submit(ReadCodes{part}), job);
        ++job->questions;
    }
    job->asked = job->questions;
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
        fail(*result.error);
        m_news = true;
        return true;
    }
    // Answers come in the order of the questions.
    job->codes.insert(job->codes.end(), result.codes.begin(), result.codes.end());
    if (--job->questions == 0)
        m_thread.post([this, job] { workOut(*job); },
            [this, job](const Error& error) { setOutcome(*job, tl::unexpected(error)); });
    return true;
}

void ChunkWorker::workOut(Job& job)
{
    workOutRoughly(job);
    setOutcome(job, mapOf(job));
}

/// If it fails, nothing is seen until the chunks are there.
void ChunkWorker::workOutRoughly(Job& job) const
{
    if (std::int64_t(job.codes.size()) < m_coarseFrom)
        return;
    {
        const std::lock_guard lock(job.mutex);
        job.isRough = true;
    }
    Coarse coarse;
    try {
        Result<CoarseChunks> made = CoarseChunks::of(job.source(), job.owned.box, job.progress);
        if (made)
            coarse = std::make_shared<const CoarseChunks>(*std::move(made));
    } catch (const std::bad_alloc&) {
        coarse.reset();
    }
    const bool isMade = coarse != nullptr;
    {
        const std::lock_guard lock(job.mutex);
        job.isRough = false;
        job.coarse = std::move(coarse);
    }
    if (isMade && m_wakeUp && !job.progress.cancelled())
        m_wakeUp();
}

void ChunkWorker::setOutcome(Job& job, Result<Map> outcome) const
{
    {
        const std::lock_guard lock(job.mutex);
        job.outcome = std::move(outcome);
    }
    if (m_wakeUp && !job.progress.cancelled())
        m_wakeUp();
}

Result<ChunkWorker::Map> ChunkWorker::mapOf(Job& job) const
{
    const VoxelBox& box = job.owned.box;
    try {
        const ChunkSource source = job.source();
        Result<ChunkTree> tree = ChunkTree::of(source, job.progress);
        if (!tree)
            return tl::unexpected(tree.error());
        // Without it chunks are as good, and only nothing is suggested.
        ChunkSurvey survey;
        try {
            survey = ChunkSurvey::of(source, *tree);
        } catch (const std::bad_alloc&) {
            survey = {};
        }
        return std::make_shared<const ChunkMap>(
            m_geometry.size, box, *std::move(tree), std::move(survey));
    } catch (const std::bad_alloc&) {
        return tooLarge(box);
    }
}

bool ChunkWorker::collect()
{
    if (!m_job)
        return std::exchange(m_news, false);
    std::optional<Result<Map>> outcome;
    bool prepared = false;
    Coarse coarse;
    {
        const std::lock_guard lock(m_job->mutex);
        coarse = std::exchange(m_job->coarse, nullptr);
        outcome = std::exchange(m_job->outcome, std::nullopt);
        prepared = std::exchange(m_job->prepared, false);
    }
    if (prepared) {
        try {
            ask(m_job);
        } catch (const std::bad_alloc&) {
            fail(tooLarge(m_job->owned.box).value());
            return true;
        }
    }
    if (!outcome && !coarse)
        return false;
    m_coarse = std::move(coarse);
    if (!outcome)
        return true;
    m_coarse.reset();
    if (*outcome) {
        m_job.reset();
        m_map = **std::move(outcome);
    } else {
        fail(outcome->error());
    }
    return true;
}

void ChunkWorker::fail(const Error& error)
{
    m_job.reset();
    m_coarse.reset();
    m_failure = error;
    m_isUnreported = true;
}

std::optional<Error> ChunkWorker::takeUnreported()
{
    return std::exchange(m_isUnreported, false) ? m_failure : std::nullopt;
}

void ChunkWorker::forgetFailure()
{
    if (m_failure)
        drop();
}

void ChunkWorker::cancel()
{
    if (!m_job)
        return;
    m_job->progress.cancel();
    fail({ErrorCode::Cancelled, {}});
    m_isUnreported = false;
    m_news = true;
    if (m_wakeUp)
        m_wakeUp();
}

ChunkWorker::Map ChunkWorker::map(RowId row) const
{
    return row == m_row ? m_map : nullptr;
}

ChunkWorker::Coarse ChunkWorker::coarse(RowId row) const
{
    return row == m_row ? m_coarse : nullptr;
}

std::optional<Error> ChunkWorker::whyNot(RowId row) const
{
    return row == m_row ? m_failure : std::nullopt;
}

std::optional<ChunkStage> ChunkWorker::stage() const
{
    if (!m_job)
        return std::nullopt;
    const std::lock_guard lock(m_job->mutex);
    if (m_job->step > 0)
        return m_job->stage;
    const std::size_t answered = m_job->asked - m_job->questions;
    return ChunkStage{.step = ProgressStep::FetchingValues,
        .percent = int(std::size_t(fetched) * answered / std::max<std::size_t>(1, m_job->asked))};
}

} // namespace core
