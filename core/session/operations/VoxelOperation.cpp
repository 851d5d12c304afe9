// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/VoxelOperation.h"

#include "core/edits/EditJson.h"
#include "core/edits/EditTask.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "core/edits/kinds/sculpt/PeelCut.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/edits/open/StrokeExtension.h"
#include "core/edits/sculpt/SculptEdits.h"
#include "core/engine/EngineCommands.h"
#include "core/session/past/RecentGrowth.h"
#include "core/session/past/SeedStrokes.h"

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
{
}

/// Keeps what its extensions go by.
Result<EngineEdit> VoxelOperation::engineEdit(const Document& document)
{
    Result<EngineEdit> edit = engineEditOf(m_edit, document);
    if (!edit)
        return edit;
    if (const auto* shrink = std::get_if<ShrinkGrowth>(&*edit))
        m_firstGeneration = shrink->generation;
    m_path = samplerOf(m_edit, *edit);
    return edit;
}

bool VoxelOperation::foresee(Document& document) const
{
    return bool(applyToDocument(m_edit, document));
}

void VoxelOperation::start(SessionState& state)
{
    if (m_again == 0)
        addProtected(m_edit, state.document);
    const std::vector<PenSample>* samples = penSamplesOf(m_edit);
    const Result<void> named = nameWhatGrowthReads(m_edit, state.history, state.document);
    Result<EngineEdit> edit =
        named ? engineEdit(state.document) : Result<EngineEdit>(tl::unexpected(named.error()));
    if (!edit) {
        state.fail(edit.error());
        m_refused = true;
        m_finished = m_kind == Kind::Whole;
        return;
    }
    if (auto* burst = std::get_if<GrowBurst>(&*edit))
        addSeedStrokes(*burst, m_edit, state.history, state.document);
    // Samples of a stroke that had to wait in line are all in the edit by now.
    if (samples && !samples->empty())
        m_waiting.push_front(DrillPath{m_path->add(*samples)});
    if (const auto* peel = m_edit.as<PeelCut>())
        m_waiting.push_front(peelDepth(*peel));
    const VolumeGeometry& geometry = state.document.volumes.front().geometry;
    if (const auto* paint = m_edit.as<PaintStroke>())
        m_waiting.push_front(paintPath(*paint, geometry));
    else if (const BrushPath* path = brushPathOf(m_edit))
        m_waiting.push_front(CapsulePath{capsules(*path, geometry)});
    const std::optional<int>* steps = growStepsOf(m_edit);
    if (steps && m_kind == Kind::Whole && steps->value_or(1) > 0)
        m_waiting.push_back(GrowAdvance{.steps = steps->value_or(GrowAdvance::toClosure)});
    if (m_kind == Kind::Whole)
        m_ending = Ending::Commit;
    if (m_ending)
        liftPen();
    askBefore(state, *edit);
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
    if (const auto* pen = std::get_if<PenSamples>(&extension))
        extendDrill(state, pen->samples);
    else if (const auto* path = std::get_if<PathPoints>(&extension))
        extendPath(state, path->pointsLps, path->lifted, path->pressures);
    else if (const auto* depth = std::get_if<ToDepth>(&extension))
        setPeelDepth(state, depth->mm);
    else if (const auto* shrink = std::get_if<ToSteps>(&extension))
        setShrinkSteps(state, shrink->steps);
    else if (const auto* interval = std::get_if<ToInterval>(&extension))
        setInterval(state, interval->lower, interval->upper);
    else if (const auto* advance = std::get_if<GrowAdvance>(&extension))
        extendGrowth(state, *advance);
    else if (std::holds_alternative<PauseGrowth>(extension))
        extendGrowth(state, GrowPause{});
    else
        forgetPreview(state);
}

void VoxelOperation::extendDrill(SessionState& state, const std::vector<PenSample>& samples)
{
    std::vector<PenSample>* told = penSamplesOf(m_edit);
    if (!told || !open() || samples.empty())
        return;
    const double last = told->empty() ? 0.0 : told->back().tSeconds;
    const std::vector<PenSample> sound = soundSamples(samples, last);
    if (m_path)
        m_waiting.push_back(DrillPath{m_path->add(sound)});
    told->insert(told->end(), sound.begin(), sound.end());
    submitWaiting(state);
}

void VoxelOperation::extendPath(SessionState& state, const std::vector<glm::dvec3>& pointsLps,
    bool lifted, const std::vector<double>& pressures)
{
    BrushPath* path = brushPathOf(m_edit);
    if (!path || !open() || pointsLps.empty())
        return;
    PartPressures pressed{
        .before = path->pressures && !path->pressures->empty() ? path->pressures->back() : 1.0};
    pressed.atPoints = continuePressures(path->pressures, pointsLps.size(), pressures);
    if (m_begun) {
        const glm::dvec3 last = path->pointsLps.back();
        const glm::dvec3* from = lifted ? nullptr : &last;
        const VolumeGeometry& geometry = state.document.volumes.front().geometry;
        const auto* paint = m_edit.as<PaintStroke>();
        pressed.ofTolerance = paint && paint->toleranceByPressure.value_or(false);
        CapsulePath further{capsules(*path, geometry, from, pointsLps, pressed)};
        if (paint && paint->edgeTolerance)
            further.under = voxelsUnder(*path, geometry, from, pointsLps);
        m_waiting.push_back(std::move(further));
    }
    if (lifted)
        path->lifts.push_back(std::int64_t(path->pointsLps.size()));
    path->pointsLps.insert(path->pointsLps.end(), pointsLps.begin(), pointsLps.end());
    submitWaiting(state);
}

void VoxelOperation::setPeelDepth(SessionState& state, double depthMm)
{
    auto* peel = m_edit.as<PeelCut>();
    if (!peel || !open() || peel->depthMm == depthMm)
        return;
    peel->depthMm = depthMm;
    if (m_begun)
        m_waiting.push_back(peelDepth(*peel));
    submitWaiting(state);
}

void VoxelOperation::setShrinkSteps(SessionState& state, int steps)
{
    if (!open())
        return;
    if (auto* shrink = m_edit.as<ShrinkSteps>()) {
        shrink->steps = steps;
        if (m_begun)
            m_waiting.push_back(shrinkTo());
    } else if (isBackwards() && steps > 0) {
        // It begins with the steps that it was begun with: as an extension more of them are no
        // error where they would take everything.
        m_waiting.push_back(CutFurther{.steps = std::uint32_t(steps)});
    }
    submitWaiting(state);
}

bool VoxelOperation::isBackwards() const
{
    const auto* shrink = m_edit.as<ShrinkAt>();
    return shrink && shrink->steps;
}

/// @pre a ShrinkSteps that has begun
ShrinkTo VoxelOperation::shrinkTo() const
{
    const int steps = *m_edit.get<ShrinkSteps>().steps;
    return {.keep = m_firstGeneration - std::min(std::uint32_t(steps), m_firstGeneration)};
}

void VoxelOperation::extendGrowth(SessionState& state, EngineExtension extension)
{
    if (!isGrowth() || !open())
        return;
    m_waiting.push_back(std::move(extension));
    submitWaiting(state);
}

void VoxelOperation::setInterval(SessionState& state, double lower, double upper)
{
    auto* change = m_edit.as<ChangeInterval>();
    if (!change || !open())
        return;
    change->criteria.lower = lower;
    change->criteria.upper = upper;
    if (m_begun) {
        Result<GrowBurst> burst = growBurst(*change, state.document);
        if (!burst)
            return state.fail(burst.error());
        addSeedStrokes(*burst, m_edit, state.history, state.document);
        m_waiting.push_back(GrowAnew{*std::move(burst)});
    }
    submitWaiting(state);
}

void VoxelOperation::forgetPreview(SessionState& state)
{
    if (!isPreview() || !open())
        return;
    m_waiting.push_back(ForgetSpread{});
    submitWaiting(state);
}

void VoxelOperation::end(SessionState& state, Ending ending)
{
    if (!open())
        return;
    m_ending = ending;
    liftPen();
    submitWaiting(state);
}

/// What the end of a stroke still owes; one that has not started yet pays when it does.
void VoxelOperation::liftPen()
{
    if (m_path)
        m_waiting.push_back(DrillPath{m_path->finish()});
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
        if (m_refused && (isPreview() || isThreshold()))
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
        m_finished = m_kind == Kind::Whole;
    } else if (!m_ended) {
        m_ending = Ending::Rollback;
        m_ended = state.engine.submit(EndEdit{Ending::Rollback});
    }
    return true; // an end that is under way is taken back when it comes
}

void VoxelOperation::finish(SessionState& state, EngineResult&& result)
{
    m_finished = true;
    if (result.error && !m_failed)
        state.fail(*result.error);
    if (m_failed && !result.changes.empty())
        state.require(SwapBricks{imagesBefore(result.changes)});
    const bool movesGeneration = effectsOf(m_edit).movesGeneration;
    if (movesGeneration)
        state.notify(DocumentChange::What::Growth);
    if (m_edit.is<SeedStroke>())
        state.lastSketched = m_sketched;
    const bool changed = !result.changes.empty()
        || (changedPart(m_edit) && !takesVoxelsOrNothing(m_edit))
        || (m_ending == Ending::Commit && bringsNewCriteria(m_edit, state.history));
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
    const Edit edit = carriedOut(result);
    std::optional<std::uint32_t> generation;
    if (movesGeneration)
        generation = result.generation;
    const std::optional<LeakAlarm> alarm = result.alarm;
    state.commit(edit, std::move(result), generation);
    if (alarm)
        state.lastAlarm = {state.history.position(), *alarm};
}

/// The edit as replay must repeat it: a burst or a cut backwards that the user watched says how far
/// it came, and so does a burst that was stopped by its guard.
Edit VoxelOperation::carriedOut(const EngineResult& result) const
{
    Edit done = m_edit;
    if (isBackwards() && m_kind == Kind::Interactive)
        done.as<ShrinkAt>()->steps = result.statistics.generations;
    if (!isGrowth() || (m_kind == Kind::Whole && !result.alarm))
        return done;
    std::optional<int>& steps = *growStepsOf(done);
    steps.reset();
    if (!result.atClosure) {
        const auto generations = std::uint32_t(result.statistics.generations);
        steps = grownSteps(result.generation - generations, result.statistics, result.facts);
    }
    return done;
}

} // namespace core
