// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Program.h"
#include "gpu/gl/Texture2D.h"
#include "gpu/gl/Texture3D.h"
#include "gpu/render/parts/ChunkBodies.h"
#include "gpu/scene/Scene.h"

#include <memory>

namespace gpu {

/// The chunks that scenes show, on the GPU: which voxel belongs to which, sent once a division, and
/// the colours of slices and of the 3D view, sent whenever these change. One division at a time.
/// Engine thread only.
class ChunkTextures {
public:
    /// Slices draw the voxels as they are, the 3D view bodies.
    enum class Drawn : std::uint8_t { Areas, Bodies };

    /// Takes in what is new of a scene's chunks. Cost: none while they are the same; else their box
    /// is looked through and sent, or that around chunks of another colour (ChunkBodies).
    /// @param chunks null: the scene shows none; memory is given back once nobody holds what was
    /// @return whether there are any to be drawn
    [[nodiscard]] bool update(const SceneChunks* chunks, Drawn drawn);
    /// Whether update() had anything to do since this was asked last.
    [[nodiscard]] bool takeChanged();

    /// What updated last, on its units (gpu/README.md) and as uniforms.
    void bind(Program& program, const SceneChunks& chunks, Drawn drawn) const;

private:
    struct Colours {
        std::vector<std::uint32_t> argb;
        std::vector<ChunkBodies::Colour> row; ///< by leaf, the first of none
        Texture2D texture;
    };
    void takeLeaves(const SceneChunks& chunks);
    void takeColours(Colours& colours, const std::vector<std::uint32_t>& argb);
    void drop();
    [[nodiscard]] core::VoxelBox changedBy(const std::vector<std::uint32_t>& argb) const;

    std::weak_ptr<const std::vector<std::uint16_t>> m_leaves; ///< what m_voxels holds
    std::vector<core::VoxelBox> m_boxes; ///< of each chunk of the finest division
    Texture3D m_voxels;
    Colours m_areas;
    Colours m_bodyColours;
    ChunkBodies m_bodies;
    bool m_changed = false;
};

} // namespace gpu
