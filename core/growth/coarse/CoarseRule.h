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

/// The conditions of a coarse flood: those of a GrowBurst that can be tested on a cell.
struct CoarseRule {
    int lowCode = 0;
    int highCode = -1;
    glm::ivec3 boxFrom{0}; ///< voxels, both included
    glm::ivec3 boxTo{std::numeric_limits<int>::max()};
    int connectivity = 6; ///< 6, 18 or 26
    /// Codes must lie in one of these too, as around the seeds of a stroke; none: no such
    /// condition.
    std::optional<std::vector<CodeInterval>> among{};
    std::optional<std::vector<CodeInterval>> rivalsAmong{}; ///< the same for its rivals
    std::bitset<256> closed{}; ///< labels that the flood does not enter
    std::bitset<256> closedToRivals{}; ///< labels that its rivals do not enter
    Passage passage{}; ///< ignored where cells are too large for it (CoarsePassage.h)
    bool operator==(const CoarseRule&) const = default;
};

/// A table with an entry for every possible code: 1 if it lies in the interval of the rule and in
/// one of these, else 0. For code that tests millions of cells, because strokes may yield many
/// intervals.
/// @param among CoarseRule::among or CoarseRule::rivalsAmong
[[nodiscard]] std::vector<std::uint8_t> codesWithin(
    const CoarseRule& rule, const std::optional<std::vector<CodeInterval>>& among);

} // namespace core
