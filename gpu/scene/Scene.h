// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"
#include "core/brick/BrickGrid.h"
#include "core/refine/mesh/SimplexMesh.h"
#include "core/volume/ClipRegion.h"
#include "core/volume/Volume.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace gpu {

// What a view wants to see, as plain data. Free of GL: ui fills it in.

/// A segment as it would be if it had grown from its seeds to a tolerance
/// (core/growth/Tolerance.h).
struct ToleranceDisplay {
    int label = 0;
    int tolerance = 0; ///< in codes
    bool operator==(const ToleranceDisplay&) const = default;
};

/// How the segments are drawn, by label.
struct SegmentDisplay {
    std::array<std::uint32_t, 256> rgb{}; ///< 0xRRGGBB
    std::array<bool, 256> visible{};
    /// Members of later generations of the growth are drawn in `warningRgb`; by default none is.
    std::uint32_t warnAfterGeneration = 0xFFFFFFFFu;
    std::uint32_t warningRgb = 0xF0B04A;
    float fillOpacity = 0.35f; ///< of slices
    float outlineWidthPixels = 2.0f; ///< of slices
    /// Of one of them, while the engine has a tolerance field of it; else it is drawn as it is.
    std::optional<ToleranceDisplay> atTolerance{};
    bool showBarriers = true; ///< what is shut to growth: stripes in slices, bodies in the 3D view
    bool operator==(const SegmentDisplay&) const = default;
};

/// Colours of a surface that is being refined: its segment's, and over it those of what is thought
/// of each place. They differ in lightness, too.
struct SurfaceColours {
    std::uint32_t rgb = 0xD8DCE2; ///< 0xRRGGBB, of the segment
    std::array<std::uint32_t, 3> markRgb{0xF6D552, 0x3DA564, 0xC4302B}; ///< by core::SurfaceMark
    float markOpacity = 0.8f; ///< of marks over the rest; 0: none
    bool operator==(const SurfaceColours&) const = default;
};

/// Where the surface that is being refined (FrameSource::updateSurface()) meets a slice's plane: a
/// line over the slice, with a thin dark rim.
struct SceneContour {
    SurfaceColours colours{.markOpacity = 1.0f};
    float widthPixels = 1.5f;
    bool operator==(const SceneContour&) const = default;
};

/// Chunks of a box of the volume (core/chunks), drawn translucent: in slices as areas with a line
/// where two of them touch, in the 3D view as bodies.
struct SceneChunks {
    core::VoxelBox box;
    /// By voxel of the box, x fastest: one more than its chunk of the finest division
    /// (core::ChunkTree::leafAt()), 0 where there is none. Another list is another pointer.
    std::shared_ptr<const std::vector<std::uint16_t>> leaves;
    /// By chunk of the finest division; 0xAARRGGBB, AA: how much of `opacity`, 0: not drawn.
    std::vector<std::uint32_t> argb;
    float opacity = 0.3f;
};

/// One plane through the volume, seen orthographically.
struct SliceScene {
    glm::dvec3 centreLps{0.0}; ///< at the middle of the frame
    glm::dvec3 rightLps{1.0, 0.0, 0.0}; ///< unit, towards the frame's right
    glm::dvec3 downLps{0.0, 1.0, 0.0}; ///< unit, towards the frame's bottom
    double mmPerPixel = 1.0;
    core::WindowLevel window;
    bool inverted = false; ///< dark is high
    bool interpolated = true; ///< false: nearest voxel
    /// Interpolated by cubics through the voxels' values (Catmull-Rom) once nothing moves.
    bool cubic = false;
    bool showCarved = true; ///< carved voxels as a tinted outline
    bool carvedAsHole = false; ///< carved voxels black; with or without the outline
    std::optional<SceneContour> contour{}; ///< none: not drawn
    /// Under the segments; null: none. Others are another pointer.
    std::shared_ptr<const SceneChunks> chunks;
    bool operator==(const SliceScene&) const = default;
};

/// The cutting plane (seed B §4.1, §5.1) in the 3D view: a rectangle that shows what a slice would
/// show there, segments tinted as in slices, among the matter. Cubic once nothing moves.
struct ScenePlane {
    glm::dvec3 centreLps{0.0};
    glm::dvec3 rightLps{1.0, 0.0, 0.0}; ///< unit
    glm::dvec3 downLps{0.0, 1.0, 0.0}; ///< unit, at right angles to it
    glm::dvec2 halfSizeMm{100.0}; ///< along right and down
    core::WindowLevel window;
    bool inverted = false; ///< dark is high
    float opacity = 1.0f; ///< 0: hidden but for the contour
    /// Of what hides it, in surface and volume rendering, it shines through so much.
    float behindOpacity = 0.0f;
    std::uint32_t rimRgb = 0x5AA9E6; ///< 0xRRGGBB
    float rimWidthPixels = 1.5f; ///< 0: none
    std::optional<SceneContour> contour{}; ///< none: not drawn
    bool operator==(const ScenePlane&) const = default;
};

/// Mip: the greatest visible value along a ray. Xray: the mean of the visible values along it.
enum class RenderMode : std::uint8_t { Surface, Dvr, Mip, Xray };
inline constexpr std::size_t renderModes = 4;

/// Colour and opacity over modality values; piecewise linear.
struct TransferFunction {
    struct Point {
        double value = 0.0; ///< modality units
        std::uint32_t rgb = 0xFFFFFF;
        double opacity = 0.0; ///< per millimetre of path, 0 … 1
        bool operator==(const Point&) const = default;
    };
    std::vector<Point> points; ///< ascending by value
    bool operator==(const TransferFunction&) const = default;
};

/// How matter looks that lies open where something is carved away, clipped, or the scan ends:
/// in the transfer function's colours, or grey as in a slice.
enum class CutFaces : std::uint8_t { Material, GreyValues };

/// A part of the volume in a pose of its own (core::Piece), drawn among the rest in one cast; or
/// what a layer hides only in part, at its place.
struct ScenePiece {
    int id = 0; ///< of the document's piece; 0: none, and no tool meets it
    int layer = 0; ///< sculpt layer whose coverage it is; 0: a segment's voxels
    int segment = 0; ///< label
    glm::dmat4 shownFromTrue{1.0}; ///< LPS mm; turns, zooms evenly, moves
    float opacity = 1.0f; ///< 0: hidden
    /// Volume rendering: from its rim inwards it fades from whole to `opacity` over so much of what
    /// radiation reaches, 0 … 1.
    float softness = 0.0f;
    std::uint32_t rgb = 0xFFFFFF;
    /// Surface and volume rendering: its whole body is matter of colour rgb, whatever the values;
    /// else what the scene shows of it, tinted by rgb.
    bool solid = false;
    TransferFunction transferFunction; ///< its own, of volume rendering; empty: the scene's
    [[nodiscard]] bool showsIn(RenderMode mode) const
    {
        return opacity > 0.0f || (softness > 0.0f && mode == RenderMode::Dvr);
    }
    bool operator==(const ScenePiece&) const = default;
};

/// A seed that waits for a growth, drawn as a radiated dot in its segment's colour.
struct SceneSeed {
    glm::dvec3 lps{0.0};
    std::uint8_t label = 0;
    bool operator==(const SceneSeed&) const = default;
};

/// GreyValues: those of the volume at the surface, in a window. Wireframe: the edges alone; those
/// behind are seen between them.
enum class SurfaceStyle : std::uint8_t { Shaded, Wireframe, GreyValues };

/// The surface that is being refined (FrameSource::updateSurface()), drawn among the matter of the
/// 3D view. Of a translucent one the front is seen. Surface and volume rendering: it hides what
/// lies behind it, and matter hides it. MIP and X-ray know no before and behind: it lies over them.
struct SceneSurface {
    SurfaceStyle style = SurfaceStyle::Shaded;
    SurfaceColours colours;
    float opacity = 1.0f; ///< 0: hidden
    float behindOpacity = 0.25f; ///< so much of it shines through what hides it
    core::WindowLevel window; ///< of grey values
    /// Hides what lies on the side that its normal points to, besides the scene's clip region; the
    /// inside is seen then.
    core::ClipPlane clip;
    bool operator==(const SceneSurface&) const = default;
};

/// The 3D view.
struct VolumeScene {
    glm::dvec3 eyeLps{0.0, -500.0, 0.0};
    glm::dvec3 targetLps{0.0};
    glm::dvec3 up{0.0, 0.0, 1.0};
    double heightMm = 300.0; ///< what the frame's height shows in the target's plane
    bool orthographic = true; ///< else perspective from eyeLps
    RenderMode mode = RenderMode::Surface;
    double surfaceThreshold = 300.0; ///< modality units
    TransferFunction transferFunction;
    core::WindowLevel mipWindow;
    core::WindowLevel xrayWindow;
    core::ClipRegion clip; ///< what it hides is not looked at, in any mode
    CutFaces cutFaces = CutFaces::Material; ///< of surface and volume rendering
    core::WindowLevel faceWindow; ///< of grey cut faces
    std::vector<ScenePiece> pieces; ///< hidden ones too; their order decides nothing
    /// Those to be drawn, in any order; null or empty: none. Another list is another pointer.
    std::shared_ptr<const std::vector<SceneSeed>> seeds;
    std::optional<SceneSurface> surface{}; ///< none: not drawn
    std::optional<ScenePlane> plane{}; ///< none: not drawn
    /// Null: none. Others are another pointer.
    std::shared_ptr<const SceneChunks> chunks;
    /// Of one eye of two (stereo): it lies so far to the right of eyeLps, millimetres, and looks
    /// straight ahead; the target's plane is where both pictures agree.
    double eyeShiftMm = 0.0;
    bool operator==(const VolumeScene&) const = default;
};

using Scene = std::variant<SliceScene, VolumeScene>;

/// Names a view for the life of a window.
using ViewId = int;

struct FrameRequest {
    ViewId view = 0;
    glm::ivec2 sizePixels{0}; ///< device pixels
    Scene scene;
    SegmentDisplay segments;
    bool interacting = false; ///< coarse and fast now; refinement waits until false
};

/// What a frame knew of a piece.
struct PieceExtent {
    int id = 0;
    core::VoxelBox filled; ///< at its true place, to 8 voxels
};

/// A finished picture: RGBA bytes, top row first.
struct Frame {
    enum class Quality : std::uint8_t { Coarse, Full, Refined };
    ViewId view = 0;
    glm::ivec2 sizePixels{0};
    std::shared_ptr<const std::vector<std::uint8_t>> rgba;
    Quality quality = Quality::Coarse;
    double renderMilliseconds = 0.0;
    std::vector<PieceExtent> pieces; ///< of those in the scene that have something to show
    Scene scene; ///< what was drawn, so that overlays can be laid over it exactly
    /// Why there is no picture (rgba is null); the view asks again when it wants to.
    std::optional<core::Error> failure{};
};

} // namespace gpu
