// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/SurfaceOperation.h"

#include "core/base/Guarded.h"
#include "core/edits/EditTask.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/WriteBack.h"
#include "core/edits/kinds/surface/parts/SurfacePath.h"
#include "core/edits/open/StrokeExtension.h"
#include "core/engine/EngineCommands.h"

#include <utility>

namespace core {

SurfaceOperation::SurfaceOperation(Edit edit, Kind kind, RowId again)
    : m_edit(std::move(edit))
    , m_manner(openMannerOf(m_edit))
    , m_kind(kind)
    , m_again(again)
{
    if (m_kind == Kind::Whole)
        m_ending = Ending::Commit;
}

bool SurfaceOperation::foresee(Document& document) const
{
    return bool(applyToDocument(m_edit, document));
}

void SurfaceOperation::start(SessionState& state)
{
    // What waited in line may meet another document than the one it was checked against.
    if (const Result<void> checked = checkAgainst(state.document, m_edit); !checked)
        return giveUp(state, checked.error());
    if (const std::optional<VoxelBox> grey = greyBoxOf(m_edit, state.surface)) {
        m_read.greyBox = *grey;
        m_asked = state.engine.submit(ReadCodes{*grey});
        return;
    }
    if (!readsLabels(m_edit))
        return work(state);
    const int label = m_edit.is<LaySurface>() ? m_edit.get<LaySurface>().segment
                                              : state.document.surface->segment;
    m_reading.emplace(state.surface.geometry().size, state.document.segment(label)->plane);
    readOn(state);
}

void SurfaceOperation::readOn(SessionState& state)
{
    if (!m_reading->ask(state.engine))
        work(state);
}

void SurfaceOperation::takeResult(SessionState& state, EngineResult&& result)
{
    if (m_asked && result.ticket == *m_asked) {
        m_asked.reset();
        if (result.error)
            return giveUp(state, *result.error);
        m_read.codes = std::move(result.codes);
        work(state);
    } else if (m_reading && m_reading->awaits(result.ticket)) {
        if (const Result<void> taken = m_reading->take(result); !taken)
            return giveUp(state, taken.error());
        readOn(state);
    } else if (m_written && result.ticket == *m_written) {
        m_done = true;
        if (result.error)
            return reportFailure(state, *result.error);
        if (m_reported)
            return; // it was abandoned
        const auto* writes = m_edit.as<WriteBack>();
        if (m_again != 0)
            state.complete(m_again, std::move(result));
        else if (!result.changes.empty()
            || (writes && agreesAfterwards(*writes) && state.document.surface->isApart()))
            state.commit(m_edit, std::move(result), {});
    } else if (m_begun && result.ticket == *m_begun && result.error) {
        giveUp(state, *result.error);
    }
}

void SurfaceOperation::abort()
{
    if (!isAbortable())
        return;
    m_isAborted = true;
    if (m_work)
        m_work->cancel();
}

bool SurfaceOperation::isAbortable() const
{
    const bool isMoving = m_manner.withoutPen && !m_hasBegun && m_ending != Ending::Rollback;
    return !m_done && (fitsWholeSurface(m_edit) || isMoving);
}

void SurfaceOperation::work(SessionState& state)
{
    if (m_isAborted)
        return giveUp(state, {ErrorCode::Cancelled, {}});
    if (m_edit.is<WriteBack>())
        m_read.past = surfacePast(state.history, state.surface);
    m_work = std::make_shared<SurfaceWork>(
        state.surface, *surfaceEditOf(m_edit), state.document, std::move(m_read));
    if (m_reading) {
        post(state,
            [work = m_work,
                reader = std::make_shared<LabelReader>(std::move(m_reading->reader()))] {
                work->setLabels(reader->takeLabels());
                return SideThread::Sequel();
            });
        m_reading.reset();
    }
    const SurfacePath* known = surfacePathOf(m_edit);
    post(state, [this, work = m_work, path = known ? *known : SurfacePath()] {
        const Result<void> begun = work->begin();
        work->add(path.pointsLps, path.pressures.value_or(std::vector<double>()));
        // It is told at once: whoever looks at what he began waits for something to be seen.
        return SideThread::Sequel([this, begun](SessionState& now) {
            m_hasBegun = true;
            if (!begun && !isTakenBack(begun.error()))
                reportFailure(now, begun.error());
        });
    });
    if (m_ending)
        end(state, *m_ending);
}

void SurfaceOperation::extend(SessionState& state, const StrokeExtension& extension)
{
    const auto* further = std::get_if<PathPoints>(&extension);
    SurfacePath* const extended = surfacePathOf(m_edit);
    if (!further || !extended || !open() || further->pointsLps.empty())
        return;
    const std::vector<glm::dvec3>& pointsLps = further->pointsLps;
    SurfacePath& path = *extended;
    path.pointsLps.insert(path.pointsLps.end(), pointsLps.begin(), pointsLps.end());
    const std::vector<double> pressed =
        continuePressures(path.pressures, pointsLps.size(), further->pressures);
    // What waits in line still gets them with the edit.
    if (m_work) {
        post(state, [work = m_work, pointsLps, pressed] {
            work->add(pointsLps, pressed);
            return SideThread::Sequel();
        });
    }
}

void SurfaceOperation::end(SessionState& state, Ending ending)
{
    m_ending = ending;
    if (!m_work)
        return;
    // What is taken back need not be waited for.
    if (ending == Ending::Rollback)
        m_work->cancel();
    endWork(state, ending);
}

void SurfaceOperation::endWork(
    SessionState& state, Ending ending, const std::optional<Error>& failed)
{
    state.side->post(
        [this, work = m_work, ending, failed] {
            if (failed)
                work->fail(*failed);
            auto outcome = std::make_shared<Result<SurfaceWork::Outcome>>(work->end(ending));
            return SideThread::Sequel(
                [this, outcome](SessionState& known) { finish(known, std::move(*outcome)); });
        },
        [this](SessionState& known, const Error& error) { finish(known, tl::unexpected(error)); });
    m_isEnding = true;
}

/// What the side thread has of it may be half done: it is taken back there, and what was a whole
/// step by then when it comes.
bool SurfaceOperation::abandon(SessionState& state, const Error& error)
{
    if (m_done || m_written || m_isAbandoned || m_again != 0)
        return false;
    reportFailure(state, error);
    m_isAbandoned = true;
    m_ending = Ending::Rollback;
    if (m_work) {
        m_work->cancel();
        if (!m_isEnding)
            endWork(state, Ending::Rollback, error);
    } else if (m_begun) {
        m_written = state.engine.submit(EndEdit{Ending::Rollback});
    } else {
        m_done = true;
    }
    return true;
}

/// What is thrown before the end is what the end says, too.
void SurfaceOperation::post(SessionState& state, std::function<SideThread::Sequel()> work)
{
    state.side->post(
        [work = std::move(work), surface = m_work] {
            try {
                return work();
            } catch (...) {
                surface->fail(errorBeingHandled());
                throw;
            }
        },
        [this](SessionState& known, const Error& error) { reportFailure(known, error); });
}

void SurfaceOperation::finish(SessionState& state, Result<SurfaceWork::Outcome>&& outcome)
{
    m_work.reset();
    if (!outcome && !state.surface.isIntact())
        state.lose(outcome.error());
    if (!outcome)
        return giveUp(state, outcome.error());
    if (m_isAbandoned) {
        if (outcome->step) {
            state.surface.takeBack(*outcome->step);
            state.surface.showAll(state.document.surface.has_value());
        }
        m_done = true;
        return;
    }
    // What was rolled back may end as if nothing had been aborted; whoever aborts is told.
    if (m_isAborted && m_ending == Ending::Rollback)
        return giveUp(state, {ErrorCode::Cancelled, {}});
    if (outcome->voxels)
        return write(state, *std::move(outcome->voxels));
    m_done = true;
    if (outcome->step && m_again != 0)
        state.completeSurface(m_again, outcome->step);
    else if (outcome->step)
        state.commitSurface(m_edit, outcome->step, outcome->remark);
}

void SurfaceOperation::write(SessionState& state, EngineEdit&& edit)
{
    m_begun = state.engine.submit(BeginEdit{std::move(edit)});
    m_written = state.engine.submit(EndEdit{Ending::Commit});
}

void SurfaceOperation::giveUp(SessionState& state, const Error& error)
{
    if (!m_done && !isTakenBack(error))
        reportFailure(state, error);
    m_done = true;
}

/// Who takes something back is not told that it came to nothing.
bool SurfaceOperation::isTakenBack(const Error& error) const
{
    return error.code == ErrorCode::Cancelled && m_ending == Ending::Rollback && !m_isAborted;
}

void SurfaceOperation::reportFailure(SessionState& state, const Error& error)
{
    if (!m_reported)
        state.fail(error);
    m_reported = true;
}

ShowSurface::ShowSurface(SurfaceState::Listener listener)
    : m_listener(std::move(listener))
{
}

void ShowSurface::start(SessionState& state)
{
    state.surface.setListener(std::move(m_listener));
    state.surface.showAll(state.document.surface.has_value());
    m_done = true;
}

} // namespace core
