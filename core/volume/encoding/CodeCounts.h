// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <cstdint>
#include <vector>

namespace core {

/// How many voxels have each code: VoxelEncoding::codeCount numbers.
using CodeCounts = std::vector<std::uint64_t>;

/// On all cores.
[[nodiscard]] CodeCounts countCodes(const LoadedVolume& loaded);

/// What follows from counts for a volume whose encoding, minimum and maximum are known: its
/// histogram and, unless @p hasWindow, its window.
void describeCounts(Volume& volume, const CodeCounts& counts, bool hasWindow);

/// Voxels that do not count, of which there is one code.
struct Uncounted {
    int code = 0;
    std::uint64_t voxels = 0;
};

/// The same where codes are exact: minimum and maximum follow, too. Padding does not count in
/// histogram and window.
void describeExactCounts(
    LoadedVolume& loaded, CodeCounts counts, const Uncounted& uncounted, bool hasWindow);

} // namespace core
