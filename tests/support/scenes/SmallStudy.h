// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/OrthographicView.h"
#include "core/edits/kinds/Edit.h"
#include "core/volume/Volume.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace test {

/// A study that is small enough for the oracle: 40 × 36 × 34 voxels of 1 × 1 × 1.5 mm, a hollow
/// ball of "bone" (1000 HU) with "brain" (40 HU) inside, in air (−1000 HU); value = code − 1024.
[[nodiscard]] core::LoadedVolume smallStudy();
/// Its grid, and the place of a voxel in it, x fastest.
[[nodiscard]] const core::VolumeGeometry& smallGrid();
[[nodiscard]] std::size_t smallIndexOf(const glm::ivec3& voxel);

/// Two points in the brain, and one in the bone; LPS.
[[nodiscard]] std::vector<glm::dvec3> pointsInBrain();
[[nodiscard]] std::vector<glm::dvec3> pointsInBone();
/// A view onto the middle of the brain, from the front.
[[nodiscard]] core::OrthographicView frontView();

/// Edits for this study.
[[nodiscard]] core::Edit addSegment(const char* name);
[[nodiscard]] core::Edit seedInBrain(int segment);
[[nodiscard]] core::Edit seedInBone(int segment);
[[nodiscard]] core::Edit growBrain(std::optional<int> steps = {});
[[nodiscard]] core::Edit growBone(std::optional<int> steps = {});
/// A drill from the front into the bone, @p xMm right of the middle.
[[nodiscard]] core::Edit drillAt(double xMm);

/// A history of strokes, growths and changes, on segments 1 and 2.
[[nodiscard]] std::vector<core::Edit> manyEdits();

} // namespace test
