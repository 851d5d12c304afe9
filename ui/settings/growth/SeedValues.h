// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/SketchInterval.h"
#include "core/volume/Volume.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace core {
class EditSession;
}

namespace ui {

/// Returns the seed voxels of a segment by the sketch that set them, for all sketches in effect at
/// the history's present position. Sketches of which nothing is left are omitted.
[[nodiscard]] std::vector<std::vector<glm::ivec3>> sketchedVoxels(
    const core::EditSession& session, int label);
/// Returns all seed voxels of a segment that are in effect at the history's present position.
[[nodiscard]] std::vector<glm::ivec3> seedVoxels(const core::EditSession& session, int label);
/// Returns the number of seed voxels of all segments of a label plane.
[[nodiscard]] int sketchedSeeds(const core::EditSession& session, std::uint8_t plane);

/// The tolerance with which an interval is suggested after a sketch, in standard deviations: it
/// covers 99 % of a normal distribution.
inline constexpr double usualTolerance = 2.5;
/// Returns the interval that is suggested for sketched voxels (core::offeredInterval()), in
/// modality units, rounded outwards to few digits. An end is set to the volume's own if less than
/// half a percent of the volume lies beyond it. None if nothing was sketched.
[[nodiscard]] std::optional<std::pair<double, double>> offeredValues(
    const core::Volume& volume, const core::SketchedCodes& sketched, double tolerance);

/// Mean and standard deviation of the values under seeds, in modality units.
struct SeedStatistics {
    double mean = 0.0;
    double deviation = 0.0; ///< standard deviation of the sample; 0 for a single value
};
[[nodiscard]] SeedStatistics seedStatistics(const std::vector<double>& values);

} // namespace ui
