// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EngineCommands.h"
#include "tests/reference/DenseFields.h"

#include <array>

namespace reference {

/// The sums around the seeds of each label (core::GrowLimits, core::ProbeSeeds).
[[nodiscard]] std::array<core::SeedSums, 256> seedSums(const DenseArray<std::uint16_t>& codes,
    const DenseArray<std::uint32_t>& words, int lowCode, int highCode);

/// The rules of core::GrowLimits, as they are written. Codes are borrowed.
class GrowCriterion {
public:
    /// @param coverage of the composed layers
    /// @param words as the burst finds them
    GrowCriterion(const DenseArray<std::uint16_t>& codes, DenseArray<std::uint8_t> coverage,
        const DenseArray<std::uint32_t>& words, const core::GrowBurst& burst);

    [[nodiscard]] bool allows(std::uint32_t label, const glm::ivec3& voxel) const;
    [[nodiscard]] bool follows(const glm::ivec3& parent, const glm::ivec3& voxel) const;

private:
    /// Outside the volume the nearest voxel's.
    [[nodiscard]] int code(const glm::ivec3& voxel) const;
    [[nodiscard]] bool within(std::uint32_t label, const glm::ivec3& voxel) const;
    [[nodiscard]] std::int64_t magnitude(const glm::ivec3& voxel) const;

    const DenseArray<std::uint16_t>& m_codes;
    DenseArray<std::uint8_t> m_coverage;
    core::GrowLimits m_limits;
    std::array<core::CodeInterval, 256> m_intervals; ///< by label
};

} // namespace reference
