// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/GrowthCommands.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// Advance a growth. An engine does the steps in short slices and serves other commands and frames
/// in between.
struct GrowAdvance {
    static constexpr int toClosure = -1;
    int steps = toClosure; ///< added to the steps requested before; negative: to closure
    /// limits the pace; 0: as fast as possible. It never changes the result.
    double generationsPerSecond = 0.0;
};

/// How far a running growth has come: a copy for the window.
struct GrowthProgress {
    bool open = false;
    bool running = false;
    bool atClosure = false;
    std::uint32_t generation = 0;
    std::int64_t members = 0; ///< added since the burst was opened
    /// voxels added by each generation, that of the opening first
    std::vector<std::uint32_t> frontSizes;
    std::optional<LeakAlarm> alarm{};
};

} // namespace core
