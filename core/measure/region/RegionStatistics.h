// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Measurement.h"
#include "core/volume/Volume.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace core {

/// The values in a region, in modality units, exactly those of the voxels' codes. They are worked
/// out from counts of codes, so they depend on no order.
struct RegionStatistics {
    std::int64_t voxels = 0; ///< or samples of an oblique plane (RegionVoxels.h)
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

    /// The least value that is as great as so many percent of what was counted, at least; one of
    /// those values. None if nothing was counted.
    /// @param percent 0 … 100
    [[nodiscard]] std::optional<double> percentile(
        int percent, const VoxelEncoding& encoding) const;

private:
    std::vector<std::int64_t> m_ofCode = std::vector<std::int64_t>(VoxelEncoding::codeCount, 0);
};

/// Those of a region or a probe, by the rule of RegionVoxels.h; none: no voxel of the volume lies
/// in it, or it is no region.
/// @param codes of the whole volume, x fastest
[[nodiscard]] std::optional<RegionStatistics> regionStatistics(
    const Measurement& measurement, const Volume& volume, std::span<const std::uint16_t> codes);

} // namespace core
