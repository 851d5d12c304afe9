// SPDX-License-Identifier: Apache-2.0
#include "core/engine/EngineResult.h"

namespace core {

EditStatistics statisticsOf(const ChangeFacts& facts)
{
    EditStatistics statistics;
    statistics.voxelsChanged = facts.voxelsChanged;
    statistics.bricks = facts.bricks;
    return statistics;
}

} // namespace core
