// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

#include <QByteArray>
#include <QString>

#include <optional>
#include <vector>

namespace core {

/// One owner of voxels that are divided into chunks: a label and its voxels.
struct ChunkOwner {
    int label = 0;
    QByteArray voxels{}; ///< packedRuns() (core/brick/VoxelRuns.h), on the volume's grid
    bool operator==(const ChunkOwner&) const = default;
};

/// Divide a segment and its surroundings into chunks (core/chunks/ChunkTree.h), by the image alone
/// or also by a probability map of the segment. When it is carried out, the labels in the box
/// around the segment are stored in it, so that the edit contains everything that it reads besides
/// the volume.
struct DivideSegment {
    int segment = 0; ///< label
    double marginMm = 10.0; ///< how far the box extends beyond the segment's voxels, on all sides
    /// Ascending by label; voxels that are not listed belong to label 0. None before it is carried
    /// out.
    std::optional<std::vector<ChunkOwner>> owners{};
    /// ProbabilityMap::packed() of the whole volume; none: the image alone decides.
    std::optional<QByteArray> probabilities{};
    /// In a recipe: the file from which core/masks/ReadProbabilities.h reads them. An edit that was
    /// carried out names no file.
    std::optional<QString> probabilityFile{};
    bool operator==(const DivideSegment&) const = default;
};

[[nodiscard]] Result<void> check(const DivideSegment& edit, const Document& document);
Result<bool> apply(const DivideSegment& edit, Document& document);
[[nodiscard]] EditEffects effects(const DivideSegment& edit);
[[nodiscard]] RowTitle rowTitle(const DivideSegment& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const DivideSegment& edit, const DependencyFacts& row);

} // namespace core
