// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/GrowthCommands.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// Advance a growth. Steps run in slices between which other commands and frames are served.
struct GrowAdvance {
    static constexpr int toClosure = -1;
    int steps = toClosure; ///< on top of steps asked for before; negative: to closure
    double generationsPerSecond = 0.0; ///< pace; 0: as fast as it goes. Never changes the result.
};

/// Where a running growth stands; a snapshot for the window.
struct GrowthProgress {
    bool open = false;
    bool running = false;
    bool atClosure = false;
    std::uint32_t generation = 0;
    std::int64_t members = 0; ///< added since the burst was opened
    std::vector<std::uint32_t> frontSizes; ///< voxels added per generation, the opening's first
    std::optional<LeakAlarm> alarm{};
};

} // namespace core
