// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/EditableRange.h"

#include <cstdint>

namespace core {

struct MapLabels;
struct MapPlanes;

/// Give a segment voxels of another, or take some away by it.
///
/// Merging and swapping write to both segments: neither may be locked. Where they lie in different
/// label planes, other segments may be in the way of either, each in its own plane. A merge then
/// leaves with the other segment the voxels that the first cannot have; a swap is refused, because
/// it would be unclear which of the two keeps what. The set operations write to the first segment
/// alone and only read the other, which may be locked. Within one plane no voxel belongs to both,
/// so there they would have no effect: they need segments of different planes. Each can stand open
/// as a preview.
struct CombineSegments {
    enum class How : std::uint8_t {
        /// The segment receives all voxels of the other, which stays in the list, empty. Of a
        /// segment of another plane it receives those that are free in its own plane, and the other
        /// keeps the rest.
        Merge,
        Swap, ///< each receives the voxels of the other; both lie in one plane
        Union, ///< the segment also receives the voxels of the other that are free in its plane
        Subtract, ///< it loses the voxels that the other has
        Intersect, ///< it keeps only the voxels that the other has
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
[[nodiscard]] std::unique_ptr<OpenStroke> openStroke(CombineSegments& edit);

/// Converts the edit to an engine's command. Seeds at voxels that change their segment are removed,
/// so no growth continues from there. Errors: UnknownSegment, SegmentLocked, InvalidField (a
/// segment with itself, a label plane that does not fit, an editable range inside segments where
/// the operation itself has one).
[[nodiscard]] Result<MapLabels> mapLabels(const CombineSegments& edit, const Document& document);
/// The same for a merge of segments of two label planes, which mapLabels() refuses. Errors: also
/// InvalidField for an editable range outside the segment: voxels that it receives lie inside it
/// from then on.
[[nodiscard]] Result<MapPlanes> mapPlanes(const CombineSegments& edit, const Document& document);

} // namespace core
