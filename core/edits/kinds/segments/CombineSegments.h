// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/EditableRange.h"

#include <cstdint>

namespace core {

struct MapLabels;

/// Two segments as wholes, neither of them locked. They are of one label plane, in which no voxel
/// is both, so there is nothing to copy, subtract or intersect between them; two planes cannot be
/// written in one step.
struct CombineSegments {
    enum class How : std::uint8_t {
        Merge, ///< all voxels of the other become the segment's; the other stays in the list, empty
        Swap, ///< each receives the voxels of the other
    };
    int segment = 0; ///< label
    int with = 0; ///< label of the other
    How how = How::Merge;
    std::optional<EditableRange> editable{}; ///< which voxels may change at all; none: any
};

[[nodiscard]] Result<void> check(const CombineSegments& edit, const Document& document);
Result<bool> apply(const CombineSegments& edit, Document& document);
[[nodiscard]] EditEffects effects(const CombineSegments& edit);
[[nodiscard]] RowTitle rowTitle(const CombineSegments& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(
    const CombineSegments& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const CombineSegments& edit, const Document& document);

/// No growth goes on from voxels that changed hands, since seeds of the one that had them go.
/// Errors: UnknownSegment, SegmentLocked, InvalidField (a segment with itself, or with one of
/// another label plane).
[[nodiscard]] Result<MapLabels> mapLabels(const CombineSegments& edit, const Document& document);

} // namespace core
