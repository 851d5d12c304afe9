// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/brick/VoxelRuns.h"
#include "core/chunks/ChunkTree.h"
#include "core/volume/VolumeGeometry.h"

#include <optional>

namespace core {

/// Voxels of the volume that a segment is to get, and those that it is to lose.
struct ChunkChange {
    VoxelRuns given;
    VoxelRuns taken;
    bool operator==(const ChunkChange&) const = default;
};

/// The chunks of a box of the volume, in the volume's own voxels.
class ChunkMap {
public:
    /// The voxels that a label has, with so many millimetres around them on all sides; cut at the
    /// volume. None: it has no voxels. @param labels of the whole volume, x fastest
    [[nodiscard]] static std::optional<VoxelBox> boxAround(std::span<const std::uint8_t> labels,
        std::uint8_t label, const VolumeGeometry& geometry, double marginMm);
    /// A box with so many millimetres more on all sides; cut at the volume.
    [[nodiscard]] static VoxelBox withMargin(
        const VoxelBox& box, const VolumeGeometry& geometry, double marginMm);

    /// @param volumeSize of the volume that the box lies in
    ChunkMap(const glm::ivec3& volumeSize, const VoxelBox& box, ChunkTree tree);

    [[nodiscard]] const ChunkTree& tree() const { return m_tree; }
    [[nodiscard]] const VoxelBox& box() const { return m_box; }
    [[nodiscard]] const glm::ivec3& volumeSize() const { return m_volumeSize; }
    /// Which chunk of a division holds a voxel of the volume; none: it lies outside the box, or was
    /// left out.
    [[nodiscard]] std::optional<ChunkTree::Chunk> chunkAt(
        const glm::ivec3& voxel, int division) const;
    /// Those that hold any of these voxels, each once, ascending.
    [[nodiscard]] std::vector<ChunkTree::Chunk> chunksAt(
        const std::vector<glm::ivec3>& voxels, int division) const;
    [[nodiscard]] VoxelRuns voxels(ChunkTree::Chunk chunk) const;
    /// Calls @p visit(voxel of the volume), in the order of the chunk's pieces.
    template <class Visit> void forEachVoxel(ChunkTree::Chunk chunk, const Visit& visit) const
    {
        const auto columns = std::uint32_t(m_box.maximum.x - m_box.minimum.x);
        const auto rows = std::uint32_t(m_box.maximum.y - m_box.minimum.y);
        for (const std::uint32_t voxel : m_tree.voxels(chunk)) {
            const std::uint32_t row = voxel / columns;
            visit(
                m_box.minimum + glm::ivec3(int(voxel % columns), int(row % rows), int(row / rows)));
        }
    }

    /// What clicks on voxels come to: a chunk of which the segment has more than half goes, any
    /// other one comes, each once however often it is clicked.
    /// @param labels of the whole volume as they are now, x fastest
    [[nodiscard]] ChunkChange toggled(const std::vector<glm::ivec3>& clicked, int division,
        std::span<const std::uint8_t> labels, std::uint8_t label) const;

private:
    [[nodiscard]] std::uint64_t inVolume(std::uint32_t boxVoxel) const;

    glm::ivec3 m_volumeSize;
    VoxelBox m_box;
    ChunkTree m_tree;
};

} // namespace core
