// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/EditableRange.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <span>

namespace core {

struct MapLabels;

/// Copy a segment: a new one has the same voxels and the same code, in another label plane, so that
/// both have them. The segment itself is only read and may be locked. If the copy takes no voxel,
/// nothing happens. Like CleanSegment it stores no voxels: they are those that the segment has when
/// it is carried out.
struct CopySegment {
    int segment = 0; ///< label of the one that is copied
    QString name{}; ///< of the copy
    std::uint32_t rgb = 0;
    /// The label plane of the copy, not the segment's. Voxels that other segments have in it are
    /// left out. None: planeOfCopy() decides; an edit that was carried out names the plane.
    std::optional<int> plane{};
    std::optional<EditableRange> editable{}; ///< which voxels are copied; none: all
};

[[nodiscard]] Result<void> check(const CopySegment& edit, const Document& document);
/// As long as the plane is not named, the copy is put into any that may become it.
Result<bool> apply(const CopySegment& edit, Document& document);
[[nodiscard]] EditEffects effects(const CopySegment& edit);
[[nodiscard]] RowTitle rowTitle(const CopySegment& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const CopySegment& edit, const DependencyFacts& row);

/// The label plane of the copy if the edit names none: the first one with segments in which all
/// voxels of the segment are free, whatever the editable range, or else the first one without
/// segments. Errors: InvalidField (there is neither).
/// @param taken planes in which another segment has one of the segment's voxels; its own is never
/// considered
[[nodiscard]] Result<int> planeOfCopy(
    const CopySegment& edit, const Document& document, std::span<const std::uint8_t> taken);

/// The command that gives the copy its voxels.
/// @pre the edit names a plane
/// Errors: UnknownSegment, InvalidField (the segment's own plane, no room for another segment, an
/// editable range inside other segments).
[[nodiscard]] Result<MapLabels> mapLabels(const CopySegment& edit, const Document& document);

} // namespace core
