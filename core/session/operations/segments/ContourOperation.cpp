// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/segments/ContourOperation.h"

#include "core/contour/ContourRule.h"
#include "core/engine/EngineCommands.h"

#include <utility>

namespace core {

ContourOperation::ContourOperation(const EvolveContour& edit, RowId again)
    : WorkedOutOperation(edit, Kind::Whole, again)
    , m_work(std::make_shared<Work>())
{
}

void ContourOperation::start(SessionState& state)
{
    if (!mayStart(state))
        return;
    m_reading.emplace(state.document.volumes.front().geometry.size,
        state.document.segment(contour().segment)->plane);
    readLabels(state);
}

void ContourOperation::readLabels(SessionState& state)
{
    if (!mayGoOn(state))
        return;
    if (m_reading->ask(state.engine))
        return;
    findGround(state);
}

void ContourOperation::findGround(SessionState& state)
{
    workAside(state,
        [this, edit = contour(), work = m_work, watch = watch(), document = state.document,
            reader = std::make_shared<LabelReader>(std::move(m_reading->reader()))] {
            std::optional<Error> failed;
            if (Result<ContourGround> ground =
                    contourGround(edit, document, reader->takeLabels(), watch->progress))
                work->ground = *std::move(ground);
            else
                failed = ground.error();
            return SideThread::Sequel([this, failed](SessionState& known) {
                if (failed)
                    return giveUp(known, *failed);
                m_slabs = CodeSlabs(m_work->ground.box);
                readCodes(known);
            });
        });
    m_reading.reset();
}

void ContourOperation::readCodes(SessionState& state)
{
    if (!mayGoOn(state))
        return;
    if (m_work->ground.box.empty())
        return leaveAsItIs(state);
    if (const std::optional<VoxelBox> slab = m_slabs.take())
        m_asked = state.engine.submit(ReadCodes{*slab});
    else
        evolve(state);
}

void ContourOperation::evolve(SessionState& state)
{
    workAside(
        state, [this, edit = contour(), work = m_work, watch = watch(), document = state.document] {
            auto listed = std::make_shared<Result<Listed>>(evolved(edit, document, *work, *watch));
            return SideThread::Sequel(
                [this, listed](SessionState& known) { write(known, std::move(*listed)); });
        });
}

Result<RelabelListed> ContourOperation::evolved(
    const EvolveContour& edit, const Document& document, Work& work, Watch& watch)
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
    while (evolution.generation() < edit.generations && evolution.step(watch.progress))
        watch.percent = int(percents * evolution.generation() / edit.generations);
    if (watch.progress.cancelled())
        return failure(ErrorCode::Cancelled);
    return relabelListed(edit, document, evolution);
}

void ContourOperation::takeResult(SessionState& state, EngineResult&& result)
{
    if (m_reading && m_reading->awaits(result.ticket)) {
        if (const Result<void> taken = m_reading->take(result); !taken)
            return giveUp(state, taken.error());
        return readLabels(state);
    }
    if (!m_asked || result.ticket != *m_asked)
        return takeWritten(state, std::move(result));
    m_asked.reset();
    if (result.error)
        return giveUp(state, *result.error);
    // The side thread rests meanwhile.
    m_work->slabs.push_back(std::move(result.codes));
    readCodes(state);
}

} // namespace core
