// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

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

/// Mean and standard deviation of the values under seeds, in modality units.
struct SeedStatistics {
    double mean = 0.0;
    double deviation = 0.0; ///< standard deviation of the sample; 0 for a single value
};
[[nodiscard]] SeedStatistics seedStatistics(const std::vector<double>& values);

} // namespace ui
