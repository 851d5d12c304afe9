// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/history/RevertOperation.h"

#include "core/edits/EditNames.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/history/RevertRows.h"
#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/edits/kinds/parts/GrowthPlane.h"
#include "core/engine/EngineCommands.h"
#include "core/growth/SeedWord.h"
#include "core/history/MovedGrowth.h"
#include "core/history/StandingStrokes.h"
#include "core/session/past/GuardedLabels.h"

#include <algorithm>
#include <bitset>
#include <iterator>
#include <set>
#include <utility>

namespace core {

namespace {

tl::unexpected<Error> revertRefused(const Clause& reason)
{
    return failure(ErrorCode::StepsEntangled, reason);
}

QString titled(const HistoryRow& row)
{
    return QStringLiteral("'%1' (row %2)").arg(row.name).arg(row.id);
}

/// What an edit of the document changes there, in words.
Clause listOf(DocumentChange::What part)
{
    switch (part) {
    case DocumentChange::What::Segments:
        return Clause::saying("what the list of segments says");
    case DocumentChange::What::Layers:
        return Clause::saying("what the list of sculpt layers says");
    case DocumentChange::What::Pieces:
        return QStringLiteral("pieces");
    case DocumentChange::What::Bookmarks:
        return QStringLiteral("bookmarks");
    case DocumentChange::What::Measurements:
        return QStringLiteral("measurements");
    case DocumentChange::What::Surface:
        return Clause::saying("the surface");
    case DocumentChange::What::Chunks:
        return Clause::saying("what is divided into chunks");
    case DocumentChange::What::Volume:
    case DocumentChange::What::Labels:
    case DocumentChange::What::Coverage:
    case DocumentChange::What::Growth:
    case DocumentChange::What::History:
    case DocumentChange::What::Disk:
        break; // they are no list of the document
    }
    return Clause::saying("the document");
}

tl::unexpected<Error> entangled(const HistoryRow& later, const HistoryRow& earlier)
{
    return revertRefused(
        Clause::saying("%1 wrote or read the same place after %2", titled(later), titled(earlier)));
}

std::vector<BrickKey> keysOf(const std::vector<BrickImage>& images)
{
    std::vector<BrickKey> keys;
    keys.reserve(images.size());
    for (const BrickImage& image : images)
        keys.push_back(image.key);
    return keys;
}

/// What must not have been written by later rows that take back or revise, though the bricks of the
/// row itself say nothing of it.
struct Claim {
    RowDependencies dependencies;
    RowId row = 0; ///< which is taken back
    RowId returning = 0; ///< a step that comes back: what it read must be as it was

    [[nodiscard]] bool isHurtBy(const Edit& later) const
    {
        const NamedRows named = rowsNamedBy(later);
        switch (named.use) {
        case RowUse::None:
            return false;
        case RowUse::TakesBack:
            // What took back only rows after this one cancels with them.
            return returning != 0 && named.rows.front() < row;
        case RowUse::Revises:
            return true;
        }
        return true;
    }
};

/// Every row that "undo only" takes back or brings back, itself or by rows that it took back.
void addDecided(const History& history, RowId revert, std::set<RowId>& decided)
{
    for (const RowId taken : rowsTakenBackBy(history.row(revert).edit)) {
        decided.insert(taken);
        addDecided(history, taken, decided);
    }
}

/// Taking back "undo only" brings steps back.
/// @param written the bricks that differ when they come back
void claimWhatReturns(const SessionState& state, const ImportTrace& imports, RowId row, RowId taken,
    const std::vector<BrickKey>& written, std::vector<Claim>& claims)
{
    for (const RowId id : rowsTakenBackBy(state.history.row(row).edit)) {
        const Edit& edit = state.history.row(id).edit;
        if (rowUseOf(edit) != RowUse::TakesBack)
            claims.push_back({RowDependencies(edit, state.document, written,
                                  {.importedTo = imports.bricksOf(id)}),
                taken, id});
        if (const auto* revise = edit.as<ReviseStroke>()) {
            for (const SculptEdit& form : formsOf(state.history, revise->row))
                claims.push_back({RowDependencies(form.plain(), state.document, {}), taken, id});
        }
        claimWhatReturns(state, imports, id, taken, written, claims);
    }
}

/// A revision folds in all cuts that lie where it writes, also those hidden under others: in the
/// forms that the stroke has had.
void claimForms(const SessionState& state, RowId row, std::vector<Claim>& claims)
{
    const Edit& edit = state.history.row(row).edit;
    const auto* revise = edit.as<ReviseStroke>();
    for (const SculptEdit& form : formsOf(state.history, revise ? revise->row : row))
        claims.push_back({RowDependencies(form.plain(), state.document, {}), row, 0});
}

/// A revision folds in the cuts, and carved segments, that lie wherever its own stroke reaches,
/// also where nothing came of it: taking one of them back after it would leave what lay hidden
/// below.
bool foldedIn(const SessionState& state, const Edit& taken, const std::vector<BrickKey>& written,
    const Edit& later)
{
    const auto* revise = later.as<ReviseStroke>();
    if (!revise || !(sculptEdit(taken) || taken.is<SegmentToLayer>()))
        return false;
    for (const SculptEdit& form : formsOf(state.history, revise->row)) {
        const RowDependencies dependencies(form.plain(), state.document, {});
        if (std::any_of(written.begin(), written.end(),
                [&dependencies](const BrickKey& key) { return dependencies.covers(key); }))
            return true;
    }
    return false;
}

} // namespace

RevertOperation::RevertOperation(const RevertRows& edit, RowId again)
    : m_rows(edit.rows)
    , m_again(again)
{
}

bool RevertOperation::isTakenBack(RowId row) const
{
    return std::binary_search(m_rows.begin(), m_rows.end(), row);
}

void RevertOperation::start(SessionState& state)
{
    if (const Result<void> checked = checkRows(state); !checked)
        return giveUp(state, checked.error());
    const std::vector<RowId> path = state.history.pathTo(state.history.position());
    m_path.assign(std::find(path.begin(), path.end(), m_rows.front()), path.end());
    for (const RowId row : m_path) {
        if (isNeeded(row, state.history.row(row).edit))
            m_toLoad.push_back(row);
    }
    // Where a later growth asked follows from where seed words stood or came by then.
    const auto growth = std::find_if(m_path.rbegin(), m_path.rend(), [&](RowId row) {
        return !isTakenBack(row) && GrowthTrace::isOf(state.history.row(row).edit);
    });
    for (const RowId row : path) {
        if (growth == m_path.rend() || row > *growth)
            break;
        const Edit& edit = state.history.row(row).edit;
        if (GrowthTrace::mayNeed(edit) && !(row >= m_path.front() && isNeeded(row, edit)))
            m_toLoad.push_back(row);
    }
    m_imports = importsAsked(state);
    loadNext(state);
}

ImportTrace RevertOperation::importsAsked(const SessionState& state) const
{
    const std::vector<RowId> standing = state.history.standing();
    std::set<RowId> asked;
    for (const RowId row : m_path) {
        if (isTakenBack(row))
            addDecided(state.history, row, asked); // the rows that come back
        else if (std::binary_search(standing.begin(), standing.end(), row))
            asked.insert(row);
    }
    ImportTrace imports;
    for (const RowId row : asked)
        imports.note(row, state.history.row(row).edit);
    return imports;
}

bool RevertOperation::isNeeded(RowId row, const Edit& edit) const
{
    return isTakenBack(row) || rowUseOf(edit) != RowUse::None;
}

RowTrace RevertOperation::traceOf(const SessionState& state, RowId row) const
{
    const HistoryRow& traced = state.history.row(row);
    RowTrace trace{
        .searchedTo = traced.statistics.searchedTo, .importedTo = m_imports.bricksOf(row)};
    if (GrowthTrace::isOf(traced.edit))
        trace.grownBeside =
            m_growth.bricksUpTo(row, growthPlaneOf(growCriteriaOf(traced.edit)->plane));
    return trace;
}

Result<void> RevertOperation::checkRows(const SessionState& state) const
{
    const std::vector<RowId> path = state.history.pathTo(state.history.position());
    const std::vector<RowId> standing = state.history.standing();
    std::map<RowId, RowId> deciding; // by row that is decided on
    for (const RowId id : m_rows) {
        if (std::find(path.begin(), path.end(), id) == path.end())
            return revertRefused(Clause::saying("row %1 is not among the steps done so far", id));
        const HistoryRow& row = state.history.row(id);
        if (!std::binary_search(standing.begin(), standing.end(), id))
            return revertRefused(Clause::saying("%1 was taken back before", titled(row)));
        if (changesDocumentOnly(row.edit))
            return revertRefused(
                Clause::saying("%1 changed no voxel, only %2; change that back by itself",
                    titled(row), listOf(*changedPart(row.edit))));
        if (changedPart(row.edit))
            return revertRefused(changedPart(row.edit) == DocumentChange::What::Layers
                    ? Clause::saying("%1 changed the list of sculpt layers too", titled(row))
                    : Clause::saying("%1 changed the list of segments too", titled(row)));
        std::set<RowId> decided;
        addDecided(state.history, id, decided);
        for (const RowId other : m_rows) {
            if (decided.count(other) != 0)
                return revertRefused(Clause::saying("taking back %1 decides on %2 too", titled(row),
                    titled(state.history.row(other))));
        }
        // One after the other is clear; at once it is not whether such a row stands then.
        for (const RowId other : decided) {
            const auto [known, isNew] = deciding.emplace(other, id);
            if (!isNew)
                return revertRefused(Clause::saying("taking back %1 and %2 both decides on %3",
                    titled(state.history.row(known->second)), titled(row),
                    titled(state.history.row(other))));
        }
    }
    if (movedGrowthPlanes(RevertRows{m_rows}, state.history).size() > 1)
        return revertRefused(Clause::saying(
            "they are of growths on several label planes; take those of one plane back at a time"));
    return {};
}

void RevertOperation::loadNext(SessionState& state)
{
    if (!mayGoOn(state))
        return;
    if (!m_toLoad.empty()) {
        m_isLoading = true;
        state.worker->load(m_toLoad.back(), true);
        return;
    }
    if (m_imports.empty())
        return checkAndLayOver(state);
    lookAtImports(state);
}

void RevertOperation::lookAtImports(SessionState& state)
{
    m_aside.post(
        *state.side,
        [this, watch = m_watch, size = state.document.volumes.front().geometry.size,
            imports = std::make_shared<ImportTrace>(m_imports)] {
            imports->workOut(size, watch->progress);
            return SideThread::Sequel([this, imports](SessionState& known) {
                m_imports = std::move(*imports);
                checkAndLayOver(known);
            });
        },
        [this](SessionState& known, const Error& error) { giveUp(known, error); });
}

bool RevertOperation::mayGoOn(SessionState& state)
{
    const bool isAborted = m_watch->progress.cancelled();
    if (isAborted)
        giveUp(state, {ErrorCode::Cancelled, {}});
    return !isAborted;
}

void RevertOperation::checkAndLayOver(SessionState& state)
{
    if (!mayGoOn(state))
        return;
    if (const Result<void> checked = checkDependencies(state); !checked)
        return giveUp(state, checked.error());
    layOver(state);
}

void RevertOperation::takeDifferences(SessionState& state, Result<RowDifferences>&& differences)
{
    m_isLoading = false;
    if (!differences)
        return giveUp(state, differences.error());
    const RowId row = m_toLoad.back();
    m_toLoad.pop_back();
    m_growth.note(row, differences->words, BrickGrid{state.document.volumes.front().geometry.size});
    if (row >= m_path.front() && isNeeded(row, state.history.row(row).edit))
        m_differences[row] = std::move(differences->images);
    loadNext(state);
}

Result<void> RevertOperation::checkDependencies(const SessionState& state) const
{
    const History& history = state.history;
    const std::vector<RowId> standing = history.standing();
    std::map<BrickKey, RowId> taken; // and the row that wrote it first
    std::vector<Claim> claims;
    for (const RowId id : m_path) {
        const HistoryRow& row = history.row(id);
        const auto differences = m_differences.find(id);
        if (isTakenBack(id)) {
            if (differences->second.empty())
                return revertRefused(Clause::saying(
                    "%1 changed no voxel, only what later growths go by", titled(row)));
            for (const BrickKey& key : keysOf(differences->second))
                taken.emplace(key, id);
            claimWhatReturns(state, m_imports, id, id, keysOf(differences->second), claims);
            claimForms(state, id, claims);
            continue;
        }
        // A step that was taken back and what took it back cancel each other.
        if (changesDocumentOnly(row.edit)
            || !std::binary_search(standing.begin(), standing.end(), id))
            continue;
        for (const RowId before : m_rows) {
            if (before < id
                && foldedIn(
                    state, history.row(before).edit, keysOf(m_differences.at(before)), row.edit))
                return entangled(row, history.row(before));
        }
        for (const Claim& claim : claims) {
            if (!claim.isHurtBy(row.edit))
                continue;
            for (const BrickKey& key : keysOf(differences->second)) {
                if (claim.dependencies.covers(key))
                    return entangled(row, history.row(claim.row));
            }
        }
        if (rowUseOf(row.edit) == RowUse::TakesBack)
            continue;
        const RowDependencies dependencies(row.edit, state.document,
            differences == m_differences.end() ? std::vector<BrickKey>()
                                               : keysOf(differences->second),
            traceOf(state, id));
        for (const auto& [key, first] : taken) {
            if (dependencies.covers(key))
                return entangled(row, history.row(first));
        }
    }
    // Nor may what comes back have read what goes with the same step.
    for (const Claim& claim : claims) {
        for (const auto& [key, first] : taken) {
            if (first < claim.returning && first != claim.row && claim.dependencies.covers(key))
                return entangled(history.row(claim.returning), history.row(first));
        }
    }
    return {};
}

void RevertOperation::layOver(SessionState& state)
{
    std::vector<BrickImage> taken;
    for (auto& [row, differences] : m_differences) {
        if (isTakenBack(row))
            std::move(differences.begin(), differences.end(), std::back_inserter(taken));
    }
    m_differences.clear();
    m_swapping = state.engine.submit(
        XorBricks{.differences = std::move(taken), .guard = fullGuard(state.document)});
}

void RevertOperation::takeResult(SessionState& state, EngineResult&& result)
{
    if (!m_swapping || result.ticket != *m_swapping)
        return;
    m_swapping.reset();
    if (result.error)
        giveUp(state, withSegmentName(*result.error, state.document));
    else
        finish(state, std::move(result));
}

void RevertOperation::finish(SessionState& state, EngineResult&& result)
{
    m_done = true;
    if (m_again != 0) {
        state.complete(m_again, std::move(result));
    } else if (!result.changes.empty()) {
        // A shrinking that is undone brings members of later generations back.
        const RevertRows edit{m_rows};
        const std::uint8_t plane = recordedGrowthPlane(edit, state.history);
        const std::uint32_t counter =
            std::max(state.document.generation(plane), result.facts.greatestGeneration(plane));
        state.commit(edit, std::move(result), counter);
    }
    state.notify(DocumentChange::What::Growth);
}

bool RevertOperation::abandon(SessionState& state, const Error& error)
{
    if (m_done || m_swapping || m_isLoading || m_again != 0)
        return false;
    state.fail(error);
    m_watch->progress.cancel();
    m_aside.giveUp([this] { m_done = true; });
    return true;
}

bool RevertOperation::isAbortable() const
{
    return !m_imports.empty() && !m_done && !m_swapping;
}

void RevertOperation::abort(SessionState&)
{
    if (isAbortable())
        m_watch->progress.cancel();
}

void RevertOperation::giveUp(SessionState& state, const Error& error)
{
    state.fail(error);
    m_done = true;
}

} // namespace core
