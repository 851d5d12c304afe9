// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/measure/MeasuredSize.h"
#include "core/measure/region/RegionStatistics.h"

#include <optional>
#include <span>

namespace core {

/// All that a measurement comes to.
struct Measured {
    Measurement measurement{};
    MeasuredSize size{};
    /// None: no voxel of the volume lies there, or it is no region.
    std::optional<RegionStatistics> values{};
};

/// @param codes of the whole volume, x fastest
[[nodiscard]] inline Measured measuredIn(
    const Measurement& measurement, const Volume& volume, std::span<const std::uint16_t> codes)
{
    return {.measurement = measurement,
        .size = measuredSize(measurement, volume),
        .values = regionStatistics(measurement, volume, codes)};
}

} // namespace core
