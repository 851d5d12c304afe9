// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "core/edits/kinds/parts/ClipHalfSpaces.h"
#include "tests/support/cases/EngineConformance.h"

#include <vector>

namespace test {

/// Whether BURIN_LONG=1 is set: then tests use the counts that the issues name instead of moderate
/// ones.
[[nodiscard]] bool longRun();

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

/// The engine's form of a stroke, which must be valid.
[[nodiscard]] core::DrillCut drillCutOf(const core::Edit& drill, const core::Document& document);
[[nodiscard]] std::vector<core::DrillSample> drillSamplesOf(
    const core::Edit& drill, const core::DrillCut& cut);

/// Steps for a growth of so many steps in one go.
void appendBurst(std::vector<EngineStep>& steps, const core::GrowBurst& burst, int count,
    core::Ending ending = core::Ending::Commit);

/// Steps for seeds at so many random places more.
void appendSeeds(std::vector<EngineStep>& steps, core::SeedPlacement seeds, int count,
    const glm::ivec3& size, Random& random);

// The cases of the conformance suite: first named and adversarial ones, then random ones.
[[nodiscard]] std::vector<EngineCase> growthCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> growLimitCases(int randomCount);
/// Statistics of each stroke.
[[nodiscard]] std::vector<EngineCase> seedGroupCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> wideGrowthCases(int randomCount); ///< of a single label
[[nodiscard]] std::vector<EngineCase> intervalCases(int randomCount); ///< with barriers in between
/// Voxels taken from other labels and given back.
[[nodiscard]] std::vector<EngineCase> overwrittenCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> passageCases(int randomCount); ///< passage widths
[[nodiscard]] std::vector<EngineCase> drillCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> laserCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> peelCases(int randomCount); ///< some with scissors in between
[[nodiscard]] std::vector<EngineCase> scissorsCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> pickCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> eraseCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> capsuleCases(int randomCount); ///< paint and carve brush
/// Carve and restore alternately.
[[nodiscard]] std::vector<EngineCase> carveCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> layerCases(int randomCount); ///< muted layers
/// Layers to segments and back.
[[nodiscard]] std::vector<EngineCase> layerWriteCases(int randomCount);
/// Labels given and taken by voxel.
[[nodiscard]] std::vector<EngineCase> relabelCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> mapCases(int randomCount); ///< whole labels for others
[[nodiscard]] std::vector<EngineCase> barrierCases(int randomCount); ///< voxels closed to growth
/// Protected labels, for every tool that carves.
[[nodiscard]] std::vector<EngineCase> protectedCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> spreadCases(int randomCount); ///< growing from seeds
[[nodiscard]] std::vector<EngineCase> toleranceCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> refusalCases();

} // namespace test
