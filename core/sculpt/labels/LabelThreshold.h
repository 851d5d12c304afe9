// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/sculpt/labels/LayerWrites.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// Give a label to the voxels with certain values, or remove it from them. Both engines follow
/// these rules to the bit; each voxel is decided independently of the others.
///
/// 1. A voxel is in range if it lies in the box, if there is one, and, with `onlyVisible`, if its
///    coverage is < 128 in all layers that are not muted. Any other voxel does not change.
/// 2. A voxel in range is chosen if lowCode ≤ code ≤ highCode.
/// 3. Add: chosen voxels follow the rule of LabelTarget. Subtract: chosen voxels follow the rule
///    for voxels that RelabelListed takes. Replace: chosen voxels as for Add, and all others in
///    range as for Subtract.
///
/// After it has begun, an engine may carry it out brick by brick; it is complete at the latest when
/// it is committed.
struct LabelThreshold {
    enum class How : std::uint8_t { Replace, Add, Subtract };
    LabelTarget target{};
    How how = How::Replace;
    int lowCode = 0; ///< greater than highCode: no voxel is chosen
    int highCode = 65535;
    bool onlyVisible = false;
    std::optional<VoxelBox> box{}; ///< none: the whole volume
    std::optional<EditableVoxels> editable{}; ///< none: any
};

[[nodiscard]] Result<void> checkSound(const LabelThreshold& edit, const BrickGrid& grid);

/// Numbers of the bricks that have a voxel in a box, ascending.
[[nodiscard]] std::vector<std::uint32_t> bricksMeeting(const VoxelBox& box, const BrickGrid& grid);

} // namespace core
