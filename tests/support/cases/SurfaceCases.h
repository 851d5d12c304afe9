// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/VoxelRuns.h"
#include "core/edits/kinds/Edit.h"
#include "tests/support/cases/StrokeCases.h"

namespace test {

/// Edits of the surface that is being refined, on a ball of voxels.
[[nodiscard]] std::vector<StrokeCase> surfaceCases();

/// A ball of voxels.
/// @param radius in voxels around the middle of the volume
[[nodiscard]] core::VoxelRuns ballRuns(const glm::ivec3& size, double radius);
/// The same as an imported mask: the segment "Ball", label 1 in an empty session.
[[nodiscard]] core::Edit ballMask(const glm::ivec3& size, double radius);

} // namespace test
