// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/OrthographicView.h"
#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/parts/ClipHalfSpaces.h"
#include "core/edits/kinds/parts/PenSample.h"
#include "core/edits/kinds/parts/ProtectedSegments.h"
#include "core/edits/kinds/sculpt/ToolMask.h"
#include "core/sculpt/DrillCut.h"

#include <optional>
#include <vector>

namespace test {

// Cuts, for tests that are about something else. As with PlainEdits.h they need not see the headers
// of such edits.

/// What a test says of a cut; what it leaves out stays as it was, and what a kind has not is not
/// looked at.
struct CutWords {
    std::optional<int> layer{};
    std::optional<core::OrthographicView> view{};
    std::optional<core::ToolMask> mask{};
    std::optional<double> radiusMm{}; ///< of that mask
    std::optional<core::DrillMode> mode{};
    std::optional<double> depthMm{};
    std::optional<double> surfaceThreshold{};
    std::optional<bool> throughGaps{};
    std::optional<bool> restore{};
    std::optional<std::vector<core::PenSample>> samples{};
    std::optional<core::ClipHalfSpaces> hidden{};
    std::optional<core::ProtectedSegments> protectedSegments{};
};

/// A new stroke of the drill.
[[nodiscard]] core::Edit drillWith(const CutWords& words);
/// @p drill, but so.
[[nodiscard]] core::Edit drillWith(const CutWords& words, const core::Edit& drill);
/// A new stroke of the laser.
[[nodiscard]] core::Edit laserWith(const CutWords& words);
/// A new peel.
[[nodiscard]] core::Edit peelWith(const CutWords& words, const std::vector<glm::dvec2>& polygonMm);
/// Scissors; they have no gaps to go through.
[[nodiscard]] core::Edit scissorsWith(
    const CutWords& words, const std::vector<glm::dvec2>& polygonMm);
/// @p stroke, of drill or laser, as it is begun: without its samples.
[[nodiscard]] core::Edit begunStroke(const core::Edit& stroke);

/// What a stroke of drill or laser says.
struct StrokeFacts {
    core::OrthographicView view;
    core::ToolMask mask;
    double depthMm = 0.0;
    double surfaceThreshold = 0.0;
    bool restore = false;
    bool byTime = true;
    std::vector<core::PenSample> samples;
    core::ClipHalfSpaces hidden;
    core::ProtectedSegments protectedSegments;
};
/// Throws std::bad_variant_access where it is another edit.
[[nodiscard]] StrokeFacts factsOfStroke(const core::Edit& stroke);

} // namespace test
