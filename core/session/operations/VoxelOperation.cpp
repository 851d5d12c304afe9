// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/VoxelOperation.h"

#include "core/edits/EditJson.h"
#include "core/edits/EditTask.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/open/StrokeExtension.h"
#include "core/edits/sculpt/SculptEdits.h"
#include "core/engine/EngineCommands.h"
#include "core/session/past/RecentGrowth.h"
#include "core/session/past/SeedStrokes.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace core {

namespace {

std::vector<BrickImage> imagesBefore(const std::vector<BrickChange>& changes)
{
    std::vector<BrickImage> images;
    for (const BrickChange& change : changes)
        images.push_back({change.key, change.before});
    return images;
}

} // namespace

VoxelOperation::VoxelOperation(Edit edit, Kind kind, RowId again)
    : m_edit(std::move(edit))
    , m_kind(kind)
    , m_again(again)
    , m_stroke(openStrokeOf(m_edit))
    , m_manner(m_stroke ? m_stroke->manner() : OpenManner())
{
}

bool VoxelOperation::foresee(Document& document) const
{
    return bool(applyToDocument(m_edit, document));
}

void VoxelOperation::start(SessionState& state)
{
    if (m_again == 0)
        addProtected(m_edit, state.document);
    // The edit may become one of another kind, which has another stroke.
    m_stroke.reset();
    const Result<void> named = nameWhatGrowthReads(m_edit, state.history, state.document);
    m_stroke = openStrokeOf(m_edit);
    Result<EngineEdit> edit = named ? engineEditOf(m_edit, state.document)
                                    : Result<EngineEdit>(tl::unexpected(named.error()));
    if (!edit) {
        state.fail(edit.error());
        m_refused = true;
        m_finished = isWhole();
        return;
    }
    if (auto* burst = std::get_if<GrowBurst>(&*edit))
        addSeedStrokes(*burst, m_edit, state.history, state.document);
    if (m_stroke) {
        // Before what it was told while it waited in line.
        OpenStroke::Told told = m_stroke->begin(*edit, state.document, isWhole());
        m_waiting.insert(m_waiting.begin(), std::make_move_iterator(told.begin()),
            std::make_move_iterator(told.end()));
    }
    if (isWhole()) {
        m_ending = Ending::Commit;
        keepNothing(state);
    }
    if (m_ending)
        liftPen();
    askBefore(state, *edit);
    m_mayTakeLong = mayTakeLong(*edit);
    m_begun = state.engine.submit(BeginEdit{*std::move(edit)});
    submitWaiting(state);
}

/// A seed that is not taken changes no voxel, so what there was is asked before.
void VoxelOperation::askBefore(SessionState& state, const EngineEdit& edit)
{
    const auto* stroke = std::get_if<SeedPlacement>(&edit);
    if (!stroke || m_again != 0)
        return;
    m_seeds = *stroke;
    m_asked = state.engine.submit(ReadSeedWords{.voxels = stroke->voxels, .plane = stroke->plane});
}

void VoxelOperation::takeBefore(const EngineResult& result)
{
    if (!result.error)
        m_sketched = sketchedSeeds(m_seeds, result.seedWords);
    m_seeds = {};
}

void VoxelOperation::extend(SessionState& state, const StrokeExtension& extension)
{
    if (!m_stroke || !open())
        return;
    Result<OpenStroke::Told> told = m_stroke->extend(extension, state.document);
    if (!told)
        return state.fail(told.error());
    for (EngineExtension& next : *told) {
        // Strokes of seeds are in the history, which the edit does not know.
        if (auto* anew = std::get_if<GrowAnew>(&next))
            addSeedStrokes(anew->burst, m_edit, state.history, state.document);
        m_waiting.push_back(std::move(next));
    }
    submitWaiting(state);
}

void VoxelOperation::end(SessionState& state, Ending ending)
{
    if (!open())
        return;
    m_ending = ending;
    if (ending == Ending::Commit)
        keepNothing(state);
    liftPen();
    submitWaiting(state);
}

/// An edit that is to become a row keeps nothing for a next preview, not even if it is aborted.
void VoxelOperation::keepNothing(const SessionState& state)
{
    if (!m_stroke || !m_manner.keepsForNext)
        return;
    Result<OpenStroke::Told> told = m_stroke->extend(ForgetPreview{}, state.document);
    if (told)
        std::move(told->begin(), told->end(), std::back_inserter(m_waiting));
}

/// What the end of a stroke still owes; one that has not started yet pays when it does.
void VoxelOperation::liftPen()
{
    if (!m_stroke)
        return;
    for (EngineExtension& rest : m_stroke->lift())
        m_waiting.push_back(std::move(rest));
}

void VoxelOperation::submitWaiting(SessionState& state)
{
    if (!m_begun || m_refused || m_ended)
        return;
    for (; !m_waiting.empty(); m_waiting.pop_front()) {
        ExtendEdit next;
        next.extension = std::move(m_waiting.front());
        state.engine.submit(std::move(next));
    }
    if (m_ending)
        m_ended = state.engine.submit(EndEdit{m_failed ? Ending::Rollback : *m_ending});
}

void VoxelOperation::takeResult(SessionState& state, EngineResult&& result)
{
    if (m_asked && result.ticket == *m_asked)
        return takeBefore(result);
    if (!m_begun || result.ticket < *m_begun)
        return;
    if (m_ended && result.ticket == *m_ended) {
        finish(state, std::move(result));
    } else if (result.error) {
        if (!m_failed)
            state.fail(*result.error);
        m_failed = true;
        m_refused = m_refused || (result.ticket == *m_begun && !m_ended);
        if (m_refused && m_manner.endsIfRefused)
            m_ending = Ending::Rollback; // nobody's pen is down: it ends here
    }
}

bool VoxelOperation::abandon(SessionState& state, const Error& error)
{
    if (m_finished)
        return false;
    if (!m_failed)
        state.fail(error);
    m_failed = true;
    m_waiting.clear();
    if (!m_begun) {
        m_refused = true;
        m_finished = isWhole();
    } else if (!m_ended) {
        m_ending = Ending::Rollback;
        m_ended = state.engine.submit(EndEdit{Ending::Rollback});
    }
    return true; // an end that is under way is taken back when it comes
}

bool VoxelOperation::isAbortable() const
{
    return m_mayTakeLong && m_again == 0 && m_ended && m_ending == Ending::Commit && !m_failed
        && !m_finished;
}

int VoxelOperation::percent(const SessionState& state) const
{
    return state.engine.growthProgress().percent;
}

/// If the engine has changed voxels nevertheless, they are taken back when its result arrives.
void VoxelOperation::abort(SessionState& state)
{
    if (!isAbortable())
        return;
    m_failed = true;
    state.fail({ErrorCode::Cancelled, {}});
    state.engine.giveUp(*m_ended);
}

void VoxelOperation::finish(SessionState& state, EngineResult&& result)
{
    m_finished = true;
    if (result.error && !m_failed)
        state.fail(*result.error);
    if (m_failed && !result.changes.empty())
        state.require(SwapBricks{imagesBefore(result.changes)});
    const bool movesGeneration = effectsOf(m_edit).movesGenerationOf.has_value();
    if (movesGeneration)
        state.notify(DocumentChange::What::Growth);
    if (m_edit.is<SeedStroke>())
        state.lastSketched = m_sketched;
    const bool changed = !result.changes.empty()
        || (changedPart(m_edit) && !takesVoxelsOrNothing(m_edit))
        || (m_ending == Ending::Commit && bringsNewCriteria(m_edit, state.history, state.document));
    if (result.error || m_failed || !changed) {
        if (m_again != 0 && !result.error && !m_failed)
            state.fail({ErrorCode::SessionDamaged,
                {state.file ? state.file->path() : QString(),
                    Clause::saying(
                        "row %1 changes nothing when it is carried out again", m_again)}});
        return;
    }
    if (m_again != 0) {
        state.complete(m_again, std::move(result));
        return;
    }
    if (m_stroke)
        m_stroke->carriedOut(result, isWhole());
    std::optional<std::uint32_t> generation;
    if (movesGeneration)
        generation = result.generation;
    const std::optional<LeakAlarm> alarm = result.alarm;
    state.commit(m_edit, std::move(result), generation);
    if (alarm)
        state.lastAlarm = {state.history.position(), *alarm};
}

} // namespace core
