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
// A command that cannot be carried out changes nothing and yields ErrorCode::InvalidField:
// BeginEdit while a transaction is open; ExtendEdit or EndEdit while none is, or an extension of
// another kind of edit; a peel's depth below 0; SwapBricks, XorBricks or MuteLayers while a
// transaction is open; a brick or voxel that the volume does not have; an image that is neither
// empty nor whole; a connectivity other than 6, 18 and 26; a shrinking to more than there is, also
// by ShrinkTo; a cut, also by CutFurther, of no step; a segment label of 0; a mask's frame whose
// pitch, rampHalfWidth or gapSamples is below 1; a laser, a brush's frame or edges, what is hidden,
// a list of labels or places, a growth or groups of seeds that are not sound (isSound()); bounds
// that are not (areSound()); a layer folded into itself; a table of opacities of another length
// than 256; growing from seeds that is not sound (isSound()) or with seeds of fewer than two
// labels; TraceTolerance while a transaction is open, by a rule that is not sound (isSound()) or of
// a label without seeds; PreviewCut while a transaction is open, or of a cut that could not begin;
// CompareGrowth while no GrowBurst is open; a box of codes that is empty or not within the volume.
// ReadBricks, ReadBarriers, ReadSeedWords, ReadCodes, ProbeVoxels, ProbeSeeds, PickVoxels,
// CountGenerations, DropTolerance and DropCutPreview are served while a transaction is open too. A
// CutGrowth over seeds yields ErrorCode::SeedsStay, one where nothing has grown NothingGrown, one
// backwards that would take everything EverythingGrown (growth/cut/GrowthCut.h), and so does a
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
