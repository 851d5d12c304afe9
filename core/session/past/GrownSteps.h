// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/engine/EditEngine.h"

#include <vector>

namespace core {

/// How many steps a burst of growth did after its opening. That seeds are admitted when it opens is
/// a generation, but no step. Cost ∝ the changes.
/// @param first the generation when it opened, after what left it
/// @param statistics, changes of the burst
[[nodiscard]] int grownSteps(
    std::uint32_t first, const EditStatistics& statistics, const std::vector<BrickChange>& changes);

} // namespace core
