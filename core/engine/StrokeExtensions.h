// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sculpt/CapsuleSweep.h"
#include "core/sculpt/DrillCut.h"

#include <cstdint>
#include <vector>

namespace core {

// The extensions that an open stroke takes while the pen is down.

/// Further samples of the path of a DrillCut or CapsuleCut.
struct DrillPath {
    std::vector<DrillSample> samples;
};

/// Further pieces of the path of a PaintLabel, PaintBarrier or CapsuleCut.
struct CapsulePath {
    std::vector<Capsule> capsules;
    /// For a PaintLabel that follows edges: indices of the voxels under the pen along these pieces,
    /// in any order. Those outside the volume are ignored.
    std::vector<glm::ivec3> under{};
};

/// Sets the depth of an open ShellPeel, which begins with 0. It may increase or decrease.
struct PeelDepth {
    std::int32_t depth = 0; ///< mm16, ≥ 0
};

} // namespace core
