// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <span>

namespace core {

struct VolumeGeometry;

/// Where two segments are nearest to each other: one place on the surface of each. Both are the
/// same place if the segments share a voxel or touch, be it at a corner. Where slices are unevenly
/// spaced, they are the places that views show.
struct SegmentGap {
    glm::dvec3 fromLps{0.0};
    glm::dvec3 toLps{0.0};
    bool operator==(const SegmentGap&) const = default;
};

/// Finds the shortest distance between two segments. Their surfaces are those of their voxels'
/// cells, which are apart as CellDistances.h says. If several places are equally near, the one with
/// the lowest voxel of the first segment in the order of memory counts, then of the other.
///
/// Cost: two passes over the volume, and a comparison of those pairs of bricks along both surfaces
/// that may be nearest. Any thread. Errors: Cancelled.
/// @param labels one for each voxel of the volume in the first segment's plane, x fastest
/// @param otherLabels the same in the other's plane; it may be the same one
/// @return none if one of the segments has no voxels
[[nodiscard]] Result<std::optional<SegmentGap>> segmentGap(std::span<const std::uint8_t> labels,
    std::uint8_t label, std::span<const std::uint8_t> otherLabels, std::uint8_t otherLabel,
    const VolumeGeometry& geometry, const Progress& progress);

} // namespace core
