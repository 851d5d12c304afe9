// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/Passage.h"
#include "core/growth/SeedStatistics.h"

#include <glm/glm.hpp>

#include <bitset>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace core {

/// What a coarse flood asks of voxels: the part of a GrowBurst that a cell can answer.
struct CoarseRule {
    int lowCode = 0;
    int highCode = -1;
    glm::ivec3 boxFrom{0}; ///< voxels, both included
    glm::ivec3 boxTo{std::numeric_limits<int>::max()};
    int connectivity = 6; ///< 6, 18 or 26
    /// Codes must lie in one of these too, as around the seeds of a stroke; none: no such
    /// condition.
    std::optional<std::vector<CodeInterval>> among{};
    std::optional<std::vector<CodeInterval>> rivalsAmong{}; ///< the same for segments that grow too
    std::bitset<256> closed{}; ///< labels that it does not enter
    std::bitset<256> closedToRivals{}; ///< and those that segments that grow with it do not
    Passage passage{}; ///< left out where cells are too large to tell it (CoarsePassage.h)
    bool operator==(const CoarseRule&) const = default;
};

/// By code, for all codes that there can be: 1 where it lies in the interval of a rule, and in one
/// of these. Whoever asks about millions of cells asks this: strokes may have given many intervals.
/// @param among CoarseRule::among or CoarseRule::rivalsAmong
[[nodiscard]] std::vector<std::uint8_t> codesWithin(
    const CoarseRule& rule, const std::optional<std::vector<CodeInterval>>& among);

} // namespace core
