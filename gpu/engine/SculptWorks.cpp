// SPDX-License-Identifier: Apache-2.0
#include "gpu/engine/BeginWork.h"
#include "gpu/kernels/sculpt/CapsuleKernel.h"
#include "gpu/kernels/sculpt/DrillKernel.h"
#include "gpu/kernels/sculpt/LaserKernel.h"
#include "gpu/kernels/sculpt/PeelKernel.h"
#include "gpu/kernels/sculpt/ScissorsKernel.h"

#include <memory>
#include <variant>

namespace gpu {

namespace {

template <class Made, auto program> struct ByKernel {
    using Kernel = Made;
    static constexpr auto programs = program;
};

/// Which kernel does it, and with which of the programs.
template <class Cut> struct KernelOf;
template <> struct KernelOf<core::DrillCut> : ByKernel<DrillKernel, &EditPrograms::mask> {
};
template <> struct KernelOf<core::LaserCut> : ByKernel<LaserKernel, &EditPrograms::laser> {
};
template <> struct KernelOf<core::ShellPeel> : ByKernel<PeelKernel, &EditPrograms::mask> {
};
template <> struct KernelOf<core::OutlineCut> : ByKernel<ScissorsKernel, &EditPrograms::mask> {
};
template <> struct KernelOf<core::CapsuleCut> : ByKernel<CapsuleKernel, &EditPrograms::capsule> {
};
template <> struct KernelOf<core::PaintLabel> : ByKernel<CapsuleKernel, &EditPrograms::capsule> {
};
template <> struct KernelOf<core::PaintBarrier> : ByKernel<CapsuleKernel, &EditPrograms::capsule> {
};

} // namespace

BegunWork beginWork(core::StrokeEdits::Pointer edit, const WorkContext& context)
{
    return std::visit(
        [&context]<class Cut>(const Cut* known) -> BegunWork {
            using By = KernelOf<Cut>;
            return std::make_unique<typename By::Kernel>(
                context.programs.*By::programs, context.fields, context.before, *known);
        },
        edit);
}

} // namespace gpu
