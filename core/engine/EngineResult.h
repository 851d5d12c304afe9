// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"
#include "core/brick/BrickGrid.h"
#include "core/delta/EditStatistics.h"
#include "core/engine/ChangeFacts.h"
#include "core/engine/Ticket.h"
#include "core/growth/GrowthCommands.h"
#include "core/growth/ProbedVoxel.h"
#include "core/growth/SeedStatistics.h"
#include "core/growth/Tolerance.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// The statistics of a result that has no edit of its own; all others are zero.
[[nodiscard]] EditStatistics statisticsOf(const ChangeFacts& facts);

/// The result of one command. BeginEdit and ExtendEdit have a result only if they fail.
struct EngineResult {
    Ticket ticket = 0;
    std::optional<Error> error;
    /// Sorted by key; only bricks that differ. An image in which all voxels are empty has no bytes.
    std::vector<BrickChange> changes;
    ChangeFacts facts; ///< of these changes; empty for bricks that were only read
    EditStatistics statistics;
    std::uint32_t generation = 0; ///< EndEdit of a growth or shrinking: the generation at its end
    bool atClosure = false; ///< EndEdit of a growth: a step was requested and found nothing to add
    std::optional<LeakAlarm> alarm{}; ///< EndEdit of a growth: why it stopped
    std::vector<std::uint32_t> seedWords{}; ///< ReadSeedWords
    std::vector<std::uint16_t> codes{}; ///< ReadCodes
    std::vector<ProbedVoxel> probes;
    std::vector<ProbedSeeds> seeds; ///< groups in their order, then the seeds in none, by label;
                                    ///< only those that have voxels
    std::vector<std::optional<glm::ivec3>> picks; ///< one per ray
    std::vector<std::uint32_t> generationSizes; ///< place g: members of generation g; ends with the
                                                ///< last that has any
    std::optional<ToleranceCurve> tolerance{}; ///< TraceTolerance, once it is done
    std::optional<CutPreview> cutPreview{}; ///< PreviewCut, once it is done
    std::optional<GrowthComparison> growthComparison{}; ///< CompareGrowth
};

} // namespace core
