// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/EditableRange.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <span>

namespace core {

class ContourEvolution;
struct ContourGround;
struct ContourRule;
struct RelabelListed;

/// Let the contour of a segment evolve by values, edges and smoothness (core/contour/ContourRule.h
/// has the rule), from the segment as it stands or from a bubble. Voxels join and leave. Like
/// CleanSegment it is worked out anew from the labels whenever it is carried out; evolving again
/// goes on where it stopped.
struct EvolveContour {
    int segment = 0; ///< label
    std::optional<double> lower{}; ///< modality units, inclusive; none: any
    std::optional<double> upper{};
    /// How far within the interval, and beyond it, values count in full, modality units.
    double softness = 0.0;
    int region = 100; ///< how much values count, 0 … 100, as the next two
    int edge = 0; ///< how much shorter the contour is along edges
    double edgeGradient = 0.0; ///< of an edge that counts half, modality units per mm; with `edge`
    int smoothness = 50;
    /// The segment first receives a ball around this place.
    std::optional<glm::dvec3> bubbleLps{};
    double bubbleMm = 0.0; ///< its radius
    int generations = 10; ///< it stops earlier where nothing changes any more
    bool overwriteUnlocked = false;
    std::optional<EditableRange> editable{}; ///< which voxels may change at all; none: any
    /// Whether it grows round where nothing holds it (ContourRule::round); none: to an octahedron,
    /// as rows of before have it.
    std::optional<bool> round{};
    bool operator==(const EvolveContour&) const = default;
};

/// Each leads at most a voxel further, and so the box in memory grows with them.
constexpr int mostContourGenerations = 2000;

[[nodiscard]] Result<void> check(const EvolveContour& edit, const Document& document);
Result<bool> apply(const EvolveContour& edit, Document& document);
[[nodiscard]] EditEffects effects(const EvolveContour& edit);
[[nodiscard]] RowTitle rowTitle(const EvolveContour& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const EvolveContour& edit, const DependencyFacts& row);

/// The edit in whole numbers. Errors: those of check().
[[nodiscard]] Result<ContourRule> contourRule(const EvolveContour& edit, const Document& document);
/// Where it evolves, without codes; an empty box: there is nothing that could. The bubble gives the
/// segment those voxels that may change and whose step from the one nearest to its centre is in a
/// MillimetreBall of its radius.
/// @param labels of the whole volume in the segment's plane, x fastest
/// Errors: those of check(), OutOfMemory.
[[nodiscard]] Result<ContourGround> contourGround(
    const EvolveContour& edit, const Document& document, std::span<const std::uint8_t> labels);
/// What has become of it, for an engine; no bricks: nothing has changed. Errors: UnknownSegment,
/// SegmentLocked.
[[nodiscard]] Result<RelabelListed> relabelListed(
    const EvolveContour& edit, const Document& document, const ContourEvolution& evolution);

} // namespace core
