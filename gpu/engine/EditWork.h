// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/engine/EngineCommands.h"
#include "gpu/engine/EditPrograms.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/fields/VoxelFields.h"
#include "gpu/kernels/work/EditWork.h"

#include <memory>

namespace gpu {

/// What works have to do with.
struct WorkContext {
    EditPrograms& programs;
    VoxelFields& fields;
    BeforeImages& before;
};

using BegunWork = core::Result<std::unique_ptr<EditWork>>;

// One for each kind of edit: EditTransaction asks for it of every one of them. The edit is sound
// (checkEdit()). Errors: InvalidField, with nothing changed.

BegunWork beginWork(const core::DrillCut& edit, const WorkContext& context);
BegunWork beginWork(const core::LaserCut& edit, const WorkContext& context);
BegunWork beginWork(const core::MaskPeel& edit, const WorkContext& context);
BegunWork beginWork(const core::MaskScissors& edit, const WorkContext& context);
BegunWork beginWork(const core::CapsuleCut& edit, const WorkContext& context);
BegunWork beginWork(const core::PaintLabel& edit, const WorkContext& context);
BegunWork beginWork(const core::PaintBarrier& edit, const WorkContext& context);

BegunWork beginWork(const core::SeedPlacement& edit, const WorkContext& context);
BegunWork beginWork(const core::GrowBurst& edit, const WorkContext& context);
BegunWork beginWork(const core::ShrinkGrowth& edit, const WorkContext& context);
BegunWork beginWork(const core::CutGrowth& edit, const WorkContext& context);
BegunWork beginWork(const core::SpreadLabels& edit, const WorkContext& context);

BegunWork beginWork(const core::EraseLabel& edit, const WorkContext& context);
BegunWork beginWork(const core::LabelCarved& edit, const WorkContext& context);
BegunWork beginWork(const core::LabelSeen& edit, const WorkContext& context);
BegunWork beginWork(const core::LabelListed& edit, const WorkContext& context);
BegunWork beginWork(const core::RelabelListed& edit, const WorkContext& context);
BegunWork beginWork(const core::ShutListed& edit, const WorkContext& context);
BegunWork beginWork(const core::CoverLabel& edit, const WorkContext& context);
BegunWork beginWork(const core::FoldLayer& edit, const WorkContext& context);

} // namespace gpu
