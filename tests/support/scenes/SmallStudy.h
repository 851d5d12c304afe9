// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edits.h"
#include "core/volume/Volume.h"

#include <vector>

namespace test {

/// A study that even the oracle is quick with: 40 × 36 × 34 voxels of 1 × 1 × 1.5 mm, a hollow ball
/// of "bone" (1000 HU) with "brain" (40 HU) inside, air (−1000 HU) around; value = code − 1024.
[[nodiscard]] core::LoadedVolume smallStudy();

/// Edits that suit it.
[[nodiscard]] core::AddSegment addSegment(const char* name);
[[nodiscard]] core::SeedStroke seedInBrain(int segment);
[[nodiscard]] core::SeedStroke seedInBone(int segment);
[[nodiscard]] core::GrowSteps growBrain(std::optional<int> steps = {});
[[nodiscard]] core::GrowSteps growBone(std::optional<int> steps = {});
/// From the front into the bone, at @p xMm right of the middle.
[[nodiscard]] core::DrillStroke drillAt(double xMm);

/// A history of strokes, growths and changes, on segments 1 and 2.
[[nodiscard]] std::vector<core::Edit> manyEdits();

} // namespace test
