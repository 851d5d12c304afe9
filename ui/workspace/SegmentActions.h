// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QString>

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>

namespace core {
struct CleanSegment;
struct CombineSegments;
struct Document;
struct EvolveContour;
struct FillBetweenSlices;
struct FloodFill;
struct InvertSegment;
struct MirrorSegment;
struct ReshapeSegment;
struct Segment;
struct SplitByCurve;
struct SplitIslands;
struct SplitSegment;
struct ThresholdSegment;
} // namespace core

namespace ui {

class Workspace;

/// The colour for a new segment: the next of twelve colours that are easy to distinguish on grey,
/// by the number of segments.
[[nodiscard]] std::uint32_t nextSegmentColour(const core::Document& document);
/// "Segment 3": the first such name that is free.
[[nodiscard]] QString nextSegmentName(const core::Document& document);

/// Adds a segment as a step of its own and makes it the active one.
/// @param plane its label plane: it may share voxels with segments of other planes
/// @return its label
core::Result<int> addSegment(Workspace& workspace, std::uint8_t plane = 0);
/// The label of the active segment; if there is none, of the first one, which is made the active
/// one; 0: there is no segment. For strokes that may turn out to meet nothing.
int activateSegment(Workspace& workspace);
/// The same, but if there is no segment, the label of a new one.
core::Result<int> ensureActiveSegment(Workspace& workspace);

/// Deletes a segment with its voxels, as a step of its own, and tells the user. The segment below
/// it, or else above it, becomes the active one. Failures are reported by the workspace.
void removeSegment(Workspace& workspace, int label);

/// Each of the following functions carries out one edit as a step of its own and tells the user
/// what it did, or that there was nothing to do. Failures are reported by the workspace.

/// Makes a new segment with the voxels of a segment, which may be locked, in another label plane.
void duplicateSegment(Workspace& workspace, int label);

/// Fills the holes of a segment, keeps only its largest island, or removes those of its islands
/// that are smaller than smallIslandMm3().
void fillHoles(Workspace& workspace, int label);
void keepLargestIsland(Workspace& workspace, int label);
void removeSmallIslands(Workspace& workspace, int label);

/// Replaces a segment by all voxels that belong to no segment.
void invertSegment(Workspace& workspace, int label);

/// Makes the part of a segment behind the cutting plane, as the plane's viewer sees it, a new
/// segment.
void splitByPlane(Workspace& workspace, int label);
/// The edit that splitByPlane() would carry out, without an editable range; none if there is no
/// such segment.
[[nodiscard]] std::optional<core::SplitSegment> splitOfPlane(const Workspace& workspace, int label);
/// Makes the part of a segment on one side of a drawn curve a new segment. Unlike those above it
/// keeps to the editable range that the edit has.
void splitByCurve(Workspace& workspace, const core::SplitByCurve& edit);
/// "Liver: 1 043 mL · Liver 1: 482.1 mL": the volumes of two parts of the open study.
[[nodiscard]] QString partsText(const Workspace& workspace, const QString& name,
    std::int64_t voxels, const QString& otherName, std::int64_t otherVoxels);

/// The edits of the following nine functions may be previewed before (EditTrial).
/// @param isOpen whether @p edit stands open in the session, for its preview; it is committed then,
/// and nothing is computed again
///
/// reshapeSegment() grows, shrinks, hollows out, smooths or wraps a segment; fillBetweenSlices()
/// fills it between the slices on which it was drawn; takeThreshold() applies a threshold;
/// cleanSegment() fills holes or takes islands away; mirrorSegment() replaces it by its mirror
/// image, or adds that; splitIslands() makes islands of it segments of their own; splitSegment()
/// makes what lies beyond a plane a segment, and reports the volumes of both, as splitByCurve()
/// does; takeInverse() replaces it by what belongs to no segment; combineSegments() merges two
/// segments, swaps them, or applies a set operation to them.
void reshapeSegment(Workspace& workspace, const core::ReshapeSegment& edit, bool isOpen = false);
void fillBetweenSlices(
    Workspace& workspace, const core::FillBetweenSlices& edit, bool isOpen = false);
void takeThreshold(Workspace& workspace, const core::ThresholdSegment& edit, bool isOpen);
void cleanSegment(Workspace& workspace, const core::CleanSegment& edit, bool isOpen = false);
void mirrorSegment(Workspace& workspace, const core::MirrorSegment& edit, bool isOpen = false);
void splitIslands(Workspace& workspace, const core::SplitIslands& edit, bool isOpen = false);
void splitSegment(Workspace& workspace, const core::SplitSegment& edit, bool isOpen = false);
void takeInverse(Workspace& workspace, const core::InvertSegment& edit, bool isOpen = false);
void combineSegments(Workspace& workspace, const core::CombineSegments& edit, bool isOpen = false);

/// Returns the size below which an island counts as small: 100 mm³, or a hundredth of its segment
/// where that is less. Specks of a growth or of a network are smaller, and hardly anything that
/// users look for is.
[[nodiscard]] double smallIslandMm3(const Workspace& workspace, const core::Segment& segment);

/// Fills or erases a region around a clicked voxel.
void floodFill(Workspace& workspace, const core::FloodFill& edit);

/// Accepts an evolved contour.
void evolveContour(Workspace& workspace, const core::EvolveContour& edit);

/// The island of a segment that contains the voxel at a place (LPS mm) is removed, is kept while
/// all others are removed, or is given to another segment.
void removeIsland(Workspace& workspace, int label, const glm::dvec3& placeLps);
void keepOnlyIsland(Workspace& workspace, int label, const glm::dvec3& placeLps);
void giveIsland(Workspace& workspace, int label, int to, const glm::dvec3& placeLps);

} // namespace ui
