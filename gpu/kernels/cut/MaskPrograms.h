// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/MaskRaster.h"
#include "gpu/kernels/cut/SurfaceCaster.h"

namespace gpu {

/// The compiled kernels of tools that press a mask plane into the volume.
struct MaskPrograms {
    explicit MaskPrograms(const ShaderLibrary& library);

    Program cast;
    Program cut;
};

/// What the elements of a mask meet, one for each of its values (those outside the room nothing),
/// and how deep they looked for it.
struct MaskHits {
    std::vector<core::SurfaceHit> hits;
    std::optional<std::int32_t> searchedTo;
};
[[nodiscard]] MaskHits castMask(MaskPrograms& programs, VoxelFields& fields,
    const core::MaskFrame& frame, const core::MaskRaster& mask, const core::ElementBox& room);

} // namespace gpu
