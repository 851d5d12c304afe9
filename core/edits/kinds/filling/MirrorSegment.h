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

/// Which sides of the patient are exchanged.
enum class MirroredSides : std::uint8_t { RightLeft, AnteriorPosterior, InferiorSuperior };

/// Mirror a segment about a plane. The plane lies across the axis of the grid that is nearest to
/// the chosen direction of the patient (axesOfPatient()), and goes through the centre of a voxel or
/// halfway between two, whichever is nearer to the place; so voxels are mirrored exactly onto
/// voxels. What would lie outside the volume is lost. Only voxels that no segment has are given.
/// Like CleanSegment it stores no voxels: the result is computed from the labels each time it is
/// carried out.
struct MirrorSegment {
    int segment = 0; ///< label
    MirroredSides sides = MirroredSides::RightLeft;
    std::optional<glm::dvec3> placeLps{}; ///< a point of the plane; none: the middle of the volume
    bool keep = false; ///< whether the segment keeps its own voxels, too
    std::optional<EditableRange> editable{}; ///< which voxels may change; none: any
};

[[nodiscard]] Result<void> check(const MirrorSegment& edit, const Document& document);
Result<bool> apply(const MirrorSegment& edit, Document& document);
[[nodiscard]] EditEffects effects(const MirrorSegment& edit);
[[nodiscard]] RowTitle rowTitle(const MirrorSegment& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const MirrorSegment& edit, const DependencyFacts& row);
[[nodiscard]] OpenManner openManner(const MirrorSegment& edit);

/// The command that carries out the edit; without bricks if there is nothing to do.
/// @param labels one for each voxel of the volume in the segment's plane, x fastest
/// Any thread. Errors: UnknownSegment, SegmentLocked, InvalidField (the place lies outside the
/// volume), Cancelled.
[[nodiscard]] Result<RelabelListed> relabelListed(const MirrorSegment& edit,
    const Document& document, std::span<const std::uint8_t> labels, const Progress& progress);

} // namespace core
