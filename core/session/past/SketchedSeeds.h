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

/// What became of the voxels that a SeedStroke sketched. Not all of them become seeds: members of a
/// growth are kept (SeedPlacement).
struct SketchedSeeds {
    int segment = 0;
    std::int64_t voxels = 0; ///< number sketched; each one that was not taken is counted once below
    std::int64_t taken = 0; ///< number that became seeds
    std::map<int, std::int64_t>
        members; ///< stay what a segment has grown, or was painted, by label
    std::map<int, std::int64_t> waiting; ///< already pending seeds, and kept as such, by label
    std::int64_t barriers = 0; ///< kept as barriers
    /// of those taken: were seeds of another segment, by its label
    std::map<int, std::int64_t> replaced;

    /// Whether all became seeds, and none was a seed of another segment.
    [[nodiscard]] bool isPlain() const
    {
        return members.empty() && waiting.empty() && barriers <= 0 && replaced.empty();
    }
};

/// @param before the seed words of the stroke's voxels before the stroke, in their order
[[nodiscard]] SketchedSeeds sketchedSeeds(
    const SeedPlacement& stroke, const std::vector<std::uint32_t>& before);

/// A text such as "5 voxels", "3 of 5 voxels (2 belong to 'Skull')" or "2 voxels (1 was a seed of
/// 'Skull')".
[[nodiscard]] RowTitle sketchedTitle(const SketchedSeeds& seeds, const Document& document);
/// The part in brackets; empty: all became seeds, and none was a seed of another segment.
[[nodiscard]] RowTitle whyNotTaken(const SketchedSeeds& seeds, const Document& document);

} // namespace core
