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

/// Where two segments are nearest to each other: a place on the surface of either. They are one
/// place where the segments touch, at a corner at least, or share a voxel.
struct SegmentGap {
    glm::dvec3 fromLps{0.0};
    glm::dvec3 toLps{0.0};
    bool operator==(const SegmentGap&) const = default;
};

/// The surface of a segment is that of its voxels' cells, so along each of the grid's axes what
/// lies between two voxels is one step less than what lies between their centres, or nothing. On a
/// sheared grid it is measured between the corners of cells that face each other. Squared lengths
/// are whole numbers (MillimetreBall.h); of several places that are as near, the one with the
/// lowest voxel of the first segment, and then of the other, in the order of memory.
///
/// Cost: two passes over the volume, and those pairs of bricks along both surfaces that may be as
/// near. Any thread. Errors: Cancelled.
/// @param labels of the whole volume in the first segment's plane, x fastest
/// @param otherLabels in the other's; it may be the same
/// @return none: one of them has no voxel
[[nodiscard]] Result<std::optional<SegmentGap>> segmentGap(std::span<const std::uint8_t> labels,
    std::uint8_t label, std::span<const std::uint8_t> otherLabels, std::uint8_t otherLabel,
    const VolumeGeometry& geometry, const Progress& progress);

} // namespace core
