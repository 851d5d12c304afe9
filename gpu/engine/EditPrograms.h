// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/kernels/cut/CutPrograms.h"
#include "gpu/kernels/growth/GrowthKernel.h"
#include "gpu/kernels/labels/BarrierKernel.h"
#include "gpu/kernels/labels/EraseKernel.h"
#include "gpu/kernels/labels/LabelKernel.h"
#include "gpu/kernels/sculpt/CapsuleKernel.h"
#include "gpu/kernels/sculpt/LaserKernel.h"
#include "gpu/kernels/spread/SpreadKernel.h"
#include "gpu/kernels/spread/ToleranceKernel.h"

namespace gpu {

/// Every compiled kernel that edits voxels or computes what an edit would do. The kernels know of
/// no volume, so one set serves all volumes that are opened.
struct EditPrograms {
    explicit EditPrograms(const ShaderLibrary& library, WorkBy growthBy = WorkBy::Driver)
        : growth(library, growthBy)
        , mask(library)
        , erase(library)
        , capsule(library)
        , label(library)
        , barriers(library)
        , laser(library)
        , spread(library)
        , tolerance(library)
    {
    }

    GrowthPrograms growth;
    CutPrograms mask;
    ErasePrograms erase;
    CapsulePrograms capsule;
    LabelPrograms label;
    BarrierPrograms barriers;
    LaserPrograms laser;
    SpreadPrograms spread;
    TolerancePrograms tolerance;
};

} // namespace gpu
