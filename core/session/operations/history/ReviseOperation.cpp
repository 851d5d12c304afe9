// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/history/ReviseOperation.h"

#include "core/edits/EditJson.h"
#include "core/edits/engine/SegmentProtection.h"
#include "core/edits/kinds/parts/ProtectedSegments.h"
#include "core/edits/sculpt/CutAlone.h"
#include "core/engine/EngineCommands.h"
#include "core/session/past/GuardedLabels.h"
#include "core/session/past/RowDependencies.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace core {

namespace {

tl::unexpected<Error> revisionRefused(const Clause& reason)
{
    return failure(ErrorCode::InvalidField, QStringLiteral("reviseStroke.row"), reason);
}

std::vector<StandingStroke> before(const std::vector<StandingStroke>& strokes, RowId row)
{
    std::vector<StandingStroke> result;
    std::copy_if(strokes.begin(), strokes.end(), std::back_inserter(result),
        [row](const StandingStroke& stroke) { return stroke.row < row; });
    return result;
}

bool protectsSegments(const StandingStroke& stroke)
{
    const Edit edit = stroke.form.plain();
    const ProtectedSegments* protectedSegments = protectedSegmentsOf(edit);
    return protectedSegments && *protectedSegments;
}

/// The first stroke that counts otherwise now than it did; 0: none.
RowId firstDifference(
    const std::vector<StandingStroke>& then, const std::vector<StandingStroke>& now)
{
    const auto [a, b] = std::mismatch(then.begin(), then.end(), now.begin(), now.end());
    RowId first = 0;
    if (a != then.end())
        first = a->row;
    if (b != now.end())
        first = first == 0 ? b->row : std::min(first, b->row);
    return first;
}

} // namespace

ReviseOperation::ReviseOperation(ReviseStroke edit, RowId again)
    : m_edit(std::move(edit))
    , m_again(again)
{
}

void ReviseOperation::start(SessionState& state)
{
    if (const Result<void> found = findStrokes(state); !found) {
        state.fail(found.error());
        m_done = true;
        return;
    }
    const bool labels = protectsSegments(m_before)
        || std::any_of(m_strokes.begin(), m_strokes.end(), protectsSegments);
    m_fold = std::make_shared<StrokeFold>(StrokeFold{.past = PastCoverage(m_path, labels)});
    m_toLoad = m_path;
    loadNext(state);
}

Result<void> ReviseOperation::findStrokes(const SessionState& state)
{
    const History& history = state.history;
    const std::vector<RowId> path = history.pathTo(history.position());
    if (std::find(path.begin(), path.end(), m_edit.row) == path.end())
        return revisionRefused(
            Clause::saying("row %1 is not among the steps done so far", m_edit.row));
    const std::optional<SculptEdit> drawn = sculptEdit(history.row(m_edit.row).edit);
    if (!drawn)
        return revisionRefused(Clause::saying("row %1 is no cut", m_edit.row));
    m_strokes = standingStrokes(history, history.position());
    const auto target = std::find_if(m_strokes.begin(), m_strokes.end(),
        [this](const StandingStroke& stroke) { return stroke.row == m_edit.row; });
    if (target == m_strokes.end())
        return revisionRefused(Clause::saying("row %1 was taken back", m_edit.row));
    m_before = *target;
    const Result<SculptEdit> after = revised(*drawn, m_edit);
    if (!after)
        return tl::unexpected(after.error());
    m_after = {.row = m_edit.row, .form = *after, .removed = m_edit.removed};
    const int layer = layerOf(*after);
    if (!state.document.layer(layer))
        return failure(ErrorCode::InvalidField, QStringLiteral("reviseStroke.layer"),
            Clause::saying("there is no sculpt layer %1", layer));
    // Its ranges are those of the cut that is revised.
    if (const Result<Edit> known = editFromJson(editToJson(after->plain())); !known)
        return tl::unexpected(known.error());
    if (const Result<WholeCut> cut = cutAlone(*after, state.document, std::uint8_t(layer)); !cut)
        return tl::unexpected(cut.error());
    *target = m_after;

    // What is recorded before a row serves as the ground to fold on only if the strokes until then
    // still count as they did.
    RowId first = m_edit.row;
    for (RowId earlier = first; earlier != 0;) {
        first = earlier;
        earlier = firstDifference(
            standingStrokes(history, history.row(first).parent), before(m_strokes, first));
    }
    if (const Result<void> checked = checkLayers(state, first); !checked)
        return checked;
    m_strokes.erase(std::remove_if(m_strokes.begin(), m_strokes.end(),
                        [first](const StandingStroke& s) { return s.row < first || s.removed; }),
        m_strokes.end());
    m_path.assign(std::find(path.begin(), path.end(), first), path.end());
    return {};
}

Result<void> ReviseOperation::checkLayers(const SessionState& state, RowId first) const
{
    const History& history = state.history;
    const auto writes = [&](RowId row) {
        const Edit& edit = history.row(row).edit;
        return writesLayer(edit, layerOf(m_before.form))
            || writesLayer(edit, layerOf(m_after.form));
    };
    const auto writers = [&](RowId at) {
        std::vector<RowId> rows = history.standing(at);
        rows.erase(
            std::remove_if(rows.begin(), rows.end(), [&writes](RowId row) { return !writes(row); }),
            rows.end());
        return rows;
    };
    // Of those that are part of the ground none may be gone, and none may have come since.
    const std::vector<RowId> ground = writers(history.row(first).parent);
    const std::vector<RowId> now = writers(history.position());
    std::vector<RowId> differing;
    std::set_symmetric_difference(
        ground.begin(), ground.end(), now.begin(), now.end(), std::back_inserter(differing));
    if (differing.empty())
        return {};
    const RowId row = differing.back();
    return failure(ErrorCode::InvalidField, QStringLiteral("reviseStroke.row"),
        Clause::saying("row %1 cannot be worked out anew, because '%2' (row %3) has written its "
                       "layer otherwise than by cutting",
            m_edit.row, history.row(row).name, row));
}

void ReviseOperation::loadNext(SessionState& state)
{
    if (!m_toLoad.empty()) {
        state.worker->load(m_toLoad.back());
        m_isLoading = true;
        return;
    }
    await(state.engine.submit(ReadBricks{m_fold->past.keys()}),
        [this](SessionState& now, EngineResult&& read) {
            m_fold->past.addImages(read.changes);
            cutTarget(now);
        });
}

void ReviseOperation::takeDifferences(SessionState& state, Result<RowDifferences>&& differences)
{
    m_isLoading = false;
    if (m_isAbandoned) {
        m_done = true; // it has only read
        return;
    }
    if (!differences)
        return giveUp(state, differences.error());
    m_fold->past.addDifferences(m_toLoad.back(), std::move(differences->images));
    m_toLoad.pop_back();
    loadNext(state);
}

void ReviseOperation::await(Ticket ticket, Then then)
{
    m_awaited = ticket;
    m_first = m_first.value_or(ticket);
    m_then = std::move(then);
}

void ReviseOperation::takeResult(SessionState& state, EngineResult&& result)
{
    if (m_isAbandoned)
        return takeBack(state, result);
    // Before the first there may be late answers to operations that have given up.
    if ((!m_then && !m_aside.isAway()) || !m_first || result.ticket < *m_first)
        return;
    if (result.error && !m_refused)
        m_refused = result.error;
    if (!m_then || result.ticket != m_awaited)
        return;
    if (m_refused) {
        // All that was asked for until then has been done or refused by now.
        m_fold->past.discard(result);
        return giveUp(
            state, withSegmentName(*std::exchange(m_refused, std::nullopt), state.document));
    }
    std::exchange(m_then, nullptr)(state, std::move(result));
}

void ReviseOperation::workAside(SessionState& state, std::function<Sequel(StrokeFold&)> work)
{
    m_aside.post(
        *state.side, [fold = m_fold, work = std::move(work)] { return work(*fold); },
        [this](SessionState& now, const Error& error) { giveUp(now, error); });
}

void ReviseOperation::goBefore(SessionState& state, RowId row, Sequel then)
{
    workAside(state, [this, row, then = std::move(then)](StrokeFold& fold) {
        fold.past.walkBefore(row);
        return Sequel([this, row, then](SessionState& now) {
            m_fold->past.putBefore(now, row);
            then(now);
        });
    });
}

void ReviseOperation::cut(SessionState& state, const StandingStroke& stroke,
    std::function<void(SessionState&, StrokeCut)> then)
{
    if (stroke.removed)
        return then(state, {});
    const Result<Ticket> ticket = m_fold->past.cut(state, stroke.form);
    if (!ticket)
        return giveUp(state, ticket.error());
    await(*ticket, [this, then = std::move(then)](SessionState& now, EngineResult&& result) {
        then(now, m_fold->past.cutOf(std::move(result)));
    });
}

void ReviseOperation::cutTarget(SessionState& state)
{
    goBefore(state, m_edit.row, [this](SessionState& there) {
        cut(there, m_before, [this](SessionState& now, StrokeCut cutBefore) {
            m_fold->cutBefore = std::move(cutBefore);
            // The layer that the cut stands in is emptied before the next one.
            m_fold->past.putBefore(now, m_edit.row);
            cut(now, m_after, [this](SessionState& then, StrokeCut cutAfter) {
                m_fold->cutAfter = std::move(cutAfter);
                compareTarget(then);
            });
        });
    });
}

void ReviseOperation::compareTarget(SessionState& state)
{
    const bool isOfOther = layerOf(m_before.form) != layerOf(m_after.form);
    workAside(state, [this, isOfOther](StrokeFold& fold) {
        const bool isMoved = isOfOther || fold.cutBefore != fold.cutAfter;
        return Sequel([this, isMoved](SessionState& now) { chooseBricks(now, isMoved); });
    });
}

void ReviseOperation::chooseBricks(SessionState& state, bool isMoved)
{
    StrokeFold& fold = *m_fold;
    if (isMoved) {
        for (const auto* each : {&m_before, &m_after}) {
            for (const auto& [brick, bytes] : each == &m_before ? fold.cutBefore : fold.cutAfter) {
                const BrickKey key{Field::Coverage, std::uint8_t(layerOf(each->form)), brick};
                fold.bricks[key] = {key, {}};
            }
        }
    }
    const auto misses = [&](const StandingStroke& stroke) {
        if (stroke.row == m_edit.row)
            return false;
        const RowDependencies dependencies(stroke.form.plain(), state.document, {});
        return std::none_of(fold.bricks.begin(), fold.bricks.end(),
            [&dependencies](const auto& brick) { return dependencies.covers(brick.first); });
    };
    m_strokes.erase(std::remove_if(m_strokes.begin(), m_strokes.end(), misses), m_strokes.end());

    ReadBricks unknown;
    for (const auto& [key, image] : fold.bricks) {
        if (!fold.past.knows(key))
            unknown.keys.push_back(key);
    }
    await(state.engine.submit(std::move(unknown)), [this](SessionState& now, EngineResult&& read) {
        m_fold->past.addImages(read.changes);
        beginFold(now);
    });
}

void ReviseOperation::beginFold(SessionState& state)
{
    goBefore(state, m_path.front(), [this](SessionState& now) {
        for (auto& [key, image] : m_fold->bricks)
            image = m_fold->past.image(key);
        foldNext(now);
    });
}

void ReviseOperation::foldNext(SessionState& state)
{
    if (m_fold->bricks.empty() || m_next == m_strokes.size())
        return put(state);
    const StandingStroke& stroke = m_strokes[m_next++];
    if (stroke.row == m_edit.row)
        return lay(state, stroke, m_fold->cutAfter);
    goBefore(state, stroke.row, [this, &stroke](SessionState& there) {
        cut(there, stroke, [this, &stroke](SessionState& now, StrokeCut recorded) {
            if (stroke.row > m_edit.row && startsOnSurface(stroke.form))
                compare(now, stroke, std::move(recorded));
            else
                lay(now, stroke, std::move(recorded));
        });
    });
}

void ReviseOperation::compare(SessionState& state, const StandingStroke& stroke, StrokeCut recorded)
{
    // It is before the stroke already; only the layer that the cut stands in is emptied.
    m_fold->past.putBefore(state, stroke.row);
    m_fold->past.overlay(state, m_fold->bricks);
    cut(state, stroke,
        [this, &stroke, recorded = std::move(recorded)](
            SessionState& now, StrokeCut anew) { lay(now, stroke, recorded, std::move(anew)); });
}

void ReviseOperation::lay(SessionState& state, const StandingStroke& stroke, StrokeCut recorded,
    std::optional<StrokeCut> anew)
{
    workAside(state,
        [this, row = stroke.row, layer = layerOf(stroke.form), restoring = restores(stroke.form),
            recorded = std::move(recorded), anew = std::move(anew)](StrokeFold& fold) {
            const bool differs = anew && *anew != recorded;
            fold.lay(recorded, layer, restoring);
            return Sequel([this, row, differs](SessionState& now) {
                if (differs)
                    m_begunInside.push_back(row);
                foldNext(now);
            });
        });
}

void ReviseOperation::put(SessionState& state)
{
    m_refused.reset(); // what was refused on the way here is put again
    m_fold->past.restore(state);
    state.afterRequired([this](SessionState& then) { putFolded(then); });
}

void ReviseOperation::putFolded(SessionState& state)
{
    if (m_isAbandoned)
        return;
    std::vector<BrickImage> bricks;
    for (auto& [key, image] : m_fold->bricks)
        bricks.push_back(std::move(image));
    SwapBricks swap{.bricks = std::move(bricks), .guard = carvingGuard(state.document)};
    const Ticket put = state.engine.submit(std::move(swap));
    m_isPut = true;
    await(
        put, [this](SessionState& now, EngineResult&& result) { finish(now, std::move(result)); });
}

void ReviseOperation::finish(SessionState& state, EngineResult&& result)
{
    m_done = true;
    if (m_again != 0)
        state.complete(m_again, std::move(result));
    else if (result.changes.empty())
        return; // no row, so nothing changed for anybody
    else
        state.commit(m_edit, std::move(result), std::nullopt);
    state.lastRevision = {state.history.position(), std::move(m_begunInside)};
}

/// The engine may be in the midst of a cut, or hold coverage of before.
bool ReviseOperation::abandon(SessionState& state, const Error& error)
{
    if (m_done || m_isPut || m_isAbandoned || m_again != 0)
        return false;
    report(state, error);
    m_isAbandoned = true;
    m_awaited = 0;
    if (m_isLoading)
        return true; // until the differences are there, which are nobody else's
    if (!m_fold) {
        m_done = true;
        return true;
    }
    m_aside.giveUp([this, &state] {
        // It is answered after everything that was asked before, whether or not a cut is open.
        m_awaited = state.engine.submit(EndEdit{Ending::Rollback});
    });
    return true;
}

void ReviseOperation::takeBack(SessionState& state, const EngineResult& result)
{
    if (!m_fold || m_aside.isAway() || state.lost())
        return;
    m_fold->past.discard(result);
    if (result.ticket != m_awaited)
        return;
    m_fold->past.restore(state);
    state.afterRequired([this](SessionState&) { m_done = true; });
}

void ReviseOperation::giveUp(SessionState& state, const Error& error)
{
    m_then = nullptr;
    report(state, error);
    m_fold->past.restore(state);
    m_done = true;
}

void ReviseOperation::report(SessionState& state, const Error& error)
{
    if (!m_isReported)
        state.fail(error);
    m_isReported = true;
}

} // namespace core
