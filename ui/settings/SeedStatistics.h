// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace core {
class EditSession;
}

namespace ui {

/// The voxels of all seeds of a segment on the history's line up to its position.
[[nodiscard]] std::vector<glm::ivec3> seedVoxels(const core::EditSession& session, int label);
/// How many seed voxels were sketched, of all segments, on that line.
[[nodiscard]] int sketchedSeeds(const core::EditSession& session);

struct SeedStatistics {
    double mean = 0.0;
    double deviation = 0.0; ///< of the sample; 0 for a single value
};
[[nodiscard]] SeedStatistics seedStatistics(const std::vector<double>& values);

} // namespace ui
