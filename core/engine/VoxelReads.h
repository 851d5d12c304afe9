// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/sculpt/PickRay.h"

#include <bitset>
#include <cstdint>
#include <vector>

namespace core {

// Commands that read single voxels or a box of them, or find what a ray meets. They change nothing.

/// Reads the seed words of voxels, in their order (`seedWords`).
struct ReadSeedWords {
    std::vector<glm::ivec3> voxels;
    std::uint8_t plane = 0;
};
/// Reads the codes of a box: 16 bits each, x fastest (`codes`). The engine waits until the box has
/// been copied, so a large box delays frames.
struct ReadCodes {
    VoxelBox box;
};
/// Reads codes, labels of all planes and pending seeds at voxels, for readouts; and tolerances if
/// there is a tolerance field (TraceTolerance).
struct ProbeVoxels {
    std::vector<glm::ivec3> voxels;
    std::uint8_t plane = 0; ///< the plane that `label` and `seedOf` are read from
};

/// Casts rays to find which voxel is visible along each. All computed in integers, so that a pick
/// is the same on every machine. A hit is the voxel nearest to the sample found: (P + 2¹⁵) >> 16.
/// "Material", "inside", "carved" and Z are those of CutFrame.h, rule 3, with the radiation at the
/// time of this command, which includes what an open stroke has cut so far. `seenBy` decides:
/// - Opacity: front to back, each sample that is inside and not carved adds o = opacityOfCode[Z >>
///   24] (0 … 65535, per sample): T = T·(65535 − o) / 65535, beginning with T = 65535. The first
///   sample with T ≤ 32767 is hit.
/// - BrightestVoxel: the sample with the greatest Z among those that are inside and not carved.
/// - Segment: the first sample that is inside and whose nearest voxel has one of `segments` in any
///   plane.
struct PickVoxels {
    std::vector<PickRay> rays{};
    SeenBy seenBy = SeenBy::Surface;
    int thresholdCode = 0;
    std::vector<std::uint32_t> opacityOfCode{}; ///< 256 entries, only for Opacity
    std::bitset<256> segments{}; ///< labels, only for Segment
};

} // namespace core
