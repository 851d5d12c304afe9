// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "gpu/fields/bricks/BrickField.h"
#include "gpu/fields/bricks/FieldPrograms.h"
#include "gpu/gl/Buffer.h"
#include "gpu/gl/SoftwareDriver.h"
#include "gpu/gl/Texture3D.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gpu {

/// The textures of one field, as the copying kernels use them.
struct FieldTextures {
    const Texture3D* voxels = nullptr; ///< atlas, or the dense texture
    const Texture3D* pageTable = nullptr; ///< null for a dense field
    const BrickField* pages = nullptr; ///< null for a dense field
    core::Field field = core::Field::Coverage;
};

/// Those of a paged field.
[[nodiscard]] FieldTextures texturesOf(BrickField& pages, core::Field field);

/// Moves whole bricks between fields and buffers: by kernels (packBricks.comp, unpackBricks.comp),
/// or by the processor, which with a software driver copies a brick in one piece and not voxel by
/// voxel.
///
/// A packed brick is 4096 voxels, x fastest, 1 or 4 bytes each. Engine thread only.
class BrickCopier {
public:
    /// @param programs outlive the copier
    BrickCopier(CopyPrograms& programs, const core::BrickGrid& grid, WorkBy by = WorkBy::Driver);

    /// Packs the bricks into a new buffer on the GPU; does not wait.
    [[nodiscard]] Buffer packed(
        const FieldTextures& source, std::span<const std::uint32_t> bricks) const;
    /// Reads the bricks into memory; waits for the GPU. A brick whose voxels are all empty has no
    /// bytes.
    [[nodiscard]] std::vector<std::vector<std::uint8_t>> images(
        const FieldTextures& source, std::span<const std::uint32_t> bricks) const;
    /// The same for a buffer that packed() has made.
    [[nodiscard]] static std::vector<std::vector<std::uint8_t>> images(
        const Buffer& packed, core::Field field, std::size_t count);
    /// Writes images into bricks that have pages. An image without bytes makes all voxels empty.
    void write(const FieldTextures& target, std::span<const std::uint32_t> bricks,
        std::span<const std::vector<std::uint8_t>* const> images) const;
    /// In a list of bricks that write() takes with a buffer: this one is left as it is.
    static constexpr std::uint32_t skipped = 0xFFFFFFFFu;
    /// Writes a buffer that packed() has made.
    void write(const FieldTextures& target, std::span<const std::uint32_t> bricks,
        const Buffer& packed) const;

private:
    // Copies one brick on the processor.
    void read(
        const FieldTextures& source, std::uint32_t brick, std::span<std::uint8_t> image) const;
    void write(const FieldTextures& target, std::uint32_t brick,
        std::span<const std::uint8_t> image) const;

    core::BrickGrid m_grid;
    CopyPrograms& m_programs;
    bool m_byProcessor;
};

/// Bytes of one packed brick.
[[nodiscard]] std::size_t packedBrickBytes(core::Field field);

} // namespace gpu
