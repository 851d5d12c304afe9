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

/// The cutting plane as one view sees it, for the ray caster to lay among the rest. Nothing is kept
/// before it is first drawn; then 8 bytes a pixel, and 4 for the contour.
struct PlanePicture {
    Texture2D colours; ///< RGBA8; a: opacity; 0: none
    Texture2D ways; ///< R32F: where a pixel's ray meets it, millimetres along the ray
    Framebuffer frame;
    ContourPicture contour;
    Tile blocks; ///< drawn pixels beyond which nothing of it is seen; may reach beyond the picture

    [[nodiscard]] bool isEmpty() const { return blocks.size.x <= 0; }
};

/// Draws the cutting plane (seed B §4.1, §5.1, §5.2) with the ray caster's camera, whatever hides
/// it: in each pixel what SlicePass shows where the pixel's ray meets the rectangle, chunks that
/// the scene shows included, its rim, and over both the line where the surface that is being
/// refined meets it.
class PlanePass {
public:
    PlanePass();

    /// Begins a picture, before its first tile: draws the contour, which is linear in the surface.
    /// @param scene has a plane @param contours null: none is drawn
    void begin(PlanePicture& picture, ContourPass* contours, const SurfaceBuffers& surface,
        const VolumeScene& scene, const PassTarget& target);
    /// Draws a tile of it. Throws ShaderError. @param chunks of the scene; null: none to be drawn
    void draw(PlanePicture& picture, SlicePass& slices, VolumeTextures& volume,
        const VolumeScene& scene, const SegmentDisplay& segments, const Palette& palette,
        const PassTarget& target, const Tile& tile, const VertexArray& noVertices,
        const ChunkTextures* chunks);

private:
    Texture2D m_noContour; ///< one texel
};

} // namespace gpu
