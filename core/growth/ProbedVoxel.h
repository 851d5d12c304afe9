// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/SeedStatistics.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace core {

/// What is at one voxel.
struct ProbedVoxel {
    int code = 0;
    std::uint8_t label = 0;
    std::uint8_t seedOf = 0; ///< label whose pending seed it is; 0: none
    std::optional<int> tolerance{}; ///< in codes; none: it has none, or no field stands
};

/// What lies around seeds of a label: those of one group, or those that are in none.
struct ProbedSeeds {
    std::uint8_t label = 0;
    SeedSums sums;
    std::optional<std::size_t> group{}; ///< its place; none: of the seeds that are in no group
    bool operator==(const ProbedSeeds&) const = default;
};

} // namespace core
