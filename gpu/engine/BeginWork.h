// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/engine/EngineEdit.h"
#include "gpu/engine/EditPrograms.h"
#include "gpu/fields/BeforeImages.h"
#include "gpu/fields/VoxelFields.h"
#include "gpu/kernels/work/EditWork.h"

#include <memory>

namespace gpu {

/// The environment of an edit's work.
struct WorkContext {
    EditPrograms& programs;
    VoxelFields& fields;
    BeforeImages& before;
};

using BegunWork = core::Result<std::unique_ptr<EditWork>>;

// One function for each family of edits, which handles all kinds of the family; a missing kind does
// not compile. The edit is sound (core::checkEdit()). Errors: InvalidField, with nothing changed.

BegunWork beginWork(core::GrowthEdits::Pointer edit, const WorkContext& context);
BegunWork beginWork(core::StrokeEdits::Pointer edit, const WorkContext& context);
BegunWork beginWork(core::WholeEdits::Pointer edit, const WorkContext& context);
BegunWork beginWork(core::LabelWrites::Pointer edit, const WorkContext& context);

} // namespace gpu
