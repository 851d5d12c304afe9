// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/brick/BrickGrid.h"
#include "gpu/fields/bricks/FieldPrograms.h"
#include "gpu/gl/Buffer.h"
#include "gpu/gl/Texture3D.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gpu {

/// One field as the copying kernels see it.
struct FieldTextures {
    const Texture3D* voxels = nullptr; ///< atlas, or the dense texture
    const Texture3D* pageTable = nullptr; ///< null: dense
    core::Field field = core::Field::Coverage;
};

/// Moves whole bricks between fields and buffers (packBricks.comp, unpackBricks.comp).
///
/// A packed brick is 4096 voxels, x fastest, 1 or 4 bytes each. Engine thread only.
class BrickCopier {
public:
    /// @param programs outlive the copier
    BrickCopier(CopyPrograms& programs, const core::BrickGrid& grid);

    /// Into a buffer of its own, on the GPU; does not wait.
    [[nodiscard]] Buffer packed(
        const FieldTextures& source, std::span<const std::uint32_t> bricks) const;
    /// The packed bricks in memory; waits. An image whose voxels are all empty has no bytes.
    [[nodiscard]] std::vector<std::vector<std::uint8_t>> images(
        const FieldTextures& source, std::span<const std::uint32_t> bricks) const;
    /// The same of a buffer that packed() made.
    [[nodiscard]] static std::vector<std::vector<std::uint8_t>> images(
        const Buffer& packed, core::Field field, std::size_t count);
    /// Writes images into a field whose bricks have pages; no bytes: all empty.
    void write(const FieldTextures& target, std::span<const std::uint32_t> bricks,
        std::span<const std::vector<std::uint8_t>* const> images) const;
    /// Writes a buffer that packed() made.
    void write(const FieldTextures& target, std::span<const std::uint32_t> bricks,
        const Buffer& packed) const;

private:
    core::BrickGrid m_grid;
    CopyPrograms& m_programs;
};

/// Bytes of one packed brick.
[[nodiscard]] std::size_t packedBrickBytes(core::Field field);

} // namespace gpu
