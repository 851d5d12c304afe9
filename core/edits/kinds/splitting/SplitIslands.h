// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/brick/BrickGrid.h"
#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/EditableRange.h"
#include "core/edits/kinds/splitting/SplitParts.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace core {

struct LabelListed;
struct LabelPlane;
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
    /// Which voxels may change; none: any. Islands are those of the whole segment; the others keep
    /// the segment's label, and an island that has none that may change becomes no segment.
    std::optional<EditableRange> editable{};
};

[[nodiscard]] Result<void> check(const SplitIslands& edit, const Document& document);
Result<bool> apply(const SplitIslands& edit, Document& document);
[[nodiscard]] EditEffects effects(const SplitIslands& edit);
[[nodiscard]] RowTitle rowTitle(const SplitIslands& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const SplitIslands& edit, const DependencyFacts& row);
[[nodiscard]] OpenManner openManner(const SplitIslands& edit);

/// The number of voxels that an island must have at least to become a segment.
[[nodiscard]] std::int64_t leastVoxels(const SplitIslands& edit, const VolumeGeometry& geometry);

/// What is read of the volume to know which islands may change at all.
struct SplitGround {
    std::span<const LabelPlane> planes{}; ///< the segment's, and those that the range refers to
    VoxelBox box; ///< in which all voxels of the segment lie
    std::span<const std::uint16_t>
        codes{}; ///< of the box, x fastest; empty: the range is not by value
};

/// Whether the values of voxels decide which of them may change.
[[nodiscard]] inline bool isByValue(const SplitIslands& edit)
{
    return edit.editable && (edit.editable->lower || edit.editable->upper);
}

/// The command that carries out the edit; without bricks if there is nothing to do.
/// @param edit its `into` is filled in if it is empty and there are segments to make
/// Any thread outside a parallelFor(). Errors: UnknownSegment, SegmentLocked, TooManyIslands,
/// InvalidField (`into` has more segments than there are islands, or than the document has room
/// for), those of editableVoxels(), Cancelled.
[[nodiscard]] Result<LabelListed> labelListed(SplitIslands& edit, const Document& document,
    const SplitGround& ground, const Progress& progress);

} // namespace core
