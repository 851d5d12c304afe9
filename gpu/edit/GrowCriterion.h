// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EngineCommands.h"
#include "gpu/edit/VoxelFields.h"

#include <array>

namespace gpu {

/// The defines that growCriterion.glsl wants for some limits; none where there are none. A passage
/// width is no matter of it (passage.glsl).
[[nodiscard]] ShaderDefines definesOf(const core::GrowLimits& limits);

/// One number for each such set of defines, with a passage width or without.
[[nodiscard]] unsigned kindOf(const core::GrowLimits& limits);

/// What lies around the seeds of each label, by label (ProbeSeeds). Waits for the answer. Engine
/// thread only.
using SeedSumsByLabel = std::array<core::SeedSums, 256>;
[[nodiscard]] SeedSumsByLabel seedSums(
    Program& kernel, VoxelFields& fields, std::uint8_t plane, int lowCode, int highCode);

/// What a burst asks of voxels, as its kernels take it: interval and limits. Engine thread only.
class GrowCriterion {
public:
    /// Looks at the seeds where the burst narrows its interval by them.
    /// @param statistics seedStatistics.comp
    GrowCriterion(Program& statistics, VoxelFields& fields, const core::GrowBurst& burst);

    /// Uniforms of a program that includes growth.glsl.
    void setUniforms(Program& program) const;
    /// Textures, beside those that every kernel of a growth has.
    void bind(VoxelFields& fields) const;

private:
    core::GrowLimits m_limits;
    unsigned m_lowCode = 0; ///< 65536 where the interval is empty
    unsigned m_highCode = 0;
    std::array<unsigned, 256> m_seedIntervals{};
};

} // namespace gpu
