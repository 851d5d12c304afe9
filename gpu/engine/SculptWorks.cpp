// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/BeginWork.h"
#include "gpu/kernels/sculpt/CapsuleKernel.h"
#include "gpu/kernels/sculpt/DrillKernel.h"
#include "gpu/kernels/sculpt/LaserKernel.h"
#include "gpu/kernels/sculpt/PeelKernel.h"
#include "gpu/kernels/sculpt/ScissorsKernel.h"

namespace gpu {

namespace {

BegunWork begun(const core::DrillCut& edit, const WorkContext& context)
{
    return std::make_unique<DrillKernel>(
        context.programs.mask, context.fields, context.before, edit);
}

BegunWork begun(const core::LaserCut& edit, const WorkContext& context)
{
    return std::make_unique<LaserKernel>(
        context.programs.laser, context.fields, context.before, edit);
}

BegunWork begun(const core::ShellPeel& edit, const WorkContext& context)
{
    return std::make_unique<PeelKernel>(
        context.programs.mask, context.fields, context.before, edit);
}

BegunWork begun(const core::OutlineCut& edit, const WorkContext& context)
{
    return std::make_unique<ScissorsKernel>(
        context.programs.mask, context.fields, context.before, edit);
}

BegunWork begun(const core::CapsuleCut& edit, const WorkContext& context)
{
    return std::make_unique<CapsuleKernel>(
        context.programs.capsule, context.fields, context.before, edit);
}

BegunWork begun(const core::PaintLabel& edit, const WorkContext& context)
{
    return std::make_unique<CapsuleKernel>(
        context.programs.capsule, context.fields, context.before, edit);
}

BegunWork begun(const core::PaintBarrier& edit, const WorkContext& context)
{
    return std::make_unique<CapsuleKernel>(
        context.programs.capsule, context.fields, context.before, edit);
}

} // namespace

BegunWork beginWork(core::StrokeEdits::Pointer edit, const WorkContext& context)
{
    return std::visit([&context](const auto* known) { return begun(*known, context); }, edit);
}

} // namespace gpu
