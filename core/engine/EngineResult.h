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

/// The statistics of a result that belongs to no edit, such as that of SwapBricks: only voxels and
/// bricks that changed are counted.
[[nodiscard]] EditStatistics statisticsOf(const ChangeFacts& facts);

/// The result of one command. BeginEdit and ExtendEdit have a result only if they fail.
struct EngineResult {
    Ticket ticket = 0;
    std::optional<Error> error;
    /// Sorted by key; only bricks that differ. An image in which all voxels are empty has no bytes.
    std::vector<BrickChange> changes;
    ChangeFacts facts; ///< of these changes; empty for bricks that were only read
    EditStatistics statistics;
    /// After EndEdit of a growth or shrinking, the generation at its end.
    std::uint32_t generation = 0;
    /// After EndEdit of a growth, whether a step was requested that found nothing to add.
    bool atClosure = false;
    std::optional<LeakAlarm> alarm{}; ///< after EndEdit of a growth, the alarm that stopped it
    std::vector<std::uint32_t> seedWords{}; ///< ReadSeedWords
    std::vector<std::uint16_t> codes{}; ///< ReadCodes
    std::vector<ProbedVoxel> probes;
    /// Groups in their order, then by label the seeds that are in no group; only those that have
    /// voxels.
    std::vector<ProbedSeeds> seeds;
    std::vector<std::optional<glm::ivec3>> picks; ///< one per ray
    /// At index g, the number of members of generation g, up to the last generation that has any.
    std::vector<std::uint32_t> generationSizes;
    std::optional<ToleranceCurve> tolerance{}; ///< TraceTolerance, once it is done
    std::optional<CutPreview> cutPreview{}; ///< PreviewCut, once it is done
    std::optional<GrowthComparison> growthComparison{}; ///< CompareGrowth
};

} // namespace core
