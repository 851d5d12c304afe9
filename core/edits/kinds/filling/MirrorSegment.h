// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/EditableRange.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <span>

namespace core {

struct RelabelListed;

/// Which of the patient's sides change places.
enum class MirroredSides : std::uint8_t { RightLeft, AnteriorPosterior, InferiorSuperior };

/// Mirror a segment about a plane across the grid's axis that lies nearest to that direction of the
/// patient (axesOfPatient()), so that voxels come to lie on voxels: the plane goes through a
/// voxel's centre, or halfway between two, whichever is nearer to the place. What would come to lie
/// beside the volume is lost. Like CleanSegment it is worked out anew from the labels whenever it
/// is carried out, and takes only voxels that no segment has.
struct MirrorSegment {
    int segment = 0; ///< label
    MirroredSides sides = MirroredSides::RightLeft;
    std::optional<glm::dvec3> placeLps{}; ///< in the plane; none: the middle of the volume
    bool keep = false; ///< whether it keeps what it has, beside its mirror image
    std::optional<EditableRange> editable{}; ///< which voxels may change at all; none: any
};

[[nodiscard]] Result<void> check(const MirrorSegment& edit, const Document& document);
Result<bool> apply(const MirrorSegment& edit, Document& document);
[[nodiscard]] EditEffects effects(const MirrorSegment& edit);
[[nodiscard]] RowTitle rowTitle(const MirrorSegment& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const MirrorSegment& edit, const DependencyFacts& row);

/// The edit for an engine; no bricks: there is nothing to be done.
/// @param labels of the whole volume in the segment's plane, x fastest
/// Any thread. Errors: UnknownSegment, SegmentLocked, InvalidField (the place lies outside the
/// volume), Cancelled.
[[nodiscard]] Result<RelabelListed> relabelListed(const MirrorSegment& edit,
    const Document& document, std::span<const std::uint8_t> labels, const Progress& progress);

} // namespace core
