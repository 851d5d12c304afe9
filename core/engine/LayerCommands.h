// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"
#include "core/sculpt/CapsuleSweep.h"
#include "core/sculpt/ProtectedLabels.h"

#include <bitset>
#include <cstdint>
#include <vector>

namespace core {

// Commands for sculpt layers, as an engine receives them. Cuts with other tools are in
// sculpt/DrillCut.h and the like, commands that write whole layers in sculpt/labels/LayerWrites.h.

/// Carve along a path: coverage = max(coverage, cut) with the cut of CapsuleSweep.h, rule 5. To
/// restore, coverage is refilled as described at the end of CutFrame.h, rule 6. Hidden voxels are
/// not changed, and voxels with protected labels (`protectedLabels`) are not carved.
struct CapsuleCut {
    std::uint8_t layer = 0;
    bool restore = false;
    CapsuleFrame frame;
    std::vector<IntegerHalfSpace> hidden{};
    ProtectedLabels protectedLabels{};
};

[[nodiscard]] Result<void> checkSound(const CapsuleCut& edit, const BrickGrid& grid);

/// Excludes these sculpt layers from the composition of layers from now on: radiation, and with it
/// strokes, picks and pictures, uses the greatest coverage of all others. Their own coverage is
/// kept and can be cut, read and swapped. Opening a volume unmutes all layers. The result is empty.
struct MuteLayers {
    std::bitset<256> muted{};
};

} // namespace core
