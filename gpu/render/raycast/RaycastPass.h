// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Program.h"
#include "gpu/gl/Texture2D.h"
#include "gpu/gl/VertexArray.h"
#include "gpu/render/SeedDots.h"
#include "gpu/render/parts/ChunkTextures.h"
#include "gpu/render/parts/Palette.h"
#include "gpu/render/parts/PieceSet.h"
#include "gpu/render/parts/RayBlocks.h"
#include "gpu/render/parts/TransferLookup.h"
#include "gpu/scene/PassTarget.h"
#include "gpu/scene/Scene.h"

#include <array>
#include <map>

namespace gpu {

class VolumeTextures;
struct PlanePicture;
struct SurfacePicture;
struct ViewFrame;

/// Of this picture, what is to be laid among the rest; null: nothing.
struct RaySheets {
    const SurfacePicture* surface = nullptr; ///< drawn whole
    const PlanePicture* plane = nullptr; ///< drawn where the tile is
    [[nodiscard]] bool any() const { return surface != nullptr || plane != nullptr; }
};

/// Draws the 3D view by casting one ray per pixel: shaded surface, volume rendering, maximum
/// intensity or X-ray; orthographic or perspective; any affine. What radiation ≥ 0.5 covers is not
/// seen; shown segments are, whole, pieces, each in its pose, seeds as dots, and barriers as
/// translucent bodies. Background black.
class RaycastPass {
public:
    /// Throws ShaderError. @param library outlives the pass
    explicit RaycastPass(const ShaderLibrary& library);

    /// Draws a tile into the bound framebuffer, whose scissor it sets. Cheap to begin unless
    /// voxels, threshold or transfer function changed (then the skip map is computed anew, linear
    /// in the cells).
    /// @param tile as TilePlan cuts it @param noVertices of the context
    /// @param chunks of the scene; null: none to be drawn
    void draw(VolumeTextures& volume, const VolumeScene& scene, const Palette& palette,
        const PassTarget& target, const Tile& tile, const VertexArray& noVertices,
        const RaySheets& sheets = {}, const ChunkTextures* chunks = nullptr);
    /// Draws one pixel by each program that the first carving or the first shown segment will need:
    /// drivers compile a program only when it first draws, and that should not be while a pen
    /// waits. Nothing where they have drawn already.
    void warmUp(VolumeTextures& volume, const VolumeScene& scene, const Palette& palette,
        const PassTarget& target, const VertexArray& noVertices);

private:
    void bindSheets(Program& program, const VolumeScene& scene, const RaySheets& sheets);
    void prepare(Program& program, VolumeTextures& volume, const VolumeScene& scene,
        const Palette& palette, const PassTarget& target);
    void setRays(Program& program, const VolumeTextures& volume, const VolumeScene& scene,
        const ViewFrame& view, const PassTarget& target);
    void setClip(Program& program, const VolumeTextures& volume, const core::ClipRegion& clip);
    void setFaces(Program& program, const VolumeTextures& volume, const VolumeScene& scene);
    /// @return codes that the mode shows
    VisibleCodes setMode(Program& program, VolumeTextures& volume, const VolumeScene& scene);

    /// What is seldom needed.
    struct Seldom {
        bool pieces = false;
        bool seeds = false;
        bool barriers = false;
        bool warned = false; ///< members warn
        bool foreseen = false; ///< some members would go
        bool sheets = false; ///< the surface that is being refined, or the cutting plane
        bool chunks = false;
        RayBlocks::Kind kind = RayBlocks::Kind::Sculpted; ///< of the rest
    };

    static constexpr std::size_t variants = 6; ///< kinds but pieces, each clipped or not
    [[nodiscard]] Program& programFor(
        RayBlocks::Kind kind, const VolumeScene& scene, const Seldom& with);
    /// As a program of its own: compiled when it first is needed.
    [[nodiscard]] Program& seldomProgram(const VolumeScene& scene, const Seldom& with);
    [[nodiscard]] std::size_t variantOf(const VolumeScene& scene, RayBlocks::Kind kind) const;
    /// Of this picture; looked for anew only when something changed.
    [[nodiscard]] const RayBlocks& blocksOf(
        VolumeTextures& volume, const VolumeScene& scene, const PassTarget& target);

    std::array<Program, variants * renderModes> m_programs;
    std::array<bool, variants * renderModes> m_warm{}; ///< has drawn
    const ShaderLibrary& m_library;
    PieceSet m_pieces;
    Texture2D m_noSheet; ///< one texel; made with the first sheet
    SeedDots m_seeds;
    std::map<std::size_t, Program> m_seldomPrograms; ///< by all that they are compiled for
    TransferLookup m_transfer;
    RayBlocks m_blocks;
    VolumeScene m_blocksScene; ///< what m_blocks was made for, like the next three
    glm::ivec2 m_blocksSize{0};
    float m_blocksScale = 0.0f;
    std::uint64_t m_blocksRevision = 0;
};

} // namespace gpu
