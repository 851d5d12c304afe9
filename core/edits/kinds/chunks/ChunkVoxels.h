// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/chunks/ChunkMap.h"
#include "core/document/Document.h"
#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/sculpt/labels/LayerWrites.h"

#include <map>
#include <optional>

namespace core {

struct DivideSegment;
struct ChunkOwner;

// Converts divisions into chunks, and clicks on them, to the input of core/chunks and of an engine.

/// What a division depends on besides the volume's codes: a box of the volume, and the owner of
/// each voxel in it, x fastest (ChunkSource::owners).
struct OwnedBox {
    VoxelBox box;
    std::vector<std::uint8_t> owners;
    std::uint8_t segment = 0; ///< the owner that is divided
    std::vector<std::uint8_t> probabilities{}; ///< in the box; empty: there is no map
};

/// The labels on which a division is based, to be stored in the edit.
/// @param labels of the whole volume in the segment's plane, x fastest Cost: several passes over
/// the volume. Errors: InvalidField (the segment has no voxels, or the box is larger than
/// mostChunkVoxels).
[[nodiscard]] Result<std::vector<ChunkOwner>> chunkOwners(const DivideSegment& edit,
    const VolumeGeometry& geometry, std::span<const std::uint8_t> labels);
constexpr std::int64_t mostChunkVoxels = std::int64_t(1) << 26;

/// For an edit that stores its owners. ChunkSource::outside is not a valid owner, so a label of
/// that value is replaced by a free number. Errors: InvalidField (voxels or probabilities that
/// cannot be unpacked, or of another volume; the segment is not among them; the box is too large).
[[nodiscard]] Result<OwnedBox> ownedBox(const DivideSegment& edit, const VolumeGeometry& geometry);

/// The probability map of an edit, of the whole volume; empty if it has none. Errors: InvalidField
/// (damaged, or of another volume).
[[nodiscard]] Result<std::vector<std::uint8_t>> probabilitiesOf(
    const DivideSegment& edit, const VolumeGeometry& geometry);

/// The segment that gains or loses chunks, which voxels may change, and those that were clicked.
/// Errors: UnknownSegment, SegmentLocked, InvalidField (nothing is divided, a point outside the
/// volume), those of editableVoxels().
struct ChunkClick {
    LabelTarget target;
    std::optional<EditableVoxels> editable;
    std::vector<glm::ivec3> voxels;
};
[[nodiscard]] Result<ChunkClick> chunkClick(const ChunkToggle& edit, const Document& document);

/// The chunks that were clicked, by the bricks in which they lie. Cost ∝ their voxels.
class ClickedChunks {
public:
    ClickedChunks(const ChunkMap& map, const ChunkToggle& edit, const ChunkClick& click);

    [[nodiscard]] bool empty() const { return m_chunks.empty(); }
    /// Ascending.
    [[nodiscard]] std::vector<std::uint32_t> bricks() const;
    /// The edit for the engine.
    /// @param labels what these bricks hold in the target's plane (an image without bytes:
    /// nothing); only used by Mode::Toggle
    [[nodiscard]] RelabelListed relabelled(const std::vector<BrickChange>& labels) const;

private:
    /// The voxels of one chunk in one brick.
    struct Part {
        std::uint32_t brick = 0;
        std::vector<std::uint16_t> offsets;
    };
    [[nodiscard]] static std::vector<Part> partsOf(
        const ChunkMap& map, ChunkTree::Chunk chunk, const BrickGrid& grid);

    ChunkToggle::Mode m_mode;
    LabelTarget m_target;
    std::optional<EditableVoxels> m_editable;
    std::vector<std::vector<Part>> m_chunks;
};

} // namespace core
