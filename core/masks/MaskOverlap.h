// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/masks/MaskNote.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace core {

struct ImportMask;
struct MaskSegment;
struct VolumeGeometry;

// Where segments of one mask overlap: which label planes they need to keep what they share, and
// which of them gets the voxels of one plane, where a voxel has one segment.

/// Voxels that several segments have, and no other one.
struct MaskOverlap {
    std::vector<std::size_t> segments; ///< their places in the mask, ascending; at least two
    std::uint64_t voxels = 0;
    bool operator==(const MaskOverlap&) const = default;
};

/// Ascending by the places of the segments. The cost is that of the runs, whatever the number of
/// segments.
[[nodiscard]] std::vector<MaskOverlap> overlapsOf(const std::vector<MaskSegment>& segments);

/// The voxels in all of them.
[[nodiscard]] std::uint64_t voxelsOf(const std::vector<MaskOverlap>& overlaps);

/// The label plane of each segment, from 0: in the order of the mask, each goes to the first plane
/// in which none of its voxels is another one's. All 0 if none overlap.
/// @param count of the mask's segments
[[nodiscard]] std::vector<int> planesFor(
    const std::vector<MaskOverlap>& overlaps, std::size_t count);

/// How many voxels of the one segment go to the other, which goes before it.
struct OverlapGiven {
    std::size_t to = 0;
    std::size_t from = 0;
    std::uint64_t voxels = 0;
    bool operator==(const OverlapGiven&) const = default;
};

/// Every voxel goes to the first of its segments; most voxels first.
/// @param order places of all the mask's segments, the first one before all others
[[nodiscard]] std::vector<OverlapGiven> givenAway(
    const std::vector<MaskOverlap>& overlaps, const std::vector<std::size_t>& order);

/// That the segments of an import lie in several planes; and of those of one plane, which go before
/// which others, a note for each pair, most voxels first. None if all segments become one.
/// @param edit holds the segments
[[nodiscard]] std::vector<MaskNote> notesOnOverlaps(const std::vector<MaskOverlap>& overlaps,
    const ImportMask& edit, const VolumeGeometry& geometry);

} // namespace core
