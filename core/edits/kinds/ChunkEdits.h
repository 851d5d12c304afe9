// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

// Edits that divide a part of the volume into chunks and take them by clicks (core/chunks).

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

/// Chunks of the newest division become a segment's, or are taken from it.
struct ChunkToggle {
    enum class Mode {
        Toggle, ///< one that the segment has more than half of goes, any other one comes
        Add,
        Remove,
    };
    int segment = 0; ///< label
    int chunks = 0; ///< into how many the whole is divided
    Mode mode = Mode::Toggle;
    std::vector<glm::dvec3> pointsLps{}; ///< each stands for the chunk that it lies in
    bool overwriteUnlocked = false;
    /// That the chunks lie in, ascending: whoever carries it out adds them
    /// (session/past/RowReach.h).
    std::optional<std::vector<std::int64_t>> bricks{};
};

} // namespace core
