// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/GrowthCommands.h"
#include "core/growth/front/BrickFront.h"

#include <bitset>
#include <optional>
#include <span>

namespace core {

/// Which voxels the growth of one label may claim, where the code of a voxel, its place and the
/// label that it holds are all that decides (GrowBurst, GrowthRange).
struct OpenRule {
    int lowCode = 0;
    int highCode = 65535;
    std::bitset<256> mayEnter{}; ///< labels that may be replaced, 0 and the growing one among them
    glm::ivec3 boxFrom{0}; ///< index space
    glm::ivec3 boxTo{0}; ///< the last voxel
};

/// The rule for a label of a burst; none if further limits decide.
/// @param volumeSize in voxels
[[nodiscard]] std::optional<OpenRule> openRule(
    const GrowBurst& burst, std::uint8_t label, const glm::ivec3& volumeSize);

/// What a brick holds, `BrickGrid::voxelsPerBrick` of each kind. None: all voxels are empty.
struct AskedBrick {
    glm::ivec3 origin{0}; ///< its first voxel, in index space
    std::span<const std::uint16_t> codes;
    std::span<const std::uint32_t> words; ///< seed words
    std::span<const std::uint8_t> labels;
};

/// The voxels of a brick that may be claimed, as frontBitsOpen.comp finds them. Any thread.
[[nodiscard]] VoxelBits openVoxels(const OpenRule& rule, const AskedBrick& brick);

} // namespace core
