// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Program.h"
#include "gpu/gl/Texture2D.h"
#include "gpu/gl/Texture3D.h"
#include "gpu/render/parts/ChunkBodies.h"
#include "gpu/scene/Scene.h"

#include <memory>

namespace gpu {

/// The chunks that scenes show, on the GPU: which voxel belongs to which chunk, sent once per
/// division, and the colours of slices and of the 3D view, sent whenever they change. Holds one
/// division at a time. Engine thread only.
class ChunkTextures {
public:
    /// Slices draw the voxels as areas, the 3D view draws smoothed bodies.
    enum class Drawn : std::uint8_t { Areas, Bodies };

    /// Takes what has changed in the chunks of a scene. Costs nothing while they are the same; else
    /// their box, or the part around chunks that changed colour, is searched and sent
    /// (ChunkBodies).
    /// @param chunks null if the scene shows none; the memory is freed once nobody holds the last
    /// chunks
    /// @return whether there are any to draw
    [[nodiscard]] bool update(const SceneChunks* chunks, Drawn drawn);
    /// Whether update() had anything to do since the last call.
    [[nodiscard]] bool takeChanged();

    /// Binds the chunks of the last update() to their units (gpu/README.md) and sets the uniforms.
    void bind(Program& program, const SceneChunks& chunks, Drawn drawn) const;

private:
    struct Colours {
        std::vector<std::uint32_t> argb;
        std::vector<std::uint32_t> rims;
        std::vector<ChunkBodies::Colour> row; ///< by leaf, the first for voxels without a chunk
        Texture2D texture;
    };
    void takeLeaves(const SceneChunks& chunks);
    static void takeColours(Colours& colours, const SceneChunks& chunks);
    void drop();
    [[nodiscard]] core::VoxelBox changedBy(const std::vector<std::uint32_t>& argb) const;

    std::weak_ptr<const std::vector<std::uint16_t>> m_leaves; ///< the chunks that m_voxels holds
    std::vector<core::VoxelBox> m_boxes; ///< the box of each chunk of the finest division
    Texture3D m_voxels;
    Colours m_areas;
    Colours m_bodyColours;
    ChunkBodies m_bodies;
    bool m_changed = false;
};

} // namespace gpu
