// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/growth/SeedStatistics.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace core {

/// What an engine answers about one voxel: its value, its label and how growth would reach it.
struct ProbedVoxel {
    int code = 0;
    std::uint8_t label = 0; ///< label in the plane that the question named
    std::uint8_t seedOf = 0; ///< the label whose pending seed it is in that plane; 0: none
    /// in codes (Tolerance.h); none: not reached, or no tolerances were computed
    std::optional<int> tolerance{};
    /// The labels in all planes, by plane; 0: none. Segments of different planes may overlap.
    std::array<std::uint8_t, mostLabelPlanes> labels{};
};

/// Statistics of the codes around seeds of a label: of one group, or of the seeds in no group.
struct ProbedSeeds {
    std::uint8_t label = 0;
    SeedSums sums;
    /// index of the group; none: the seeds that are in no group
    std::optional<std::size_t> group{};
    bool operator==(const ProbedSeeds&) const = default;
};

} // namespace core
