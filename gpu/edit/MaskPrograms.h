// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/MaskRaster.h"
#include "gpu/edit/SurfaceCaster.h"

namespace gpu {

/// The compiled kernels of tools that press a mask plane into the volume.
struct MaskPrograms {
    explicit MaskPrograms(const ShaderLibrary& library);

    Program cast;
    Program cut;
};

/// What the elements of a mask meet, one for each of its values; those outside the room nothing.
[[nodiscard]] std::vector<core::SurfaceHit> castMask(MaskPrograms& programs, VoxelFields& fields,
    const core::MaskFrame& frame, const core::MaskRaster& mask, const core::ElementBox& room);

} // namespace gpu
