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

/// Make new segments of a segment's islands (core/islands/SegmentIslands.h), one of each, from the
/// second largest down; the largest stays the segment's, and so does what is too small. Like
/// CleanSegment it is worked out anew from the labels whenever it is carried out. How many segments
/// it makes is known only then: an edit that was carried out names them.
struct SplitIslands {
    int segment = 0; ///< label
    std::optional<double> mm3{}; ///< islands that are smaller stay; none: none is too small
    /// The new segments, from the largest down; islands beyond them stay. None: one of each island.
    std::optional<std::vector<SplitPart>> into{};
};

[[nodiscard]] Result<void> check(const SplitIslands& edit, const Document& document);
Result<bool> apply(const SplitIslands& edit, Document& document);
[[nodiscard]] EditEffects effects(const SplitIslands& edit);
[[nodiscard]] RowTitle rowTitle(const SplitIslands& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const SplitIslands& edit, const DependencyFacts& row);

/// The fewest voxels of an island that becomes a segment.
[[nodiscard]] std::int64_t leastVoxels(const SplitIslands& edit, const VolumeGeometry& geometry);

/// The edit for an engine; no bricks: there is nothing to be done.
/// @param edit is completed: it names the segments that it makes, if it makes any
/// @param labels of the whole volume in the segment's plane, x fastest
/// Any thread. Errors: UnknownSegment, SegmentLocked, TooManyIslands, InvalidField (it names more
/// segments than there are islands, or than there can be), Cancelled.
[[nodiscard]] Result<LabelListed> labelListed(SplitIslands& edit, const Document& document,
    std::span<const std::uint8_t> labels, const Progress& progress);

} // namespace core
