// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/growth/GrowthCommands.h"
#include "core/growth/SeedGroups.h"
#include "core/growth/Tolerance.h"

#include <cstdint>
#include <vector>

namespace core {

// Commands that examine a growth, or compute what it would become. They change no voxel.

/// Computes the statistics around the seeds of a plane's labels: the sums by which a GrowBurst with
/// this interval and these groups would narrow it (GrowLimits) if it opened now.
struct ProbeSeeds {
    std::uint8_t plane = 0;
    int lowCode = 0;
    int highCode = 65535;
    std::vector<SeedGroup> seedGroups{};
};

/// Counts the members of each generation, from the present seed words of a plane, including those
/// of an open edit. The result is `EngineResult::generationSizes`.
struct CountGenerations {
    std::uint8_t plane = 0;
};

/// Computes at which tolerance each voxel would join a segment (growth/Tolerance.h). It changes no
/// voxel. When it is done, the result contains the curve. From then on the tolerance field exists:
/// ProbeVoxels reads it, and it can be shown, until BeginEdit, SwapBricks, XorBricks, MuteLayers,
/// DropTolerance or another TraceTolerance is carried out, or a volume is opened.
struct TraceTolerance {
    ToleranceRule rule;
    /// False: compute only so much that time remains for pictures and other commands. A result
    /// without an error and without a curve then means that the computation is not finished and
    /// that the next request continues it.
    bool toTheEnd = true;
};
/// Discards the tolerance field. The result is empty.
struct DropTolerance { };

/// Computes what a CutGrowth would remove if it began now. It changes no voxel. The result contains
/// the preview (`cutPreview`). From then on it can be shown, until BeginEdit, SwapBricks, XorBricks
/// or DropCutPreview is carried out, another PreviewCut is answered, or a volume is opened.
struct PreviewCut {
    CutGrowth cut;
    /// False: do not wait for it. A result without an error and without `cutPreview` then means
    /// that it is being computed beside other commands and pictures: ask again.
    bool toTheEnd = true;
};
/// Discards what PreviewCut computed, and what a CompareGrowth with `keep` has left. The result is
/// empty.
struct DropCutPreview { };

/// Compares the plane of the open growth with its state when the growth began: which voxels another
/// interval suspends, and which it reaches (seed A §5.3). It changes no voxel. The result contains
/// the counts (`growthComparison`). From then on the comparison can be shown, until EndEdit is
/// carried out, another CompareGrowth is answered, or a volume is opened.
struct CompareGrowth {
    /// True: when the growth is committed, its suspended and reached voxels stay, to be shown until
    /// SwapBricks, XorBricks, DropCutPreview or a BeginEdit that is no growth is carried out, or a
    /// volume is opened. If the next growth is compared, too, voxels that it has not let in are
    /// still shown as suspended, and those that it has let in as reinstated. If that growth is
    /// rolled back, everything is shown as before it. The counts are those of the open growth
    /// alone.
    bool keep = false;
};

} // namespace core
