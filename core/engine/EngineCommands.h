// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/delta/Ending.h"
#include "core/engine/BrickCommands.h"
#include "core/engine/EngineEdit.h"
#include "core/engine/EngineResult.h"
#include "core/engine/GrowthForesight.h"
#include "core/engine/VoxelReads.h"

#include <variant>

namespace core {

// All commands of an engine: the sum of the headers of its families.
//
// A command that cannot be carried out changes nothing and yields ErrorCode::InvalidField. That is
// so for
// - BeginEdit, SwapBricks, XorBricks, MuteLayers, TraceTolerance and PreviewCut while a transaction
//   is open; ExtendEdit and EndEdit while none is; CompareGrowth while no GrowBurst is open;
// - an extension that belongs to another kind of edit;
// - parts that are not sound (isSound(), areSound()): a laser, the frame or edges of a brush,
//   hidden half-spaces, a list of labels or places, a growth, groups of seeds, a rule of
//   TraceTolerance, bounds;
// - numbers out of range: a peel's depth below 0; a connectivity other than 6, 18 and 26; a shrink
//   to more than there is, also by ShrinkTo; a cut of no step, also by CutFurther; a segment label
//   of 0; a mask's frame whose pitch, rampHalfWidth or gapSamples is below 1; a table of opacities
//   of another length than 256;
// - a brick or voxel outside the volume; a box of codes that is empty or not within the volume; an
//   image of a brick that is neither empty nor complete;
// - a layer folded into itself; growing from seeds with seeds of fewer than two labels;
//   TraceTolerance for a label without seeds; PreviewCut of a cut that could not begin.
//
// ReadBricks, ReadBarriers, ReadSeedWords, ReadCodes, ProbeVoxels, ProbeSeeds, PickVoxels,
// CountGenerations, DropTolerance and DropCutPreview are also served while a transaction is open.
//
// A CutGrowth over seeds yields ErrorCode::SeedsStay, one where nothing has grown NothingGrown, and
// one backwards that would remove everything EverythingGrown (growth/cut/GrowthCut.h). So does a
// PreviewCut of it.

/// Opens a transaction. At most one is open; its ticket identifies it until EndEdit.
struct BeginEdit {
    EngineEdit edit;
};
struct ExtendEdit {
    EngineExtension extension;
};
/// Closes the open transaction; a commit waits for the steps that were requested. The result, which
/// has the ticket of this command, lists every brick that changed since BeginEdit. After a rollback
/// it lists none, its statistics are zero, and voxels and generation are as before.
struct EndEdit {
    Ending ending = Ending::Commit;
};

using EngineCommandVariant =
    std::variant<BeginEdit, ExtendEdit, EndEdit, SwapBricks, XorBricks, MuteLayers, ReadBricks,
        ReadBarriers, ReadSeedWords, ReadCodes, ProbeVoxels, PickVoxels, CountGenerations,
        ProbeSeeds, TraceTolerance, DropTolerance, PreviewCut, DropCutPreview, CompareGrowth>;

/// Any one command; like Edit (core/edits/kinds/Edit.h), its copies are compiled once.
struct EngineCommand : EngineCommandVariant {
    using EngineCommandVariant::variant;
    EngineCommand();
    EngineCommand(const EngineCommand& other);
    EngineCommand(EngineCommand&& other) noexcept;
    EngineCommand& operator=(const EngineCommand& other);
    EngineCommand& operator=(EngineCommand&& other) noexcept;
    ~EngineCommand();
};

} // namespace core
