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
/// voxel is decided independently of the others.
///
/// 1. A voxel is editable if all of these hold:
///    - lowCode ≤ code ≤ highCode;
///    - it lies in the box, if there is one;
///    - with `inside`, one of the planes listed there holds one of its labels at the voxel;
///    - no plane of `outside` holds one of its labels there.
/// 2. At any other voxel the edit changes neither the label nor the seed word.
/// 3. What planes hold is read when the edit comes to a voxel. An edit that comes to a voxel again,
///    as a brush does, reads again. The result is the same as if it had read once, because it would
///    only repeat what it did there the first time.
///
/// A voxel that is not editable counts in every other respect as without this limit: a brush that
/// follows edges passes through it.
struct EditableVoxels {
    struct PlaneLabels {
        std::uint8_t plane = 0;
        std::bitset<256> labels{};
    };
    int lowCode = 0; ///< greater than highCode: no voxel is editable
    int highCode = 65535;
    std::optional<VoxelBox> box{}; ///< none: the whole volume
    /// Each plane once; an empty list: no voxel is editable.
    std::optional<std::vector<PlaneLabels>> inside{};
    std::vector<PlaneLabels> outside{}; ///< each plane once
};

/// Checks that no plane is listed twice and that 0, which is no segment's label, does not occur.
/// Errors: InvalidField.
[[nodiscard]] Result<void> checkSound(const std::optional<EditableVoxels>& editable);

} // namespace core
