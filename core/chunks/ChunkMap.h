// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "core/brick/VoxelRuns.h"
#include "core/chunks/ChunkSurvey.h"
#include "core/volume/VolumeGeometry.h"

#include <optional>

namespace core {

/// The voxels that a segment gains and those that it loses.
struct ChunkChange {
    VoxelRuns given;
    VoxelRuns taken;
    bool operator==(const ChunkChange&) const = default;
};

/// The chunks of a box of the volume, addressed by voxels of the volume.
class ChunkMap {
public:
    /// The bounding box of a label's voxels with a margin in millimetres on all sides, clipped to
    /// the volume. None: the label has no voxels. @param labels of the whole volume, x fastest
    [[nodiscard]] static std::optional<VoxelBox> boxAround(std::span<const std::uint8_t> labels,
        std::uint8_t label, const VolumeGeometry& geometry, double marginMm);
    /// A box with a margin in millimetres on all sides, clipped to the volume.
    [[nodiscard]] static VoxelBox withMargin(
        const VoxelBox& box, const VolumeGeometry& geometry, double marginMm);

    /// A margin in millimetres that suits a segment: a third of the diameter of a ball of the same
    /// volume, because a missing part is rarely larger. It is a multiple of 5 between 10 and 60,
    /// and limited so that the box has at most some 24 million voxels. No cost.
    /// @param voxels number of voxels of the segment
    [[nodiscard]] static double suitableMarginMm(
        std::int64_t voxels, const VolumeGeometry& geometry);

    /// @param volumeSize size of the volume that contains the box
    /// @param survey that of the tree; empty: no chunk is in doubt
    ChunkMap(
        const glm::ivec3& volumeSize, const VoxelBox& box, ChunkTree tree, ChunkSurvey survey = {});

    [[nodiscard]] const ChunkTree& tree() const { return m_tree; }
    [[nodiscard]] const ChunkSurvey& survey() const { return m_survey; }
    [[nodiscard]] const VoxelBox& box() const { return m_box; }
    [[nodiscard]] const glm::ivec3& volumeSize() const { return m_volumeSize; }
    /// The chunk of a division that contains a voxel of the volume; none: the voxel is outside the
    /// box, or was left out.
    [[nodiscard]] std::optional<ChunkTree::Chunk> chunkAt(
        const glm::ivec3& voxel, int division) const;
    /// The chunks that contain any of these voxels, each once, ascending.
    [[nodiscard]] std::vector<ChunkTree::Chunk> chunksAt(
        const std::vector<glm::ivec3>& voxels, int division) const;
    [[nodiscard]] VoxelRuns voxels(ChunkTree::Chunk chunk) const;
    /// Calls @p visit(voxel of the volume) for each voxel, in the order of the chunk's pieces.
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

    /// The effect of clicks on voxels: a chunk of which the segment has more than half is removed,
    /// any other chunk is added, each once however often it is clicked.
    /// @param labels of the whole volume as they are now, x fastest
    [[nodiscard]] ChunkChange toggled(const std::vector<glm::ivec3>& clicked, int division,
        std::span<const std::uint8_t> labels, std::uint8_t label) const;

private:
    [[nodiscard]] std::uint64_t inVolume(std::uint32_t boxVoxel) const;

    glm::ivec3 m_volumeSize;
    VoxelBox m_box;
    ChunkTree m_tree;
    ChunkSurvey m_survey;
};

} // namespace core
