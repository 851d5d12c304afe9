// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/EditOperation.h"

#include "core/edits/EditTask.h"
#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/edits/kinds/filling/EvolveContour.h"
#include "core/edits/kinds/filling/FillBetweenSlices.h"
#include "core/edits/kinds/filling/FloodFill.h"
#include "core/edits/kinds/filling/MirrorSegment.h"
#include "core/edits/kinds/history/RevertRows.h"
#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/edits/kinds/segments/CleanSegment.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/splitting/SplitIslands.h"
#include "core/edits/kinds/splitting/SplitSegment.h"
#include "core/session/operations/ChunkOperation.h"
#include "core/session/operations/ContourOperation.h"
#include "core/session/operations/DocumentOperation.h"
#include "core/session/operations/FloodOperation.h"
#include "core/session/operations/IslandOperation.h"
#include "core/session/operations/SurfaceOperation.h"
#include "core/session/operations/VoxelOperation.h"
#include "core/session/operations/history/RevertOperation.h"
#include "core/session/operations/history/ReviseOperation.h"

namespace core {

std::unique_ptr<Operation> operationOf(const Edit& edit, RowId again)
{
    switch (taskOf(edit)) {
    case EditTask::Document:
        return std::make_unique<DocumentOperation>(edit, again);
    case EditTask::Surface:
        return std::make_unique<SurfaceOperation>(edit, SurfaceOperation::Kind::Whole, again);
    case EditTask::Chunks:
        if (const auto* chunks = edit.as<DivideSegment>())
            return std::make_unique<DivideOperation>(*chunks, again);
        return std::make_unique<ToggleChunks>(edit.get<ChunkToggle>(), again);
    case EditTask::History:
        if (const auto* revert = edit.as<RevertRows>())
            return std::make_unique<RevertOperation>(*revert, again);
        return std::make_unique<ReviseOperation>(edit.get<ReviseStroke>(), again);
    case EditTask::Islands:
        if (const auto* reshape = edit.as<ReshapeSegment>())
            return std::make_unique<IslandOperation>(*reshape, again);
        if (const auto* flood = edit.as<FloodFill>())
            return std::make_unique<FloodOperation>(*flood, again);
        if (const auto* contour = edit.as<EvolveContour>())
            return std::make_unique<ContourOperation>(*contour, again);
        if (const auto* between = edit.as<FillBetweenSlices>())
            return std::make_unique<IslandOperation>(*between, again);
        if (const auto* mirror = edit.as<MirrorSegment>())
            return std::make_unique<IslandOperation>(*mirror, again);
        if (const auto* islands = edit.as<SplitIslands>())
            return std::make_unique<IslandOperation>(*islands, again);
        if (const auto* split = edit.as<SplitSegment>())
            return std::make_unique<IslandOperation>(*split, again);
        return std::make_unique<IslandOperation>(edit.get<CleanSegment>(), again);
    case EditTask::Engine:
        break;
    }
    return std::make_unique<VoxelOperation>(edit, VoxelOperation::Kind::Whole, again);
}

} // namespace core
