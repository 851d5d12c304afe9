// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/EditOperation.h"

#include "core/edits/document/DocumentEdits.h"
#include "core/edits/kinds/SurfacePaths.h"
#include "core/session/operations/ChunkOperation.h"
#include "core/session/operations/DocumentOperation.h"
#include "core/session/operations/RevertOperation.h"
#include "core/session/operations/ReviseOperation.h"
#include "core/session/operations/SurfaceOperation.h"
#include "core/session/operations/VoxelOperation.h"

namespace core {

std::unique_ptr<Operation> operationOf(const Edit& edit, RowId again)
{
    if (isOfSurface(edit))
        return std::make_unique<SurfaceOperation>(edit, SurfaceOperation::Kind::Whole, again);
    if (const auto* chunks = std::get_if<Chunks>(&edit))
        return std::make_unique<DivideOperation>(*chunks, again);
    if (const auto* toggle = std::get_if<ChunkToggle>(&edit))
        return std::make_unique<ToggleChunks>(*toggle, again);
    if (changesDocumentOnly(edit))
        return std::make_unique<DocumentOperation>(edit, again);
    if (const auto* revert = std::get_if<RevertRows>(&edit))
        return std::make_unique<RevertOperation>(*revert, again);
    if (const auto* revise = std::get_if<ReviseStroke>(&edit))
        return std::make_unique<ReviseOperation>(*revise, again);
    return std::make_unique<VoxelOperation>(edit, VoxelOperation::Kind::Whole, again);
}

} // namespace core
