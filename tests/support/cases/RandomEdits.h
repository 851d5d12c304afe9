// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "core/edits/kinds/parts/ClipHalfSpaces.h"
#include "core/sculpt/DrillCut.h"
#include "tests/support/scenes/TestVolumes.h"

#include <vector>

namespace test {

// Random edits that are valid for a given document.

/// Returns a document with one volume whose values are its codes. Its affine is scaled and rotated
/// at random and, if @p sheared, sheared.
[[nodiscard]] core::Document randomDocument(const glm::ivec3& size, Random& random, bool sheared);

/// Returns a drill stroke from a random direction with a random path.
[[nodiscard]] core::Edit randomDrill(const core::Document& document, Random& random);

/// The same for the laser.
[[nodiscard]] core::LaserStroke randomLaser(const core::Document& document, Random& random);

/// Returns the half space beyond the plane through a point, in the direction of its normal.
[[nodiscard]] core::ClipHalfSpace beyond(const glm::dvec3& placeLps, const glm::dvec3& normalLps);
/// Returns half spaces of random planes through the volume; in most cases none.
[[nodiscard]] core::ClipHalfSpaces randomHidden(const core::Document& document, Random& random);

/// Returns a brush path on or off the volume; some paths rest in place, some go far beyond it.
[[nodiscard]] core::BrushPath randomPath(const core::Document& document, Random& random);
[[nodiscard]] core::PaintStroke randomPaint(const core::Document& document, Random& random);
[[nodiscard]] core::BrushStroke randomBrush(const core::Document& document, Random& random);

/// Returns a closed curve around a point near the centre of a view, in mm; it may cross itself.
[[nodiscard]] std::vector<glm::dvec2> randomOutline(double reachMm, Random& random);
[[nodiscard]] core::PeelCut randomPeel(const core::Document& document, Random& random);
[[nodiscard]] core::ScissorsCut randomScissors(const core::Document& document, Random& random);

/// Returns an edit of one of the segments, none of which may be locked. Every form of the edit
/// occurs.
[[nodiscard]] core::SegmentScissors randomSegmentScissors(
    const core::Document& document, Random& random);

/// Returns the engine's form of a stroke, which must be valid; throws if it is not.
[[nodiscard]] core::DrillCut drillCutOf(const core::Edit& drill, const core::Document& document);
[[nodiscard]] std::vector<core::DrillSample> drillSamplesOf(
    const core::Edit& drill, const core::DrillCut& cut);

} // namespace test
