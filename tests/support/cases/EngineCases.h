// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/parts/BrushPath.h"
#include "core/edits/kinds/parts/HiddenSides.h"
#include "tests/support/cases/EngineConformance.h"

#include <vector>

namespace test {

/// True with BURIN_LONG=1: the counts that the issues name instead of moderate ones.
[[nodiscard]] bool longRun();

/// A document with one volume whose codes are its values; the affine is scaled, turned and, if
/// asked for, sheared at random.
[[nodiscard]] core::Document randomDocument(const glm::ivec3& size, Random& random, bool sheared);

/// A drill stroke at a document's volume from a random direction, with a random path.
[[nodiscard]] core::Edit randomDrill(const core::Document& document, Random& random);

/// The same of the laser.
[[nodiscard]] core::LaserStroke randomLaser(const core::Document& document, Random& random);

/// Sides of planes through a document's volume, or, more often than not, nothing.
/// What lies beyond a plane through a place, the way its normal points.
[[nodiscard]] core::HiddenSide beyond(const glm::dvec3& placeLps, const glm::dvec3& normalLps);
[[nodiscard]] core::HiddenSides randomHidden(const core::Document& document, Random& random);

/// Brushes, on and off a document's volume; some rest, some leave it far behind.
[[nodiscard]] core::BrushPath randomPath(const core::Document& document, Random& random);
[[nodiscard]] core::PaintStroke randomPaint(const core::Document& document, Random& random);
[[nodiscard]] core::BrushStroke randomBrush(const core::Document& document, Random& random);

/// A closed curve around somewhere in the middle of a view; may cross itself.
[[nodiscard]] std::vector<glm::dvec2> randomOutline(double reachMm, Random& random);
[[nodiscard]] core::PeelCut randomPeel(const core::Document& document, Random& random);
[[nodiscard]] core::ScissorsCut randomScissors(const core::Document& document, Random& random);

/// The engine's form of a drill stroke; it must be valid.
[[nodiscard]] core::DrillCut drillCutOf(const core::Edit& drill, const core::Document& document);
[[nodiscard]] std::vector<core::DrillSample> drillSamplesOf(
    const core::Edit& drill, const core::DrillCut& cut);

/// Steps for a growth of so many steps in one go.
void appendBurst(std::vector<EngineStep>& steps, const core::GrowBurst& burst, int count,
    core::Ending ending = core::Ending::Commit);

/// Steps for seeds at so many random places more.
void appendSeeds(std::vector<EngineStep>& steps, core::SeedPlacement seeds, int count,
    const glm::ivec3& size, Random& random);

// The cases of the conformance suite, named and adversarial ones first, then random ones.
[[nodiscard]] std::vector<EngineCase> growthCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> growLimitCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> seedGroupCases(int randomCount); ///< statistics by stroke
[[nodiscard]] std::vector<EngineCase> wideGrowthCases(int randomCount); ///< of one label
[[nodiscard]] std::vector<EngineCase> intervalCases(int randomCount); ///< barriers between
[[nodiscard]] std::vector<EngineCase> beneathCases(int randomCount); ///< taken and given back
[[nodiscard]] std::vector<EngineCase> passageCases(int randomCount); ///< of a given width
[[nodiscard]] std::vector<EngineCase> drillCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> laserCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> peelCases(int randomCount); ///< some with scissors between
[[nodiscard]] std::vector<EngineCase> scissorsCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> pickCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> eraseCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> capsuleCases(int randomCount); ///< paint and carve brush
[[nodiscard]] std::vector<EngineCase> carveCases(int randomCount); ///< by turns carve and restore
[[nodiscard]] std::vector<EngineCase> layerCases(int randomCount); ///< muted ones
[[nodiscard]] std::vector<EngineCase> layerWriteCases(int randomCount); ///< to and from segments
[[nodiscard]] std::vector<EngineCase> relabelCases(int randomCount); ///< given and taken by voxel
[[nodiscard]] std::vector<EngineCase> mapCases(int randomCount); ///< whole labels for others
[[nodiscard]] std::vector<EngineCase> shutCases(int randomCount); ///< to growth, by voxel
[[nodiscard]] std::vector<EngineCase> sparedCases(int randomCount); ///< of every tool that carves
[[nodiscard]] std::vector<EngineCase> spreadCases(int randomCount); ///< growing from seeds
[[nodiscard]] std::vector<EngineCase> toleranceCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> refusalCases();

} // namespace test
