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

/// The surface that is being refined as one view sees it, drawn into textures that the ray caster
/// composes with the rest. Nothing is allocated before it is first drawn; then it takes 12 bytes
/// per pixel.
struct SurfacePicture {
    Texture2D colours; ///< RGBA8; alpha is how much of the pixel it covers, 0 where there is none
    Texture2D ways; ///< R32F: where a pixel's ray meets it, millimetres along the ray
    Texture2D depth;
    Framebuffer frame;
    /// Rectangle of drawn pixels outside which nothing of it is seen; may extend beyond the
    /// picture.
    Tile blocks;

    [[nodiscard]] bool isEmpty() const { return blocks.size.x <= 0; }
};

/// Rasterises the surface with the ray caster's camera, whether or not something hides it: in each
/// pixel its front-most part, lit like the rest of the 3D view, without what its plane or the clip
/// region of the scene hides. A place shows the mark that prevails there.
class SurfacePass {
public:
    /// @param library outlives the pass
    explicit SurfacePass(const ShaderLibrary& library);

    /// Draws a whole picture; call it once for each, before its first tile. Linear in the surface.
    /// Throws ShaderError.
    void draw(SurfacePicture& picture, const SurfaceBuffers& surface, VolumeTextures& volume,
        const VolumeScene& scene, const PassTarget& target);

private:
    static constexpr std::size_t styles = 3;
    /// @param hides whether a plane hides a part of it
    [[nodiscard]] Program& programFor(SurfaceStyle style, bool hides);

    const ShaderLibrary& m_library;
    std::array<Program, 2 * styles> m_programs; ///< each when it is first needed
};

} // namespace gpu
