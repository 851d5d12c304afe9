// SPDX-License-Identifier: Apache-2.0
#include "core/session/RestoreSession.h"

#include "core/brick/ThreadWithoutVoxels.h"
#include "core/edits/EditTask.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/engine/EngineCommands.h"
#include "core/refine/mesh/SurfaceDelta.h"
#include "core/session/operations/EditOperation.h"
#include "core/session/operations/history/WalkOperation.h"

#include <map>
#include <utility>

namespace core {

namespace {

/// The bricks that are not empty at a row: all differences on the way there, one over the other.
Result<std::vector<BrickImage>> bricksAt(
    SessionFile& file, const BrickGrid& grid, const History& history, RowId row)
{
    std::map<BrickKey, BrickImage> bricks;
    for (const RowId id : history.pathTo(row)) {
        const Result<BrickDelta> delta = file.readDelta(id);
        if (!delta)
            return tl::unexpected(delta.error());
        Result<std::vector<BrickImage>> differences = expandDelta(*delta, grid);
        if (!differences)
            return failure(ErrorCode::SessionDamaged, file.path(),
                Clause::saying("row %1: %2", id, differences.error().arguments.value(0)));
        for (BrickImage& difference : *differences) {
            BrickImage& brick = bricks[difference.key];
            brick.key = difference.key;
            brick = exclusiveOr(brick, difference);
        }
    }
    std::vector<BrickImage> images;
    for (auto& [key, brick] : bricks) {
        if (!brick.bytes.empty())
            images.push_back(std::move(brick));
    }
    return images;
}

/// What each row changed of the surface; the surface at @p base.
Result<void> restoreSurface(SessionState& state, RowId base)
{
    SurfaceState& surface = state.surface;
    for (const HistoryRow& row : state.file->contents().rows) {
        if (taskOf(row.edit) != EditTask::Surface || !changesDocumentOnly(row.edit)
            || row.stateHash.isEmpty())
            continue;
        const Result<BrickDelta> delta = state.file->readDelta(row.id);
        if (!delta)
            return tl::unexpected(delta.error());
        Result<SurfaceStep> step = unpackedSurfaceStep(*delta, surface.geometry().voxelCount());
        if (!step)
            return failure(ErrorCode::SessionDamaged, state.file->path(),
                Clause::saying("row %1: %2", row.id, step.error().arguments.value(0)));
        surface.keep(row.id, std::make_shared<const SurfaceStep>(*std::move(step)));
    }
    for (const RowId id : state.history.pathTo(base))
        surface.moveOver(id, false);
    if (!surface.sha256.isEmpty() && sha256Of(surface.mesh) != surface.sha256)
        return failure(ErrorCode::SessionDamaged, state.file->path(),
            Clause::saying("row %1: the surface does not have its hash", base));
    return {};
}

/// The farthest row on the way to @p row that has its second half, as all before it have.
RowId lastComplete(const History& history, RowId row)
{
    RowId complete = 0;
    for (const RowId id : history.pathTo(row)) {
        if (history.row(id).stateHash.isEmpty())
            break;
        complete = id;
    }
    return complete;
}

} // namespace

Result<void> restoreSession(SessionState& state)
{
    const VoxelsAllowed opens; // whoever opens a session waits for it; a window has it done beside
    SessionFile& file = *state.file;
    const SessionContents& contents = file.contents();
    state.history = History::restored(contents.rows, contents.visited, contents.position);
    const RowId base = lastComplete(state.history, contents.position);
    Result<std::vector<BrickImage>> images = bricksAt(
        file, BrickGrid{state.document.volumes.front().geometry.size}, state.history, base);
    if (!images)
        return tl::unexpected(images.error());
    if (!images->empty()) {
        state.engine.submit(SwapBricks{*images});
        state.engine.finish();
        for (const EngineResult& result : state.engine.collect()) {
            if (result.error)
                return tl::unexpected(*result.error);
        }
    }
    state.history.moveTo(base);
    if (const Result<void> restored = restoreSurface(state, base); !restored)
        return restored;
    state.hide(contents.hiddenSegments);
    for (const Keyframe& keyframe : contents.keyframes)
        state.keyframes.insert(keyframe.row);
    state.display = contents.display;
    state.begin(*std::move(images));
    if (base != 0
        && state.worker->stateHash(state.documentJson()) != state.history.row(base).stateHash)
        return failure(ErrorCode::SessionDamaged, file.path(),
            Clause::saying("row %1: its voxels do not have its hash", base));
    return {};
}

std::vector<std::unique_ptr<Operation>> unfinishedRows(const SessionState& state)
{
    const SessionContents& contents = state.file->contents();
    std::vector<std::unique_ptr<Operation>> operations;
    const auto walkTo = [&operations](RowId row) {
        operations.push_back(std::make_unique<WalkOperation>(WalkOperation::Aim::Row, row));
    };
    for (const HistoryRow& row : contents.rows) {
        if (!row.stateHash.isEmpty())
            continue;
        walkTo(row.parent);
        operations.push_back(operationOf(row.edit, row.id));
    }
    if (!operations.empty() || contents.position != state.history.position())
        walkTo(contents.position);
    return operations;
}

} // namespace core
