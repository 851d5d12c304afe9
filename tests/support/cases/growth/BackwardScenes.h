// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/scenes/TestVolumes.h"

#include <QByteArray>

#include <vector>

namespace test {

/// A volume with a growth that has filled all voxels of tissueCode, and a sketch from which it is
/// to be taken back.
struct BackwardScene {
    QByteArray name;
    Codes codes;
    std::vector<glm::ivec3> seeds; ///< of label 1
    std::vector<glm::ivec3> others{}; ///< of label 2
    std::vector<glm::ivec3> sketch; ///< over label 1
};

/// Returns scenes in which "descends from" and "is nearer to" are not obvious: a ring whose fronts
/// meet, a fork, a line between two seeds, a hall behind a hole, a block without any neck, and a
/// block shared by two labels.
[[nodiscard]] std::vector<BackwardScene> backwardScenes();

/// Single scenes whose voxels are known to tests; all are one voxel thick.
[[nodiscard]] BackwardScene lineScene(); ///< x = 0 … 15 at y = z = 0, seeds at 0
[[nodiscard]] BackwardScene ringScene(); ///< the rim of 9 × 9 voxels in z = 0, seed at (4, 0)
/// A stem x = 0 … 7 at y = 7, at whose end arms go to y = 0 and y = 14; seed at x = 0.
[[nodiscard]] BackwardScene forkScene();
[[nodiscard]] BackwardScene twoSeedsScene(); ///< the line with seeds at both ends

} // namespace test
