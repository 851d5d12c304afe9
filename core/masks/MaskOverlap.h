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

// Segments of one mask that overlap: which label planes they need if all of them are to keep their
// voxels, or which segment gets the voxels if they all go into one plane, where a voxel has one
// segment.

/// The voxels that exactly these segments share.
struct MaskOverlap {
    /// Indices of the segments in the mask, ascending; at least two.
    std::vector<std::size_t> segments;
    std::uint64_t voxels = 0;
    bool operator==(const MaskOverlap&) const = default;
};

/// All overlaps of a mask, in ascending order of the indices. Cost ∝ the runs, regardless of the
/// number of segments.
[[nodiscard]] std::vector<MaskOverlap> overlapsOf(const std::vector<MaskSegment>& segments);

/// The number of voxels in all of these overlaps together.
[[nodiscard]] std::uint64_t voxelsOf(const std::vector<MaskOverlap>& overlaps);

/// A label plane for each segment, numbered from 0: in the order of the mask, each goes to the
/// first plane in which it shares no voxel with a segment that is already there. All 0 if none
/// overlap.
/// @param count number of segments of the mask
[[nodiscard]] std::vector<int> planesFor(
    const std::vector<MaskOverlap>& overlaps, std::size_t count);

/// How many voxels the segment `from` gives up to the segment `to`, which takes precedence.
struct OverlapGiven {
    std::size_t to = 0;
    std::size_t from = 0;
    std::uint64_t voxels = 0;
    bool operator==(const OverlapGiven&) const = default;
};

/// What each pair of segments gives away if every voxel goes to the first of its segments in @p
/// order; in descending order of voxels.
/// @param order indices of all segments of the mask; a segment takes precedence over those after it
[[nodiscard]] std::vector<OverlapGiven> givenAway(
    const std::vector<MaskOverlap>& overlaps, const std::vector<std::size_t>& order);

/// Notes for the user on overlapping segments of an import: that they lie in several planes, if
/// they do; and for each pair that overlaps within one plane, which takes precedence, in descending
/// order of voxels. No notes if all segments become one.
/// @param edit holds the segments
[[nodiscard]] std::vector<MaskNote> notesOnOverlaps(const std::vector<MaskOverlap>& overlaps,
    const ImportMask& edit, const VolumeGeometry& geometry);

} // namespace core
