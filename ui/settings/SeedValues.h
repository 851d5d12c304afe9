// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/SketchInterval.h"
#include "core/volume/Volume.h"

#include <glm/glm.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace core {
class EditSession;
}

namespace ui {

/// The voxels of the seeds of a segment, by the sketch that set them, on the history's line up to
/// its present position; without sketches of which nothing is left.
[[nodiscard]] std::vector<std::vector<glm::ivec3>> sketchedVoxels(
    const core::EditSession& session, int label);
/// The voxels of all seeds of a segment, on the history's line up to its present position.
[[nodiscard]] std::vector<glm::ivec3> seedVoxels(const core::EditSession& session, int label);
/// The number of seed voxels of all segments that were sketched on that line.
[[nodiscard]] int sketchedSeeds(const core::EditSession& session);

/// The tolerance at which an interval is offered after a sketch, in deviations: of a normal
/// distribution they hold 99 %.
inline constexpr double usualTolerance = 2.5;
/// The interval that is offered for what was sketched (core::offeredInterval()), in modality units
/// and few digits. An end beyond which nearly nothing of the volume lies is open: the volume's own.
/// None: nothing was sketched.
[[nodiscard]] std::optional<std::pair<double, double>> offeredValues(
    const core::Volume& volume, const core::SketchedCodes& sketched, double tolerance);

/// Mean and standard deviation of the values under seeds, in modality units.
struct SeedStatistics {
    double mean = 0.0;
    double deviation = 0.0; ///< standard deviation of the sample; 0 for a single value
};
[[nodiscard]] SeedStatistics seedStatistics(const std::vector<double>& values);

} // namespace ui
