// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/brick/BrickGrid.h"

#include <bitset>
#include <cstdint>
#include <optional>
#include <vector>

namespace core {

/// Which voxels an edit of labels may change. Both engines follow these rules to the bit; each
/// voxel decides for itself.
///
/// 1. A voxel is editable if lowCode ≤ code ≤ highCode, if it lies in the box, where there is one,
///    if with `inside` one of the planes listed there holds one of its labels at the voxel, and if
///    no plane of `outside` holds one of its labels there.
/// 2. At any other voxel the edit changes neither the label nor the seed word.
/// 3. What planes hold is asked when the edit comes to a voxel. An edit that comes to it again, as
///    a brush does, asks again; that comes to the same as asking once, since what it did there the
///    first time, it would only do once more.
///
/// What is not editable counts for everything else as it does without: a brush that follows edges
/// passes through.
struct EditableVoxels {
    struct PlaneLabels {
        std::uint8_t plane = 0;
        std::bitset<256> labels{};
    };
    int lowCode = 0; ///< above highCode: none is editable
    int highCode = 65535;
    std::optional<VoxelBox> box{}; ///< none: the whole volume
    std::optional<std::vector<PlaneLabels>> inside{}; ///< each plane once; an empty list: none is
    std::vector<PlaneLabels> outside{}; ///< each plane once
};

/// Errors: InvalidField (a plane listed twice, or the label 0, which is no segment's).
[[nodiscard]] Result<void> checkSound(const std::optional<EditableVoxels>& editable);

} // namespace core
