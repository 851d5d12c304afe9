// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EngineCommands.h"
#include "gpu/fields/VoxelFields.h"
#include "gpu/gl/Texture2D.h"

#include <array>

namespace gpu {

/// The defines that growCriterion.glsl wants for some limits; none where there are none. A passage
/// width is no matter of it (passage.glsl).
[[nodiscard]] ShaderDefines definesOf(const core::GrowLimits& limits);

/// One number for each such set of defines, with a passage width or without.
[[nodiscard]] unsigned kindOf(const core::GrowLimits& limits);

/// The compiled kernels that look at seeds (seedStatistics.comp).
class SeedStatisticsPrograms {
public:
    /// @param shaders outlives them
    explicit SeedStatisticsPrograms(const ShaderLibrary& shaders);

    [[nodiscard]] Program& inBricks() { return m_inBricks; }
    /// Compiled when first needed.
    [[nodiscard]] Program& listed();

private:
    const ShaderLibrary& m_shaders;
    Program m_inBricks;
    Program m_listed;
};

/// What lies around the seeds of each group. Waits for the answer. Engine thread only.
[[nodiscard]] core::GroupedSeedSums seedSums(
    SeedStatisticsPrograms& programs, VoxelFields& fields, const core::ProbeSeeds& question);

/// What a burst asks of voxels, as its kernels take it: interval and limits. Engine thread only.
class GrowCriterion {
public:
    /// @param around what lies around its seeds; needed where it narrows its interval by them
    explicit GrowCriterion(const core::GrowBurst& burst, const core::GroupedSeedSums& around = {});

    /// Uniforms of a program that includes growth.glsl.
    void setUniforms(Program& program) const;
    /// Textures, beside those that every kernel of a growth has.
    void bind(VoxelFields& fields) const;

private:
    void takeSeeds(const core::GrowBurst& burst, const core::GroupedSeedSums& around);

    core::GrowLimits m_limits;
    unsigned m_lowCode = 0; ///< 65536 where the interval is empty
    unsigned m_highCode = 0;
    Texture2D m_seedCodes; ///< a row for each label that has any: one bit a code
    std::array<unsigned, 256> m_seedRows{}; ///< by label, + 1; 0: no code qualifies
};

} // namespace gpu
