// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/engine/EngineEdit.h"

#include <optional>
#include <utility>
#include <vector>

namespace core {

struct BrushPath;
struct SegmentChoice;

// Functions that conversions of several edits share: from millimetres and modality units to the
// integers of an engine. Doubles are used here and nowhere later. The build forbids fused
// multiply-add, so the results are the same on every machine. The conversion of one edit is in that
// edit's header (DrillStroke.h).

/// Converts a specific command to the general type.
template <class Command> [[nodiscard]] Result<EngineEdit> engineEditFrom(Result<Command> command)
{
    if (!command)
        return tl::unexpected(command.error());
    return EngineEdit(*std::move(command));
}

/// The nearest voxel; none outside the volume.
[[nodiscard]] std::optional<glm::ivec3> voxelNearest(
    const glm::dvec3& point, const VolumeGeometry& geometry);
/// For messages: "[1, 2, 3]".
[[nodiscard]] QString pointText(const glm::dvec3& lps);

/// The voxels nearest to the points of a stroke, each once, ordered by slice first. Errors:
/// SeedOutsideVolume (names the point and the field).
[[nodiscard]] Result<std::vector<glm::ivec3>> seedVoxels(const std::vector<glm::dvec3>& pointsLps,
    const VolumeGeometry& geometry, const char* field = "pointsLps");

/// The axes of a view in LPS: right, up, forward, as matrix columns. Errors: InvalidField (a field
/// below @p field: eye and target coincide, or up is parallel to the view direction).
[[nodiscard]] Result<glm::dmat3> viewAxes(const OrthographicView& view, const QString& field);

/// The label that receives voxels; for a new segment that is the next free one. Errors:
/// UnknownSegment, SegmentLocked.
[[nodiscard]] Result<LabelTarget> labelTarget(
    const SegmentChoice& choice, bool overwriteUnlocked, const Document& document);
/// The same for a segment that exists already.
[[nodiscard]] Result<LabelTarget> segmentTarget(
    int label, bool overwriteUnlocked, const Document& document);

/// The frame of a brush. Of its points only the first is used, and only by flat shapes. Errors:
/// InvalidField below @p name (no point, a shape without the directions that it needs).
[[nodiscard]] Result<CapsuleFrame> capsuleFrame(
    const BrushPath& path, const VolumeGeometry& geometry, const QString& name);

/// The path of a brush as capsules, each no longer than the frame allows. Capsules that cannot meet
/// the volume are left out.
/// @param ofTolerance as in PartPressures
[[nodiscard]] std::vector<Capsule> capsules(
    const BrushPath& path, const VolumeGeometry& geometry, bool ofTolerance = false);

/// How firmly the pen is pressed along a part of a path (PenPressures).
struct PartPressures {
    std::vector<double> atPoints{}; ///< for each point of the part; empty: full pressure
    double before = 1.0; ///< pressure at the last point of the previous part
    /// Whether pressures change the tolerance of a brush that follows edges, instead of its radius.
    /// The path is then cut so that the tolerances of two consecutive capsules differ by at most an
    /// eighth.
    bool ofTolerance = false;
};
/// The capsules of a part of the path, through @p points. @p from is the last point of the previous
/// part; null for the first part and where the path begins anew. Where the radius changes, the path
/// is cut into such short capsules that the radii of two consecutive ones differ by at most a
/// quarter of a voxel; each has the radius at its middle. If the radius changes by more than the
/// length of a piece, the ball at the larger end covers the whole piece, and it becomes the only
/// capsule.
[[nodiscard]] std::vector<Capsule> capsules(const BrushPath& path, const VolumeGeometry& geometry,
    const glm::dvec3* from, const std::vector<glm::dvec3>& points,
    const PartPressures& pressures = {});

/// The voxels under the pen along a path that lie in the volume; the path may leave it. For a flat
/// brush, only voxels of its slab. They are what CapsulePath::under states for a brush that follows
/// edges.
[[nodiscard]] std::vector<glm::ivec3> voxelsUnder(
    const BrushPath& path, const VolumeGeometry& geometry);
/// The same for a part of a path; the parameters are those of capsules().
[[nodiscard]] std::vector<glm::ivec3> voxelsUnder(const BrushPath& path,
    const VolumeGeometry& geometry, const glm::dvec3* from, const std::vector<glm::dvec3>& points);
/// The voxel under the first point; if that is outside the volume, the nearest voxel.
[[nodiscard]] glm::ivec3 startVoxel(const BrushPath& path, const VolumeGeometry& geometry);

} // namespace core
