// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/export/common/MaskSelection.h"

#include <array>

namespace core {

/// Shares of a segment's voxels, in percent, whose values are told.
constexpr std::array<int, 6> statisticsPercentiles{5, 10, 25, 75, 90, 95};

/// What is measured of one segment. Values are in modality units, exactly those of the voxels'
/// codes; counts decide, so nothing depends on an order.
struct SegmentStatistics {
    Segment segment;
    std::int64_t voxels = 0;
    /// Each voxel counts as much as the grid has room for it: where slices lie unevenly, half the
    /// way to either neighbour.
    double millilitres = 0.0;
    glm::ivec3 first{0}; ///< of the box of its voxels, inclusive
    glm::ivec3 last{0};
    glm::dvec3 lowestLps{0.0}; ///< mm, of the centres of its voxels
    glm::dvec3 highestLps{0.0};
    glm::dvec3 centroidLps{0.0}; ///< mm, of the voxels' centres
    double surfaceMm2 = 0.0; ///< of the smoothed surface (SegmentSurface.h)
    double minimum = 0.0;
    double maximum = 0.0;
    double mean = 0.0;
    double deviation = 0.0; ///< of all its voxels (divided by their number)
    double median = 0.0;
    /// The least value that so many percent of the voxels do not exceed; one that occurs.
    std::array<double, statisticsPercentiles.size()> percentiles{};
};

/// Errors: Cancelled.
[[nodiscard]] Result<std::vector<SegmentStatistics>> segmentStatistics(const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, const Progress& progress);

} // namespace core
