// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Program.h"
#include "gpu/gl/Texture2D.h"
#include "gpu/gl/VertexArray.h"
#include "gpu/render/SeedDots.h"
#include "gpu/render/parts/ChunkTextures.h"
#include "gpu/render/parts/ColourTable.h"
#include "gpu/render/parts/Palette.h"
#include "gpu/render/parts/PieceSet.h"
#include "gpu/render/parts/RayBlocks.h"
#include "gpu/render/parts/SegmentCells.h"
#include "gpu/render/parts/TransferLookup.h"
#include "gpu/scene/PassTarget.h"
#include "gpu/scene/Scene.h"
#include "gpu/shaders/RecentPrograms.h"

#include <array>

namespace gpu {

class VolumeTextures;
struct PlanePicture;
struct SurfacePicture;
struct ViewFrame;

/// Pictures of surface and cutting plane that the ray caster composes with the rest; null if there
/// is none.
struct RaySheets {
    const SurfacePicture* surface = nullptr; ///< drawn for the whole picture
    const PlanePicture* plane = nullptr; ///< drawn at least for this tile
    [[nodiscard]] bool any() const { return surface != nullptr || plane != nullptr; }
};

/// Draws the 3D view by casting one ray per pixel: shaded surface, volume rendering, maximum
/// intensity or X-ray; orthographic or perspective; for any affine geometry. Voxels with radiation
/// ≥ 0.5 are carved away and not seen. Shown segments are drawn whole; pieces in their poses; seeds
/// as dots; barriers as translucent bodies. What is in no segment may be translucent, or not drawn
/// (Context). The background is black.
class RaycastPass {
public:
    /// Throws ShaderError. @param library outlives the pass
    explicit RaycastPass(const ShaderLibrary& library);

    /// Draws a tile into the bound framebuffer, whose scissor it sets. Cheap to begin unless
    /// voxels, threshold or transfer function have changed; then the skip map is recomputed, in
    /// time linear in the cells.
    /// @param tile as TilePlan cuts it
    /// @param noVertices belongs to this context
    /// @param chunks of the scene; null if none are drawn
    void draw(VolumeTextures& volume, const VolumeScene& scene, const Palette& palette,
        const PassTarget& target, const Tile& tile, const VertexArray& noVertices,
        const RaySheets& sheets = {}, const ChunkTextures* chunks = nullptr);
    /// Draws one pixel with each program that the first carving or the first shown segment will
    /// need, unless it has drawn before. Drivers compile a program when it first draws, and no pen
    /// should wait for that.
    void warmUp(VolumeTextures& volume, const VolumeScene& scene, const Palette& palette,
        const PassTarget& target, const VertexArray& noVertices);

private:
    void drawMode(VolumeTextures& volume, const VolumeScene& scene, const Palette& palette,
        const PassTarget& target, const Tile& tile, const VertexArray& noVertices,
        const RaySheets& sheets, const ChunkTextures* chunks);
    void bindSheets(Program& program, const VolumeScene& scene, const RaySheets& sheets);
    void prepare(Program& program, VolumeTextures& volume, const VolumeScene& scene,
        const Palette& palette, const PassTarget& target);
    void setRays(Program& program, const VolumeTextures& volume, const VolumeScene& scene,
        const ViewFrame& view, const PassTarget& target);
    void setClip(Program& program, const VolumeTextures& volume, const core::ClipRegion& clip);
    void setFaces(Program& program, const VolumeTextures& volume, const VolumeScene& scene);
    /// @return the codes that the mode shows
    VisibleCodes setMode(Program& program, VolumeTextures& volume, const VolumeScene& scene);

    /// Features that are seldom needed.
    struct Seldom {
        bool pieces = false;
        bool seeds = false;
        bool barriers = false;
        bool warned = false; ///< some members are drawn in the warning colour
        bool cutPreview = false; ///< marks what a cut would remove, or an interval changes
        bool suspended = false; ///< of that, what is suspended has bodies
        bool sheets = false; ///< the surface that is being refined, or the cutting plane
        bool chunks = false;
        bool segmentLooks = false; ///< segments are translucent, or drawn as their voxels are
        RayBlocks::Kind kind = RayBlocks::Kind::Sculpted; ///< how sculpted the rest is
    };

    static constexpr std::size_t variants = 6; ///< kinds but pieces, each clipped or not
    [[nodiscard]] Program& programFor(
        RayBlocks::Kind kind, const VolumeScene& scene, const Seldom& with);
    /// A program for exactly these features, compiled when it is needed; it may be dropped at the
    /// next call.
    [[nodiscard]] Program& seldomProgram(const VolumeScene& scene, const Seldom& with);
    [[nodiscard]] static std::size_t variantOf(const VolumeScene& scene, RayBlocks::Kind kind);
    /// The program of a variantOf(), compiled when it is first needed.
    [[nodiscard]] Program& oftenProgram(std::size_t variant);
    /// The blocks of this picture; computed again only when something has changed.
    [[nodiscard]] const RayBlocks& blocksOf(
        VolumeTextures& volume, const VolumeScene& scene, const PassTarget& target);

    std::array<Program, variants * renderModes> m_programs;
    std::array<bool, variants * renderModes> m_warm{}; ///< programs that have drawn
    const ShaderLibrary& m_library;
    PieceSet m_pieces;
    Texture2D m_noSheet; ///< one texel; made with the first sheet
    SeedDots m_seeds;
    SegmentCells m_segmentCells;
    /// By all features that they are compiled for. There are thousands of combinations; a picture
    /// takes a dozen at most.
    RecentPrograms<std::size_t, Program, 32> m_seldomPrograms;
    bool m_voxelTrue = false; ///< segments of the picture that is drawn
    TransferLookup m_transfer;
    ColourTable m_colours;
    RayBlocks m_blocks;
    VolumeScene m_blocksScene; ///< what m_blocks was made for, like the next three
    glm::ivec2 m_blocksSize{0};
    float m_blocksScale = 0.0f;
    std::uint64_t m_blocksRevision = 0;
};

} // namespace gpu
