// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/GrowthForesight.h"
#include "tests/reference/fields/DenseFields.h"

#include <array>
#include <vector>

namespace reference {

/// The sums around the seeds of each group (core::GrowLimits, core::ProbeSeeds).
[[nodiscard]] core::GroupedSeedSums seedSums(const DenseArray<std::uint16_t>& codes,
    const DenseArray<std::uint32_t>& words, const core::ProbeSeeds& question);

/// The rules of core::GrowLimits, as they are written. Codes are borrowed.
class GrowCriterion {
public:
    /// @param coverage of the composed layers
    /// @param words as the burst finds them
    GrowCriterion(const DenseArray<std::uint16_t>& codes, DenseArray<std::uint8_t> coverage,
        const DenseArray<std::uint32_t>& words, const core::GrowBurst& burst);

    [[nodiscard]] bool isBetween(const glm::ivec3& voxel, const core::GrowthRange& codes) const
    {
        return codes.lowCode <= code(voxel) && code(voxel) <= codes.highCode;
    }
    [[nodiscard]] bool allows(std::uint32_t label, const glm::ivec3& voxel) const;
    [[nodiscard]] bool follows(const glm::ivec3& parent, const glm::ivec3& voxel) const;

private:
    /// Outside the volume the nearest voxel's.
    [[nodiscard]] int code(const glm::ivec3& voxel) const;
    [[nodiscard]] int median(const glm::ivec3& voxel) const;
    [[nodiscard]] bool suits(std::uint32_t label, int code) const;
    [[nodiscard]] bool within(std::uint32_t label, const glm::ivec3& voxel) const;
    [[nodiscard]] std::int64_t magnitude(const glm::ivec3& voxel) const;

    const DenseArray<std::uint16_t>& m_codes;
    DenseArray<std::uint8_t> m_coverage;
    core::GrowLimits m_limits;
    core::CodeInterval m_interval; ///< lowCode … highCode
    std::array<std::vector<core::CodeInterval>, 256> m_seedIntervals; ///< by label: of its groups
};

} // namespace reference
