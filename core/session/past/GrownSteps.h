// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EngineCommands.h"

namespace core {

/// How many steps a burst of growth did after its opening. That seeds are admitted when it opens is
/// a generation, but no step.
/// @param first the generation when it opened, after what left it
/// @param statistics, facts of the burst
[[nodiscard]] int grownSteps(
    std::uint32_t first, const EditStatistics& statistics, const ChangeFacts& facts);

} // namespace core
