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
    std::array<std::array<std::uint8_t, 4>, 2> marks{}; ///< yellow, green, red at both ends
};

/// What of a surface lies in a plane and within the frame, in no order. Exact but for the rounding
/// to float; what lies in the plane itself counts as just before it, so every contour is closed.
/// Linear in the surface.
[[nodiscard]] std::vector<ContourLine> contourOf(
    const SurfaceBuffers& surface, const SeenPlane& plane, const glm::ivec2& frameSize);

/// The contour of one picture.
struct ContourPicture {
    /// RGBA8: how much of a pixel the line of a mark covers (yellow, green, red), and its rim
    Texture2D cover;
    Framebuffer frame;
    Buffer lines;
    std::optional<VertexArray> array;
    Tile reach; ///< drawn pixels beyond which there is none

    [[nodiscard]] bool isEmpty() const { return reach.size.x <= 0; }
};

/// The line where the surface that is being refined meets a slice's plane, or the cutting plane of
/// a 3D view (seed B §5.2): each pixel by its distance from what the plane cuts of the triangles,
/// so that it is as sharp in any magnification. Where lines meet the nearest counts, not their sum.
class ContourPass {
public:
    /// Throws ShaderError.
    explicit ContourPass(const ShaderLibrary& library);

    /// For a whole picture, before its first tile.
    void draw(ContourPicture& picture, const SurfaceBuffers& surface, const SeenPlane& plane,
        const SceneContour& look, const PassTarget& target);
    /// Lays a tile of it over what is in the bound framebuffer (slices).
    void lay(const ContourPicture& picture, const SceneContour& look, const Tile& tile,
        const VertexArray& noVertices);

private:
    Program m_cover;
    Program m_lay;
};

} // namespace gpu
