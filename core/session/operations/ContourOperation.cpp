// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/ContourOperation.h"

#include "core/contour/ContourRule.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/engine/EngineCommands.h"

#include <algorithm>
#include <utility>

namespace core {

namespace {

constexpr int codesAtOnce = 1 << 21; ///< 4 MiB; one slice where it has more

} // namespace

ContourOperation::ContourOperation(const EvolveContour& edit, RowId again)
    : m_edit(edit)
    , m_work(std::make_shared<Work>())
    , m_relabelling(again)
{
}

void ContourOperation::start(SessionState& state)
{
    // What waited in line may meet another document than the one it was checked against.
    if (const Result<void> checked = checkAgainst(state.document, m_edit); !checked)
        return m_relabelling.giveUp(state, checked.error());
    m_reader.emplace(state.document.volumes.front().geometry.size,
        state.document.segment(m_edit.segment)->plane);
    readLabels(state);
}

void ContourOperation::readLabels(SessionState& state)
{
    if (m_work->progress.cancelled())
        return m_relabelling.giveUp(state, {ErrorCode::Cancelled, {}});
    if (std::optional<ReadBricks> question = m_reader->next()) {
        m_asked = state.engine.submit(*std::move(question));
        return;
    }
    findGround(state);
}

void ContourOperation::findGround(SessionState& state)
{
    state.side->post(
        [this, edit = m_edit, work = m_work, document = state.document,
            reader = std::make_shared<LabelReader>(*std::move(m_reader))] {
            std::optional<Error> failed;
            if (Result<ContourGround> ground = contourGround(edit, document, reader->takeLabels()))
                work->ground = *std::move(ground);
            else
                failed = ground.error();
            return SideThread::Sequel([this, failed](SessionState& known) {
                if (failed)
                    return m_relabelling.giveUp(known, *failed);
                m_nextSlice = m_work->ground.box.minimum.z;
                readCodes(known);
            });
        },
        [this](SessionState& known, const Error& error) { m_relabelling.giveUp(known, error); });
    m_reader.reset();
}

void ContourOperation::readCodes(SessionState& state)
{
    if (m_work->progress.cancelled())
        return m_relabelling.giveUp(state, {ErrorCode::Cancelled, {}});
    VoxelBox slab = m_work->ground.box;
    if (slab.empty())
        return m_relabelling.leaveNoRow(state);
    if (m_nextSlice >= slab.maximum.z)
        return evolve(state);
    const glm::ivec3 extent = slab.maximum - slab.minimum;
    const int slices = std::max(1, int(codesAtOnce / (std::int64_t(extent.x) * extent.y)));
    slab.minimum.z = m_nextSlice;
    slab.maximum.z = std::min(m_nextSlice + slices, slab.maximum.z);
    m_nextSlice = slab.maximum.z;
    m_asked = state.engine.submit(ReadCodes{slab});
}

void ContourOperation::evolve(SessionState& state)
{
    state.side->post(
        [this, edit = m_edit, work = m_work, document = state.document] {
            auto relabel = std::make_shared<Result<RelabelListed>>(evolved(edit, document, *work));
            return SideThread::Sequel(
                [this, relabel](SessionState& known) { write(known, std::move(*relabel)); });
        },
        [this](SessionState& known, const Error& error) { m_relabelling.giveUp(known, error); });
}

Result<RelabelListed> ContourOperation::evolved(
    const EvolveContour& edit, const Document& document, Work& work)
{
    constexpr std::int64_t percents = 100;
    Result<ContourRule> rule = contourRule(edit, document);
    if (!rule)
        return tl::unexpected(rule.error());
    for (std::vector<std::uint16_t>& slab : work.slabs) {
        work.ground.codes.insert(work.ground.codes.end(), slab.begin(), slab.end());
        std::vector<std::uint16_t>().swap(slab);
    }
    ContourEvolution evolution(*std::move(rule), std::move(work.ground));
    while (evolution.generation() < edit.generations && evolution.step(work.progress))
        work.percent = int(percents * evolution.generation() / edit.generations);
    if (work.progress.cancelled())
        return failure(ErrorCode::Cancelled);
    return relabelListed(edit, document, evolution);
}

void ContourOperation::write(SessionState& state, Result<RelabelListed>&& relabel)
{
    if (!relabel)
        return m_relabelling.giveUp(state, relabel.error());
    if (m_work->progress.cancelled())
        return m_relabelling.giveUp(state, {ErrorCode::Cancelled, {}});
    m_isWriting = true;
    m_relabelling.write(state, m_edit, *std::move(relabel));
}

void ContourOperation::takeResult(SessionState& state, EngineResult&& result)
{
    if (!m_asked || result.ticket != *m_asked)
        return m_relabelling.takeResult(state, std::move(result));
    m_asked.reset();
    if (result.error)
        return m_relabelling.giveUp(state, *result.error);
    if (m_reader) {
        if (const Result<void> taken = m_reader->take(result); !taken)
            return m_relabelling.giveUp(state, taken.error());
        return readLabels(state);
    }
    // The side thread rests meanwhile.
    m_work->slabs.push_back(std::move(result.codes));
    readCodes(state);
}

void ContourOperation::abort()
{
    if (isAbortable())
        m_work->progress.cancel();
}

} // namespace core
