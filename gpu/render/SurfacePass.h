// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Framebuffer.h"
#include "gpu/gl/Program.h"
#include "gpu/gl/Texture2D.h"
#include "gpu/scene/PassTarget.h"
#include "gpu/scene/Scene.h"
#include "gpu/scene/TilePlan.h"

#include <array>
#include <cstddef>

namespace gpu {

class SurfaceBuffers;
class VolumeTextures;

/// The surface that is being refined as one view sees it, for the ray caster to lay among the rest.
/// Nothing is kept before it is first drawn; then 12 bytes a pixel.
struct SurfacePicture {
    Texture2D colours; ///< RGBA8; a: how much of the pixel; 0: none
    Texture2D ways; ///< R32F: where a pixel's ray meets it, millimetres along the ray
    Texture2D depth;
    Framebuffer frame;
    Tile blocks; ///< drawn pixels beyond which nothing of it is seen; may reach beyond the picture

    [[nodiscard]] bool isEmpty() const { return blocks.size.x <= 0; }
};

/// Rasterises the surface with the ray caster's camera, whatever hides it: the front-most of it in
/// each pixel, lit like the rest of the 3D view, without what its plane or the scene's clip region
/// hides. Marks win where most of a place has them.
class SurfacePass {
public:
    /// @param library outlives the pass
    explicit SurfacePass(const ShaderLibrary& library);

    /// Draws a whole picture; once for each, before its first tile. Cost: linear in the surface.
    /// Throws ShaderError.
    /// @param scene has a surface
    void draw(SurfacePicture& picture, const SurfaceBuffers& surface, VolumeTextures& volume,
        const VolumeScene& scene, const PassTarget& target);

private:
    static constexpr std::size_t styles = 3;
    /// @param hides something of it is hidden by a plane
    [[nodiscard]] Program& programFor(SurfaceStyle style, bool hides);

    const ShaderLibrary& m_library;
    std::array<Program, 2 * styles> m_programs; ///< each when it is first needed
};

} // namespace gpu
