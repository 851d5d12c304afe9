// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

#include <QByteArray>

#include <optional>
#include <vector>

namespace core {

/// A label of the voxels that are divided into chunks, with its voxels.
struct ChunkOwner {
    int label = 0;
    QByteArray voxels{}; ///< packedRuns() (core/brick/VoxelRuns.h), on the volume's grid
    bool operator==(const ChunkOwner&) const = default;
};

/// Divide a segment and its surroundings into chunks (core/chunks/ChunkTree.h). When it is carried
/// out, the labels in the box around the segment are added, so that the edit contains what it reads
/// besides the volume.
struct DivideSegment {
    int segment = 0; ///< label
    double marginMm = 10.0; ///< around its voxels, on all sides
    std::optional<std::vector<ChunkOwner>> owners{}; ///< by label; label 0 has all other voxels
    bool operator==(const DivideSegment&) const = default;
};

[[nodiscard]] Result<void> check(const DivideSegment& edit, const Document& document);
Result<bool> apply(const DivideSegment& edit, Document& document);
[[nodiscard]] EditEffects effects(const DivideSegment& edit);
[[nodiscard]] RowTitle rowTitle(const DivideSegment& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const DivideSegment& edit, const DependencyFacts& row);

} // namespace core
