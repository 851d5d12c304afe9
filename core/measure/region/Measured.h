// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/measure/MeasuredSize.h"
#include "core/measure/region/RegionStatistics.h"

#include <optional>
#include <span>

namespace core {

/// A measurement with all its results.
struct Measured {
    Measurement measurement{};
    MeasuredSize size{};
    /// The statistics of the values; none: it is no region or probe, or it contains no voxel of the
    /// volume.
    std::optional<RegionStatistics> values{};
};

/// Measures a measurement.
/// @param codes one for each voxel of the volume, x fastest
[[nodiscard]] inline Measured measuredIn(
    const Measurement& measurement, const Volume& volume, std::span<const std::uint16_t> codes)
{
    return {.measurement = measurement,
        .size = measuredSize(measurement, volume),
        .values = regionStatistics(measurement, volume, codes)};
}

} // namespace core
