// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/engine/EngineCommands.h"

#include <optional>
#include <utility>
#include <vector>

namespace core {

struct BrushPath;
struct SegmentChoice;

// What conversions of several edits share: from millimetres and modality units to the integers an
// engine works with. Doubles are used here and nowhere after; the build forbids fused multiply-add,
// so every machine agrees. The conversion of an edit itself stands beside it (DrillStroke.h).

/// A command as any one.
template <class Command> [[nodiscard]] Result<EngineEdit> engineEditFrom(Result<Command> command)
{
    if (!command)
        return tl::unexpected(command.error());
    return EngineEdit(*std::move(command));
}

/// None outside the volume.
[[nodiscard]] std::optional<glm::ivec3> voxelNearest(
    const glm::dvec3& point, const VolumeGeometry& geometry);
/// For messages: "[1, 2, 3]".
[[nodiscard]] QString pointText(const glm::dvec3& lps);

/// The voxels nearest to a stroke's points, each once, slices first. Errors: SeedOutsideVolume
/// (names the point and the field).
[[nodiscard]] Result<std::vector<glm::ivec3>> seedVoxels(const std::vector<glm::dvec3>& pointsLps,
    const VolumeGeometry& geometry, const char* field = "pointsLps");

/// A view's axes in LPS: right, up, forward, as matrix columns. Errors: InvalidField (below
/// @p field: eye and target are one point, or up points along the view).
[[nodiscard]] Result<glm::dmat3> viewAxes(const OrthographicView& view, const QString& field);

/// The label that receives voxels: of a new segment the next one. Errors: UnknownSegment,
/// SegmentLocked.
[[nodiscard]] Result<LabelTarget> labelTarget(
    const SegmentChoice& choice, bool overwriteUnlocked, const Document& document);

/// The frame of a brush; of its points only a disc's first is looked at. Errors: InvalidField,
/// below @p name (no point, a disc without a direction across its plane).
[[nodiscard]] Result<CapsuleFrame> capsuleFrame(
    const BrushPath& path, const VolumeGeometry& geometry, const QString& name);

/// A brush's way, in pieces that the frame has room for; what cannot meet the volume is left out.
[[nodiscard]] std::vector<Capsule> capsules(const BrushPath& path, const VolumeGeometry& geometry);

/// A part of it, through @p points: `from` is the last point of the part before (none for the
/// first, and where the path begins anew).
[[nodiscard]] std::vector<Capsule> capsules(const BrushPath& path, const VolumeGeometry& geometry,
    const glm::dvec3* from, const std::vector<glm::dvec3>& points);

} // namespace core
