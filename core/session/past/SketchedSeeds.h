// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/document/Document.h"
#include "core/growth/GrowthCommands.h"
#include "core/titles/RowTitle.h"

#include <cstdint>
#include <map>
#include <vector>

namespace core {

/// What became of the voxels that a SeedStroke sketched. Not all need become seeds: what a growth
/// holds stays the growth's (SeedPlacement).
struct SketchedSeeds {
    int segment = 0;
    std::int64_t voxels = 0; ///< sketched; each but those `taken` is counted once below
    std::int64_t taken = 0; ///< became seeds
    std::map<int, std::int64_t>
        members; ///< stay what a segment has grown, or was painted, by label
    std::map<int, std::int64_t> waiting; ///< stay seeds that wait already, by label
    std::int64_t barriers = 0; ///< stay shut
    std::map<int, std::int64_t> replaced; ///< of those taken: were seeds of another, by label

    /// All became seeds, of nobody else.
    [[nodiscard]] bool isPlain() const
    {
        return members.empty() && waiting.empty() && barriers <= 0 && replaced.empty();
    }
};

/// @param before the seed words of the stroke's voxels before it, in their order
[[nodiscard]] SketchedSeeds sketchedSeeds(
    const SeedPlacement& stroke, const std::vector<std::uint32_t>& before);

/// "5 voxels", "3 of 5 voxels (2 belong to 'Skull')", "2 voxels (1 was a seed of 'Skull')".
[[nodiscard]] RowTitle sketchedTitle(const SketchedSeeds& seeds, const Document& document);
/// What stands in the brackets of that; of plain ones it says nothing.
[[nodiscard]] RowTitle whyNotTaken(const SketchedSeeds& seeds, const Document& document);

} // namespace core
