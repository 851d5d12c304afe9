// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/chunks/ChunkMap.h"
#include "core/document/Document.h"
#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/sculpt/LayerWrites.h"

#include <map>

namespace core {

struct Chunks;
struct ChunkOwner;

// Dividing into chunks and clicking on them, from edits to what core/chunks and an engine take.

/// What a division depends on besides the volume's codes: a box of the volume, and whose voxels
/// those in it are, x fastest (ChunkSource::owners).
struct OwnedBox {
    VoxelBox box;
    std::vector<std::uint8_t> owners;
};

/// The labels that a division goes by, for the edit to name them.
/// @param labels of the whole volume in the segment's plane, x fastest
/// Cost: some passes over the volume. Errors: InvalidField (the segment has no voxels, or the box
/// is larger than mostChunkVoxels).
[[nodiscard]] Result<std::vector<ChunkOwner>> chunkOwners(
    const Chunks& edit, const VolumeGeometry& geometry, std::span<const std::uint8_t> labels);
constexpr std::int64_t mostChunkVoxels = std::int64_t(1) << 26;

/// Of an edit that names its owners. ChunkSource::outside is no owner: who has it for a label gets
/// a number that is free. Errors: InvalidField (voxels that are none, or of another
/// volume; the segment is not among them; the box is too large).
[[nodiscard]] Result<OwnedBox> ownedBox(const Chunks& edit, const VolumeGeometry& geometry);

/// Who gets chunks or loses them, and which voxels were clicked on. Errors: UnknownSegment,
/// SegmentLocked, InvalidField (nothing is divided, a point outside the volume).
struct ChunkClick {
    LabelTarget target;
    std::vector<glm::ivec3> voxels;
};
[[nodiscard]] Result<ChunkClick> chunkClick(const ChunkToggle& edit, const Document& document);

/// Chunks that were clicked on, by the bricks that they lie in. Cost ∝ their voxels.
class ClickedChunks {
public:
    ClickedChunks(const ChunkMap& map, const ChunkToggle& edit, const ChunkClick& click);

    [[nodiscard]] bool empty() const { return m_chunks.empty(); }
    /// Ascending.
    [[nodiscard]] std::vector<std::uint32_t> bricks() const;
    /// What the engine is to do. @param labels what these bricks hold in the target's plane (an
    /// image without bytes: nothing); only looked at by Mode::Toggle
    [[nodiscard]] RelabelListed relabelled(const std::vector<BrickChange>& labels) const;

private:
    /// Of one chunk in one brick.
    struct Part {
        std::uint32_t brick = 0;
        std::vector<std::uint16_t> offsets;
    };
    [[nodiscard]] static std::vector<Part> partsOf(
        const ChunkMap& map, ChunkTree::Chunk chunk, const BrickGrid& grid);

    ChunkToggle::Mode m_mode;
    LabelTarget m_target;
    std::vector<std::vector<Part>> m_chunks;
};

} // namespace core
