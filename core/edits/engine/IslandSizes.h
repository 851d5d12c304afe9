// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace core {

struct VolumeGeometry;

// Converts sizes in mm³ to numbers of voxels. A millionth of a voxel is tolerated, so that an
// island of exactly the given size is not lost by rounding.

/// The smallest number of voxels that is at least this large.
[[nodiscard]] std::int64_t fewestVoxels(double mm3, const VolumeGeometry& geometry);
/// The greatest number of voxels that is at most this large.
[[nodiscard]] std::int64_t mostVoxels(double mm3, const VolumeGeometry& geometry);

} // namespace core
