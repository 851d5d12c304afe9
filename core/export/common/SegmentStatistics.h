// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/export/common/MaskSelection.h"

#include <array>
#include <optional>

namespace core {

/// The percentiles that are computed.
constexpr std::array<int, 6> statisticsPercentiles{5, 10, 25, 75, 90, 95};

/// The segment compared with the mask from which it was imported.
struct ChangeSinceImport {
    double addedMl = 0.0; ///< volumes are measured as `millilitres` is
    double takenMl = 0.0;
    double dice = 1.0;
};

/// The measurements of one segment. Values are in modality units, exactly those of the voxels'
/// codes. They are computed from counts, so they do not depend on an order.
struct SegmentStatistics {
    Segment segment;
    std::int64_t voxels = 0;
    /// Each voxel counts with the volume that it represents; with uneven slices it extends half the
    /// way to either neighbour.
    double millilitres = 0.0;
    glm::ivec3 first{0}; ///< of the bounding box of its voxels, inclusive
    glm::ivec3 last{0};
    glm::dvec3 lowestLps{0.0}; ///< mm, of the centres of its voxels
    glm::dvec3 highestLps{0.0};
    glm::dvec3 centroidLps{0.0}; ///< mm, of the voxels' centres
    double surfaceMm2 = 0.0; ///< of the smoothed surface (SegmentSurface.h)
    /// Sphericity: the surface of a ball with the volume that the smoothed surface encloses,
    /// divided by that surface. 1 for a ball, less for every other shape. Voxels make surfaces
    /// rougher: for a ball of voxels it is about 0.97.
    double sphericity = 0.0;
    double longestMm = 0.0; ///< the greatest distance between two points of the smoothed surface
    /// The greatest distance between two points of it whose line is perpendicular to that one
    /// (DistanceAcross.h). In shapes with several longest diameters it is perpendicular to one of
    /// them.
    double acrossMm = 0.0;
    double minimum = 0.0;
    double maximum = 0.0;
    double mean = 0.0;
    double deviation = 0.0; ///< population standard deviation (divided by the number of voxels)
    double median = 0.0;
    /// The least value that occurs and that at least this percentage of the voxels do not exceed.
    std::array<double, statisticsPercentiles.size()> percentiles{};
    std::optional<ChangeSinceImport> sinceImport{}; ///< none: it was not imported
};

/// How the present voxels of a segment differ from those that were imported; none if it was not
/// imported.
[[nodiscard]] std::optional<ChangeSinceImport> changeSinceImport(const VoxelRuns& now, int label,
    const std::vector<ImportedVoxels>& imported, const VolumeGeometry& geometry);

/// Errors: Cancelled.
[[nodiscard]] Result<std::vector<SegmentStatistics>> segmentStatistics(const Volume& volume,
    const ExportRequest& request, const MaskSelection& selection, const Progress& progress);

} // namespace core
