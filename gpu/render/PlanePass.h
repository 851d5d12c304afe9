// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Framebuffer.h"
#include "gpu/gl/Texture2D.h"
#include "gpu/gl/VertexArray.h"
#include "gpu/render/SurfaceContour.h"
#include "gpu/scene/PassTarget.h"
#include "gpu/scene/Scene.h"
#include "gpu/scene/TilePlan.h"

namespace gpu {

class ChunkTextures;
class Palette;
class SlicePass;
class SurfaceBuffers;
class VolumeTextures;

/// The cutting plane as one view sees it, drawn into textures that the ray caster composes with the
/// rest. Nothing is allocated before it is first drawn; then it takes 8 bytes per pixel, and 4 more
/// for the contour.
struct PlanePicture {
    Texture2D colours; ///< RGBA8; alpha is the opacity, 0 where there is no plane
    Texture2D ways; ///< R32F: where a pixel's ray meets it, millimetres along the ray
    Framebuffer frame;
    ContourPicture contour;
    /// Rectangle of drawn pixels outside which nothing of it is seen; may extend beyond the
    /// picture.
    Tile blocks;

    [[nodiscard]] bool isEmpty() const { return blocks.size.x <= 0; }
};

/// Draws the cutting plane (seed B §4.1, §5.1, §5.2) with the ray caster's camera, whether or not
/// something hides it. Each pixel shows what SlicePass shows where the pixel's ray meets the
/// rectangle, including chunks that the scene shows. Over that come its rim and the line where it
/// meets the surface that is being refined.
class PlanePass {
public:
    PlanePass();

    /// Begins a picture, before its first tile: draws the contour, in time linear in the surface.
    /// @param scene has a plane
    /// @param contours null if no contour is drawn
    void begin(PlanePicture& picture, ContourPass* contours, const SurfaceBuffers& surface,
        const VolumeScene& scene, const PassTarget& target);
    /// Draws one tile. Throws ShaderError.
    /// @param chunks of the scene; null if none are drawn
    void draw(PlanePicture& picture, SlicePass& slices, VolumeTextures& volume,
        const VolumeScene& scene, const SegmentDisplay& segments, const Palette& palette,
        const PassTarget& target, const Tile& tile, const VertexArray& noVertices,
        const ChunkTextures* chunks);

private:
    Texture2D m_noContour; ///< one texel
};

} // namespace gpu
