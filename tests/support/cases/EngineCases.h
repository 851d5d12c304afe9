// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/cases/EngineConformance.h"
#include "tests/support/scenes/TestVolumes.h"

#include <cstdint>
#include <vector>

namespace test {

/// Appends the steps of a growth of @p count generations in one go.
void appendBurst(std::vector<EngineStep>& steps, const core::GrowBurst& burst, int count,
    core::Ending ending = core::Ending::Commit);

/// Appends a placement of the given seeds and of seeds at @p count random voxels.
void appendSeeds(std::vector<EngineStep>& steps, core::SeedPlacement seeds, int count,
    const glm::ivec3& size, Random& random);

/// Voxels that a growth may take at all, for one burst of three none: an interval of codes, labels
/// that it must not enter, or both.
[[nodiscard]] std::optional<core::GrowthRange> randomGrowthRange(int greatestCode, Random& random);

/// Appends something between edits of labels: seeds (0), a growth (1), undo or redo (2).
/// @return whether @p what is one of these
bool appendBetween(std::vector<EngineStep>& steps, int what, std::uint8_t plane,
    const glm::ivec3& size, Random& random);

// The cases of the conformance suite: first named and adversarial ones, then random ones.
[[nodiscard]] std::vector<EngineCase> growthCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> growLimitCases(int randomCount);
/// Growths whose criteria follow the statistics of each stroke.
[[nodiscard]] std::vector<EngineCase> seedGroupCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> wideGrowthCases(int randomCount); ///< of a single label
[[nodiscard]] std::vector<EngineCase> intervalCases(int randomCount); ///< with barriers in between
/// Growths taken back from a sketch, generation by generation.
[[nodiscard]] std::vector<EngineCase> backwardCases(int randomCount);
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
/// Labels given and taken inside an outline in a slice.
[[nodiscard]] std::vector<EngineCase> outlineCases(int randomCount);
/// Labels given and taken by values.
[[nodiscard]] std::vector<EngineCase> thresholdCases(int randomCount);
/// Labels given and taken under a curve on a view.
[[nodiscard]] std::vector<EngineCase> segmentScissorsCases(int randomCount);
/// Edits of labels within an editable range.
[[nodiscard]] std::vector<EngineCase> editableCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> mapCases(int randomCount); ///< whole labels for others
[[nodiscard]] std::vector<EngineCase> barrierCases(int randomCount); ///< voxels closed to growth
/// Protected labels, for every tool that carves.
[[nodiscard]] std::vector<EngineCase> protectedCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> spreadCases(int randomCount); ///< growing from seeds
[[nodiscard]] std::vector<EngineCase> toleranceCases(int randomCount);
[[nodiscard]] std::vector<EngineCase> refusalCases();

} // namespace test
