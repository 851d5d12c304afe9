// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/EditableRange.h"

#include <cstdint>

namespace core {

struct MapLabels;

/// Merge two segments, or swap their voxels. Neither may be locked, and both must be in one label
/// plane, because two planes cannot be written in one step. Within one plane no voxel belongs to
/// both, so copying, subtracting or intersecting them would have no effect.
struct CombineSegments {
    enum class How : std::uint8_t {
        Merge, ///< the segment receives all voxels of the other, which stays in the list, empty
        Swap, ///< each receives the voxels of the other
    };
    int segment = 0; ///< label
    int with = 0; ///< label of the other segment
    How how = How::Merge;
    std::optional<EditableRange> editable{}; ///< which voxels may change; none: any
};

[[nodiscard]] Result<void> check(const CombineSegments& edit, const Document& document);
Result<bool> apply(const CombineSegments& edit, Document& document);
[[nodiscard]] EditEffects effects(const CombineSegments& edit);
[[nodiscard]] RowTitle rowTitle(const CombineSegments& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(
    const CombineSegments& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const CombineSegments& edit, const Document& document);

/// Converts the edit to an engine's command. Seeds at voxels that change their segment are removed,
/// so no growth continues from there. Errors: UnknownSegment, SegmentLocked, InvalidField (a
/// segment with itself, or with one of another label plane).
[[nodiscard]] Result<MapLabels> mapLabels(const CombineSegments& edit, const Document& document);

} // namespace core
