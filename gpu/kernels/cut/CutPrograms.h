// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/OutlineRaster.h"
#include "gpu/kernels/cut/SurfaceCaster.h"

namespace gpu {

/// The compiled kernels of the tools that press a mask plane into the volume.
struct CutPrograms {
    explicit CutPrograms(const ShaderLibrary& library);

    Program cast;
    Program cut;
};

/// Where the rays of a mask's elements meet the surface, and how deep they looked for it.
struct RasterHits {
    /// One for each value of the mask; nothing for elements outside the room.
    std::vector<core::SurfaceHit> hits;
    std::optional<std::int32_t> searchedTo;
};
/// Casts a ray from each element of the mask that lies in @p room. Waits.
[[nodiscard]] RasterHits castRaster(CutPrograms& programs, VoxelFields& fields,
    const core::CutFrame& frame, const core::OutlineRaster& mask, const core::ElementBox& room);

} // namespace gpu
