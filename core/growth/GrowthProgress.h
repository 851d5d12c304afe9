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

/// How far an open CutGrowth with How::Backwards has come.
struct BackwardProgress {
    enum class Bound : std::uint8_t {
        None, ///< a further step is possible
        Seeds, ///< everything that remains before the cut is nearer to the seeds
        Everything, ///< the next step would remove all that has grown
    };
    std::uint32_t steps = 0;
    std::int64_t members = 0; ///< number of members that leave the growth
    Bound bound = Bound::None;
    bool operator==(const BackwardProgress&) const = default;
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
    /// Only for such a cut; all members above are about a growth.
    std::optional<BackwardProgress> backwards{};
    /// How much is done of work other than a growth that is `running`; less than 0: unknown.
    int percent = -1;
};

} // namespace core
