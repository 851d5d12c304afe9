// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QString>

#include <glm/glm.hpp>

#include <cstdint>

namespace core {
struct Document;
struct EvolveContour;
struct FillBetweenSlices;
struct FloodFill;
struct MirrorSegment;
struct ReshapeSegment;
struct Segment;
struct SplitIslands;
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
/// @return its label
core::Result<int> addSegment(Workspace& workspace);
/// The label of the active segment; if there is none, of the first one; if there is no segment, of
/// a new one.
core::Result<int> ensureActiveSegment(Workspace& workspace);

/// Deletes a segment with its voxels, as a step of its own, and tells the user. The segment below
/// it, or else above it, becomes the active one. Failures are reported by the workspace.
void removeSegment(Workspace& workspace, int label);

/// Gives all voxels of a segment to another one, or exchanges those of two, as a step of its own,
/// and tells the user what it did, or that there was nothing.
void mergeSegments(Workspace& workspace, int from, int into);
void swapSegments(Workspace& workspace, int one, int other);

/// The same for holes and islands of a segment; smallIslandMm3() tells which ones are small.
void fillHoles(Workspace& workspace, int label);
void keepLargestIsland(Workspace& workspace, int label);
void removeSmallIslands(Workspace& workspace, int label);

/// The same for a segment that becomes its mirror image, or all that no segment has.
void mirrorSegment(Workspace& workspace, const core::MirrorSegment& edit);
void invertSegment(Workspace& workspace, int label);

/// The same for what lies behind the cutting plane, as its viewer sees it: it becomes a new
/// segment.
void splitByPlane(Workspace& workspace, int label);

/// The same for what a ball of millimetres makes of a segment.
void reshapeSegment(Workspace& workspace, const core::ReshapeSegment& edit);

/// The same for what lies between the slices on which a segment was drawn.
void fillBetweenSlices(Workspace& workspace, const core::FillBetweenSlices& edit);

/// The same for islands that become segments.
void splitIslands(Workspace& workspace, const core::SplitIslands& edit);
/// An island is small below 100 mm³, or below a hundredth of its segment where that is less: specks
/// of a growth or a network are, and hardly anything that is looked for.
[[nodiscard]] double smallIslandMm3(const Workspace& workspace, const core::Segment& segment);

/// The same for a region that was clicked.
void floodFill(Workspace& workspace, const core::FloodFill& edit);

/// The same for a contour that was watched.
void evolveContour(Workspace& workspace, const core::EvolveContour& edit);

/// The same for an interval of values.
/// @param isShown it stands open (ThresholdSegment), and is taken as it is shown
void takeThreshold(Workspace& workspace, const core::ThresholdSegment& edit, bool isShown);

/// The same for the island of a segment that has a voxel at a place: it goes, all others go, or it
/// becomes another segment's.
void removeIsland(Workspace& workspace, int label, const glm::dvec3& placeLps);
void keepOnlyIsland(Workspace& workspace, int label, const glm::dvec3& placeLps);
void giveIsland(Workspace& workspace, int label, int to, const glm::dvec3& placeLps);

} // namespace ui
