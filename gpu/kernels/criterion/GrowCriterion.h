// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/GrowthForesight.h"
#include "gpu/fields/VoxelFields.h"
#include "gpu/gl/Texture2D.h"

#include <array>

namespace gpu {

/// The defines with which growCriterion.glsl is compiled for some limits; empty without limits. The
/// passage width is not part of them (passage.glsl).
[[nodiscard]] ShaderDefines definesOf(const core::GrowLimits& limits);

/// A number that identifies the set of defines, and whether there is a passage width.
[[nodiscard]] unsigned kindOf(const core::GrowLimits& limits);

/// Sets the uniforms of a core::GrowthRange: closedLabels, rangeLow and rangeHigh.
void setRange(Program& program, const core::GrowthRange& range);

/// The compiled kernels that collect statistics around seeds (seedStatistics.comp).
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

/// Sums over the values around the seeds of each group. Waits for the answer. Engine thread only.
[[nodiscard]] core::GroupedSeedSums seedSums(
    SeedStatisticsPrograms& programs, VoxelFields& fields, const core::ProbeSeeds& question);

/// The criterion that a voxel must meet to join a growth: interval and limits of a burst, as its
/// kernels take them. Engine thread only.
class GrowCriterion {
public:
    /// @param around sums around the seeds; needed if the burst narrows its interval by them
    explicit GrowCriterion(const core::GrowBurst& burst, const core::GroupedSeedSums& around = {});

    /// Sets the uniforms of a program that includes growth.glsl.
    void setUniforms(Program& program) const;
    /// Binds its textures, in addition to those that every growth kernel has.
    void bind(VoxelFields& fields) const;

private:
    void takeSeeds(const core::GrowBurst& burst, const core::GroupedSeedSums& around);

    core::GrowLimits m_limits;
    unsigned m_lowCode = 0; ///< 65536 if the interval is empty
    unsigned m_highCode = 0;
    Texture2D m_seedCodes; ///< a row for each label that has any qualifying codes: one bit per code
    std::array<unsigned, 256> m_seedRows{}; ///< by label: row + 1; 0 if no code qualifies
};

} // namespace gpu
