// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace core {

struct VolumeGeometry;

// How many voxels an island or a hole has that is just as large as a size in mm³. A hair's breadth
// of rounding does not decide about one of exactly that size.

/// The fewest voxels of what is at least so large.
[[nodiscard]] std::int64_t fewestVoxels(double mm3, const VolumeGeometry& geometry);
/// The most voxels of what is at most so large.
[[nodiscard]] std::int64_t mostVoxels(double mm3, const VolumeGeometry& geometry);

} // namespace core
