// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/frame/FrameTargets.h"
#include "gpu/render/PlanePass.h"
#include "gpu/render/SlicePass.h"
#include "gpu/render/SurfaceContour.h"
#include "gpu/render/SurfacePass.h"
#include "gpu/render/parts/ChunkTextures.h"
#include "gpu/render/parts/Palette.h"
#include "gpu/render/parts/SurfaceBuffers.h"
#include "gpu/render/raycast/RaycastPass.h"

#include <optional>

namespace gpu {

/// Parts of one view's picture that are drawn before its tiles or together with them, into textures
/// of their own.
struct ViewPictures {
    SurfacePicture surface; ///< of a 3D view
    PlanePicture plane; ///< likewise
    ContourPicture contour; ///< of a slice
};

/// Draws tiles of the pictures that views request, with the passes that their scenes need. It also
/// keeps the surface that is being refined. Engine thread.
class ViewPainter {
public:
    /// Throws ShaderError. @param volume, shaders outlive the painter
    ViewPainter(VolumeTextures& volume, const ShaderLibrary& shaders);

    /// Begins a picture: draws what it shows of the surface, as a whole. Linear in the size of the
    /// surface.
    /// @return whether it shows any
    bool begin(ViewPictures& pictures, const Scene& scene, const PassTarget& target);
    /// @param into at least as large as the tile
    /// @param add whether to add to what it holds
    void draw(ViewPictures& pictures, const FrameRequest& request, const PassTarget& target,
        const Tile& tile, const Framebuffer& into, bool add);
    /// As RaycastPass::warmUp(). Draws one pixel into the bound framebuffer.
    void warmUp(const VolumeScene& scene, const glm::ivec2& frameSize);

    /// Whether chunks were sent to the GPU since the last call.
    [[nodiscard]] bool takeChunksChanged() { return m_chunks.takeChanged(); }
    [[nodiscard]] SurfaceBuffers& surface() { return m_surface; }
    [[nodiscard]] const SurfaceBuffers& surface() const { return m_surface; }
    [[nodiscard]] const VertexArray& noVertices() const { return m_noVertices; }

private:
    bool beginVolume(ViewPictures& pictures, const VolumeScene& scene, const PassTarget& target);
    bool beginSlice(ViewPictures& pictures, const SliceScene& scene, const PassTarget& target);
    [[nodiscard]] ContourPass* contours(bool wanted);

    VolumeTextures& m_volume;
    const ShaderLibrary& m_shaders;
    RaycastPass m_raycast;
    SlicePass m_slice;
    Palette m_palette;
    ChunkTextures m_chunks;
    VertexArray m_noVertices;
    SurfaceBuffers m_surface;
    std::optional<SurfacePass> m_surfacePass; ///< made when first needed, like the next two
    std::optional<ContourPass> m_contourPass;
    std::optional<PlanePass> m_planePass;
};

} // namespace gpu
