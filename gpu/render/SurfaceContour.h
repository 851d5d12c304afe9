// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Buffer.h"
#include "gpu/gl/Framebuffer.h"
#include "gpu/gl/Program.h"
#include "gpu/gl/Texture2D.h"
#include "gpu/gl/VertexArray.h"
#include "gpu/render/parts/SeenPlane.h"
#include "gpu/scene/PassTarget.h"
#include "gpu/scene/Scene.h"
#include "gpu/scene/TilePlan.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace gpu {

class SurfaceBuffers;

/// Where one triangle meets a plane.
struct ContourLine {
    std::array<glm::vec2, 2> pixels{}; ///< frame pixels
    /// Weights of yellow, green and red at both ends.
    std::array<std::array<std::uint8_t, 4>, 2> marks{};
};

/// The lines in which a surface meets a plane within the frame, in no order. Exact except for
/// rounding to float. A vertex in the plane itself counts as just before it, so that every contour
/// is closed. Linear in the surface.
[[nodiscard]] std::vector<ContourLine> contourOf(
    const SurfaceBuffers& surface, const SeenPlane& plane, const glm::ivec2& frameSize);

/// The textures and buffers for the contour of one picture.
struct ContourPicture {
    /// RGBA8: how much of a pixel is covered by the line of each mark (yellow, green, red), and by
    /// its rim
    Texture2D cover;
    Framebuffer frame;
    Buffer lines;
    std::optional<VertexArray> array;
    Tile reach; ///< rectangle of drawn pixels outside which there is no contour

    [[nodiscard]] bool isEmpty() const { return reach.size.x <= 0; }
};

/// Draws the line where the surface that is being refined meets the plane of a slice or the cutting
/// plane of a 3D view (seed B §5.2). Each pixel is drawn by its distance from the lines of
/// contourOf(), so the contour is sharp at any magnification. Where lines meet the nearest one
/// counts, not their sum.
class ContourPass {
public:
    /// Throws ShaderError.
    explicit ContourPass(const ShaderLibrary& library);

    /// Draws a whole picture; call it before its first tile.
    void draw(ContourPicture& picture, const SurfaceBuffers& surface, const SeenPlane& plane,
        const SceneContour& look, const PassTarget& target);
    /// Draws one tile of it over what is in the bound framebuffer (slices).
    void lay(const ContourPicture& picture, const SceneContour& look, const Tile& tile,
        const VertexArray& noVertices);

private:
    Program m_cover;
    Program m_lay;
};

} // namespace gpu
