// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/EditableRange.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace core {

class ContourEvolution;
struct ContourGround;
struct ContourRule;
struct RelabelListed;

/// Let the contour of a segment evolve by values, edges and smoothness, from the segment as it
/// stands or from bubbles (core/contour/ContourRule.h defines the rule). Voxels join the segment
/// and leave it. Like CleanSegment it stores no voxels: the result is computed from the labels each
/// time it is carried out. A second such edit continues where the first one stopped.
struct EvolveContour {
    int segment = 0; ///< label
    std::optional<double> lower{}; ///< modality units, inclusive; none: any
    std::optional<double> upper{};
    /// How far inside the interval, or outside it, a value must lie to count in full, modality
    /// units.
    double softness = 0.0;
    /// How much values count, 0 … 100; `edge` and `smoothness` have the same range.
    int region = 100;
    int edge = 0; ///< how much edges attract the contour
    /// With `edge` > 0: the gradient of an edge that counts half, modality units per mm.
    double edgeGradient = 0.0;
    int smoothness = 50;
    /// The segment first receives a ball around this place.
    std::optional<glm::dvec3> bubbleLps{};
    double bubbleMm = 0.0; ///< radius of that ball, and of all others
    /// With bubbleLps: further places, around each of which it receives such a ball. None for rows
    /// that are older than this field.
    std::optional<std::vector<glm::dvec3>> furtherBubblesLps{};
    int generations = 10; ///< greatest number; it stops earlier if nothing changes any more
    bool overwriteUnlocked = false; ///< without meaning if it erases
    std::optional<EditableRange> editable{}; ///< which voxels may change; none: any
    /// Whether it grows round where nothing stops it (ContourRule::round). None is the same as
    /// false, for rows that are older than this field: it grows into an octahedron.
    std::optional<bool> round{};
    /// Whether a part of the segment evolves instead, which the segment loses: it grows where
    /// values lie in the interval, and no other voxel changes. From bubbles it begins as the
    /// segment's voxels in the balls and ends at the segment's border; without one it comes in from
    /// everywhere around the segment. None is the same as false, for rows that are older than this
    /// field.
    std::optional<bool> erase{};
    bool operator==(const EvolveContour&) const = default;
};

/// Each generation moves the contour by at most one voxel, so the box that is kept in memory grows
/// with their number.
constexpr int mostContourGenerations = 2000;

[[nodiscard]] Result<void> check(const EvolveContour& edit, const Document& document);
Result<bool> apply(const EvolveContour& edit, Document& document);
[[nodiscard]] EditEffects effects(const EvolveContour& edit);
[[nodiscard]] RowTitle rowTitle(const EvolveContour& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const EvolveContour& edit, const DependencyFacts& row);

/// The rule of the edit in whole numbers. Errors: those of check().
[[nodiscard]] Result<ContourRule> contourRule(const EvolveContour& edit, const Document& document);
/// The ground on which the contour evolves, without codes; with an empty box if the segment is
/// empty and there is no bubble. Bubbles give the segment those voxels that may change and whose
/// step from the voxel nearest to a bubble's centre lies in a MillimetreBall of their radius.
/// While erasing it takes them away, and the box is empty if the segment has none of them.
/// @param labels one for each voxel of the volume in the segment's plane, x fastest
/// Uses all cores; any thread outside a parallelFor(). Errors: those of check(), OutOfMemory,
/// Cancelled.
[[nodiscard]] Result<ContourGround> contourGround(const EvolveContour& edit,
    const Document& document, std::span<const std::uint8_t> labels,
    const Progress& progress = Progress());
/// The command that writes the result; without bricks if nothing has changed. Errors:
/// UnknownSegment, SegmentLocked.
[[nodiscard]] Result<RelabelListed> relabelListed(
    const EvolveContour& edit, const Document& document, const ContourEvolution& evolution);

} // namespace core
