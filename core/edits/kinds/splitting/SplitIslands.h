// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/splitting/SplitParts.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace core {

struct LabelListed;
struct VolumeGeometry;

/// Make a new segment of each island of a segment (core/islands/SegmentIslands.h), from the second
/// largest down. The largest island stays with the segment, and so do islands that are too small.
/// Like CleanSegment it stores no voxels: the result is computed from the labels each time it is
/// carried out. The number of new segments is known only then; an edit that was carried out lists
/// them.
struct SplitIslands {
    int segment = 0; ///< label
    /// Smaller islands stay with the segment; none: no island is too small.
    std::optional<double> mm3{};
    /// The new segments, from the largest island down; further islands stay with the segment. None:
    /// one segment for each island.
    std::optional<std::vector<SplitPart>> into{};
};

[[nodiscard]] Result<void> check(const SplitIslands& edit, const Document& document);
Result<bool> apply(const SplitIslands& edit, Document& document);
[[nodiscard]] EditEffects effects(const SplitIslands& edit);
[[nodiscard]] RowTitle rowTitle(const SplitIslands& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const SplitIslands& edit, const DependencyFacts& row);

/// The number of voxels that an island must have at least to become a segment.
[[nodiscard]] std::int64_t leastVoxels(const SplitIslands& edit, const VolumeGeometry& geometry);

/// The command that carries out the edit; without bricks if there is nothing to do.
/// @param edit its `into` is filled in if it is empty and there are segments to make
/// @param labels one for each voxel of the volume in the segment's plane, x fastest
/// Any thread. Errors: UnknownSegment, SegmentLocked, TooManyIslands, InvalidField (`into` has more
/// segments than there are islands, or than the document has room for), Cancelled.
[[nodiscard]] Result<LabelListed> labelListed(SplitIslands& edit, const Document& document,
    std::span<const std::uint8_t> labels, const Progress& progress);

} // namespace core
