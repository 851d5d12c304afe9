// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

#include <QByteArray>

#include <optional>
#include <vector>

namespace core {

/// A label of the voxels that are divided into chunks.
struct ChunkOwner {
    int label = 0;
    QByteArray voxels{}; ///< packedRuns() (core/brick/VoxelRuns.h), on the volume's grid
    bool operator==(const ChunkOwner&) const = default;
};

/// Divides a segment and what lies around it into chunks (core/chunks/ChunkTree.h). Whoever carries
/// it out adds the labels that there are in the box around it, so that the edit names what it
/// reads besides the volume.
struct Chunks {
    int segment = 0; ///< label
    double marginMm = 10.0; ///< around its voxels, on all sides
    std::optional<std::vector<ChunkOwner>> owners{}; ///< by label; 0 is what is left
    bool operator==(const Chunks&) const = default;
};

[[nodiscard]] Result<void> check(const Chunks& edit, const Document& document);
Result<bool> apply(const Chunks& edit, Document& document);
[[nodiscard]] EditEffects effects(const Chunks& edit);
[[nodiscard]] RowTitle rowTitle(const Chunks& edit, const RowFacts& row);
[[nodiscard]] EditReach reach(const Chunks& edit, const ReachFacts& row);

} // namespace core
