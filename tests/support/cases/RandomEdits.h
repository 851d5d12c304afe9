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

// Random edits for a document, which must be valid.

/// A document with one volume whose codes are its values. Its affine is randomly scaled and rotated
/// and, if requested, sheared.
[[nodiscard]] core::Document randomDocument(const glm::ivec3& size, Random& random, bool sheared);

/// A drill stroke at a document's volume from a random direction, with a random path.
[[nodiscard]] core::Edit randomDrill(const core::Document& document, Random& random);

/// The same for the laser.
[[nodiscard]] core::LaserStroke randomLaser(const core::Document& document, Random& random);

/// The half space beyond a plane through a point, in the direction of its normal.
[[nodiscard]] core::ClipHalfSpace beyond(const glm::dvec3& placeLps, const glm::dvec3& normalLps);
/// Half spaces of random planes through a document's volume, or, in most cases, none.
[[nodiscard]] core::ClipHalfSpaces randomHidden(const core::Document& document, Random& random);

/// Brush paths, on and off a document's volume; some rest, some go far beyond it.
[[nodiscard]] core::BrushPath randomPath(const core::Document& document, Random& random);
[[nodiscard]] core::PaintStroke randomPaint(const core::Document& document, Random& random);
[[nodiscard]] core::BrushStroke randomBrush(const core::Document& document, Random& random);

/// A closed curve around a point near the middle of a view; it may cross itself.
[[nodiscard]] std::vector<glm::dvec2> randomOutline(double reachMm, Random& random);
[[nodiscard]] core::PeelCut randomPeel(const core::Document& document, Random& random);
[[nodiscard]] core::ScissorsCut randomScissors(const core::Document& document, Random& random);

/// Of one of the segments, which are not locked; every form of it.
[[nodiscard]] core::SegmentScissors randomSegmentScissors(
    const core::Document& document, Random& random);

/// The engine's form of a stroke, which must be valid.
[[nodiscard]] core::DrillCut drillCutOf(const core::Edit& drill, const core::Document& document);
[[nodiscard]] std::vector<core::DrillSample> drillSamplesOf(
    const core::Edit& drill, const core::DrillCut& cut);

} // namespace test
