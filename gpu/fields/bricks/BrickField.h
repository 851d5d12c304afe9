// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "gpu/gl/Buffer.h"
#include "gpu/gl/Texture3D.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gpu {

/// How a BrickField is created.
struct BrickFieldOptions {
    const char* label = "";
    GLenum format = GL_R8UI; ///< R8UI or R32UI
    std::uint32_t emptyVoxel = 0;
    core::BrickGrid grid;
};

/// A sparse field of voxels, stored in bricks of 16³: a page table (one texel per brick: page + 1,
/// 0 for none) and an atlas of pages, each with the 4096 voxels of a brick (DESIGN §4). Bricks
/// without a page hold `emptyVoxel` and take no memory.
///
/// The processor decides which bricks have a page; kernels read the table and write the atlas.
/// Engine thread only.
class BrickField {
public:
    BrickField() = default;
    explicit BrickField(const BrickFieldOptions& options);

    [[nodiscard]] bool created() const { return bool(m_pageTable); }
    [[nodiscard]] bool holds(std::uint32_t brick) const { return m_entries[brick] != 0; }
    /// Allocates the first 4096 pages, at most one per brick, so that no stroke waits for that.
    void reserve();
    enum class NewPages : std::uint8_t {
        Empty,
        AnyContent, ///< the caller writes every voxel of the listed bricks at once
    };
    /// Gives every listed brick a page. May enlarge the atlas.
    void ensure(std::span<const std::uint32_t> bricks, NewPages pages = NewPages::Empty);
    /// Takes the pages away again; their content is lost.
    void release(std::span<const std::uint32_t> bricks);
    /// Whether no brick has a page.
    [[nodiscard]] bool empty() const { return m_freePages.size() == m_pageCount; }
    /// All bricks that have a page, ascending.
    [[nodiscard]] std::vector<std::uint32_t> heldBricks() const;

    /// Reads the voxels of a brick that has a page; waits for the GPU.
    void read(std::uint32_t brick, std::span<std::byte> voxels) const;
    /// Writes all voxels of a brick that has a page. What a page holds belongs to the GPU, as what
    /// kernels write into the atlas.
    void write(std::uint32_t brick, std::span<const std::byte> voxels) const;

    [[nodiscard]] const Texture3D& atlas() const { return m_atlas; }
    /// The page table; uploads it first if it has changed.
    [[nodiscard]] const Texture3D& pageTable();
    /// One word per page: the brick that owns it, as x | y << 10 | z << 20. Uploads it first if it
    /// has changed.
    [[nodiscard]] const Buffer& pageOwners();
    /// The page of a brick that has one.
    [[nodiscard]] std::uint32_t pageOf(std::uint32_t brick) const { return m_entries[brick] - 1; }
    /// The brick that holds a page.
    [[nodiscard]] std::uint32_t ownerOf(std::uint32_t page) const { return m_owners[page]; }
    [[nodiscard]] std::size_t bytes() const;

private:
    void enlarge(std::uint32_t pages);
    void clear(std::vector<std::uint32_t> pages);

    BrickFieldOptions m_options;
    Texture3D m_atlas;
    Texture3D m_pageTable;
    std::vector<std::uint32_t> m_entries;
    std::vector<std::uint32_t> m_freePages; ///< last is taken next
    std::uint32_t m_pageCount = 0;
    std::vector<std::uint32_t> m_owners; ///< brick of each page
    /// Packed position of each owner, as kernels read it.
    std::vector<std::uint32_t> m_ownerPositions;
    Buffer m_ownerBuffer;
    bool m_tableStale = true;
    bool m_ownersStale = true;
};

} // namespace gpu
