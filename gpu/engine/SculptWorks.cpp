// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/EditWork.h"
#include "gpu/kernels/sculpt/CapsuleKernel.h"
#include "gpu/kernels/sculpt/DrillKernel.h"
#include "gpu/kernels/sculpt/LaserKernel.h"
#include "gpu/kernels/sculpt/PeelKernel.h"
#include "gpu/kernels/sculpt/ScissorsKernel.h"

namespace gpu {

BegunWork beginWork(const core::DrillCut& edit, const WorkContext& context)
{
    return std::make_unique<DrillKernel>(
        context.programs.mask, context.fields, context.before, edit);
}

BegunWork beginWork(const core::LaserCut& edit, const WorkContext& context)
{
    return std::make_unique<LaserKernel>(
        context.programs.laser, context.fields, context.before, edit);
}

BegunWork beginWork(const core::MaskPeel& edit, const WorkContext& context)
{
    return std::make_unique<PeelKernel>(
        context.programs.mask, context.fields, context.before, edit);
}

BegunWork beginWork(const core::MaskScissors& edit, const WorkContext& context)
{
    return std::make_unique<ScissorsKernel>(
        context.programs.mask, context.fields, context.before, edit);
}

BegunWork beginWork(const core::CapsuleCut& edit, const WorkContext& context)
{
    return std::make_unique<CapsuleKernel>(
        context.programs.capsule, context.fields, context.before, edit);
}

BegunWork beginWork(const core::PaintLabel& edit, const WorkContext& context)
{
    return std::make_unique<CapsuleKernel>(
        context.programs.capsule, context.fields, context.before, edit);
}

BegunWork beginWork(const core::PaintBarrier& edit, const WorkContext& context)
{
    return std::make_unique<CapsuleKernel>(
        context.programs.capsule, context.fields, context.before, edit);
}

} // namespace gpu
