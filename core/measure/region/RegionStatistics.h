// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Measurement.h"
#include "core/volume/Volume.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace core {

/// Statistics of the values in a region, in modality units, exact for the voxels' codes. They are
/// computed from counts of codes, so they do not depend on any order.
struct RegionStatistics {
    /// Number of voxels, or of samples in an oblique plane (RegionVoxels.h)
    std::int64_t voxels = 0;
    double mean = 0.0;
    double deviation = 0.0; ///< population standard deviation (divided by the number of voxels)
    double minimum = 0.0;
    double maximum = 0.0;
};

/// Counts codes as they are read.
class RegionTally {
public:
    void add(std::span<const std::uint16_t> codes);
    /// None if nothing was counted.
    [[nodiscard]] std::optional<RegionStatistics> statistics(const VoxelEncoding& encoding) const;

    /// The smallest counted value that is not exceeded by at least this percentage of all counted
    /// values. None if nothing was counted.
    /// @param percent 0 … 100
    [[nodiscard]] std::optional<double> percentile(
        int percent, const VoxelEncoding& encoding) const;

private:
    std::vector<std::int64_t> m_ofCode = std::vector<std::int64_t>(VoxelEncoding::codeCount, 0);
};

/// The statistics of a region or a probe, by the rule of RegionVoxels.h; none: it is neither, or it
/// contains no voxel of the volume.
/// @param codes one for each voxel of the volume, x fastest
[[nodiscard]] std::optional<RegionStatistics> regionStatistics(
    const Measurement& measurement, const Volume& volume, std::span<const std::uint16_t> codes);

} // namespace core
