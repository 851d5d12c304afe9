// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <cstdint>
#include <vector>

namespace core {

/// The number of voxels with each code: VoxelEncoding::codeCount numbers.
using CodeCounts = std::vector<std::uint64_t>;

/// Counts them, on all cores.
[[nodiscard]] CodeCounts countCodes(const LoadedVolume& loaded);

/// Derives the histogram and, unless @p hasWindow, the window of a volume whose encoding, minimum
/// and maximum are known.
void describeCounts(Volume& volume, const CodeCounts& counts, bool hasWindow);

/// Voxels of one code that are not counted.
struct Uncounted {
    int code = 0;
    std::uint64_t voxels = 0;
};

/// The same for exact codes, from which minimum and maximum follow too. Padding does not count in
/// histogram and window.
void describeExactCounts(
    LoadedVolume& loaded, CodeCounts counts, const Uncounted& uncounted, bool hasWindow);

} // namespace core
