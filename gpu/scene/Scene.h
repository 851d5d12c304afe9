// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Error.h"
#include "core/brick/BrickGrid.h"
#include "core/refine/mesh/SimplexMesh.h"
#include "core/volume/ClipRegion.h"
#include "core/volume/Volume.h"
#include "gpu/scene/ColourMap.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace gpu {

// What a view shows, as plain data. This header is free of GL: ui fills in the structs. World
// positions are LPS millimetres.

/// A segment drawn as it would be if it had grown from its seeds to a tolerance
/// (core/growth/Tolerance.h).
struct ToleranceDisplay {
    int label = 0;
    int tolerance = 0; ///< in codes
    bool operator==(const ToleranceDisplay&) const = default;
};

/// How the segments are drawn, by label. Where they overlap, slices show all of them, those of
/// higher label planes over those of lower ones, and the 3D view shows the opaque one of the
/// highest plane, or the translucent one of the highest plane if none is opaque.
struct SegmentDisplay {
    std::array<std::uint32_t, 256> rgb{}; ///< 0xRRGGBB
    std::array<bool, 256> visible{};
    /// 0: opaque. In slices it holds for fill and outline. In the 3D view, behind a translucent
    /// segment are seen tissue and opaque segments, but not others that are translucent.
    std::array<std::uint8_t, 256> transparencyPercent{};
    bool voxelTrue = false; ///< bodies in the 3D view are their voxels, not smoothed
    /// The label plane whose growth is shown: its barriers, and its members of later generations.
    std::uint8_t growthPlane = 0;
    /// Members of later generations of that growth are drawn in `warningRgb`; by default none are.
    std::uint32_t warnAfterGeneration = 0xFFFFFFFFu;
    std::uint32_t warningRgb = 0xF0B04A;
    float fillOpacity = 0.35f; ///< of slices
    float outlineWidthPixels = 2.0f; ///< of slices
    /// Shows one segment at a tolerance while the engine has a valid tolerance field of it; else as
    /// it is.
    std::optional<ToleranceDisplay> atTolerance{};
    bool showBarriers = true; ///< voxels closed to growth: stripes in slices, bodies in the 3D view
    /// What an interval suspends (core::CompareGrowth) is striped in slices anyway; here the 3D
    /// view shows it, too, as translucent bodies.
    bool suspendedBodies = false;
    bool operator==(const SegmentDisplay&) const = default;
};

/// Colours of the surface that is being refined: its segment's colour, and over it the colours of
/// the error marks (seed B: locked, boundary, free). They differ in lightness, too.
struct SurfaceColours {
    std::uint32_t rgb = 0xD8DCE2; ///< 0xRRGGBB, of the segment
    std::array<std::uint32_t, 3> markRgb{0xF6D552, 0x3DA564, 0xC4302B}; ///< by core::SurfaceMark
    float markOpacity = 0.8f; ///< of the marks over the segment's colour; 0: none
    float yellowShare = 1.0f; ///< of markOpacity for yellow, which is where nothing was judged
    bool operator==(const SurfaceColours&) const = default;
};

/// The contour where the surface that is being refined (FrameSource::updateSurface()) meets the
/// plane of a slice: a line with a thin dark rim.
struct SceneContour {
    SurfaceColours colours{.markOpacity = 1.0f};
    float widthPixels = 1.5f;
    bool operator==(const SceneContour&) const = default;
};

/// Chunks of a box of the volume (core/chunks), drawn translucent: in slices as areas with a line
/// where two of them touch, in the 3D view as bodies. So is what a growth would take, which is
/// known by cells of several voxels.
struct SceneChunks {
    core::VoxelBox box;
    glm::ivec3 cell{1}; ///< voxels along each axis that are of one chunk, from box.minimum on
    /// By cell of the box, x fastest: 1 + its chunk of the finest division
    /// (core::ChunkTree::leafAt()), 0 if there is none. A changed list must be a new pointer.
    std::shared_ptr<const std::vector<std::uint16_t>> leaves;
    /// Slices draw only voxels with these codes; none: all.
    std::optional<core::CodeRange> codes{};
    /// Colour of each chunk of the finest division, 0xAARRGGBB. AA scales `opacity`; 0: not drawn.
    std::vector<std::uint32_t> argb;
    /// Rim of each of these, 0xAARRGGBB: chunks that are outlined have one, all their voxels the
    /// same, and those that touch different ones. AA 0, or no list: none.
    std::vector<std::uint32_t> rims{};
    float opacity = 0.3f;

    /// How many cells the box has along each axis; the last ones may be cut off.
    [[nodiscard]] glm::ivec3 cells() const { return (box.maximum - box.minimum + cell - 1) / cell; }
};

/// What grey values lie between the centres of voxels. Nearest: the value of the voxel in which a
/// place lies, unchanged. Linear: trilinear. Cubic: tri-cubic (Catmull-Rom) once nothing moves and
/// no edit runs, linear until then.
enum class Interpolation : std::uint8_t { Nearest, Linear, Cubic };
inline constexpr std::size_t interpolations = 3;

/// Which of the values across a slab is shown.
enum class SlabMode { Off, Maximum, Minimum, Mean };

/// A slab about a slice, sampled in even steps along the slice's normal (right × down). Samples
/// outside the volume do not count; nor do carved ones where carving is a hole.
struct SceneSlab {
    SlabMode mode = SlabMode::Off;
    int reach = 0; ///< how many samples lie on either side of the middle one
    double stepMm = 1.0;
    double offsetMm = 0.0; ///< from the slice to the middle sample, along the normal
    bool operator==(const SceneSlab&) const = default;
};

/// One plane through the volume, seen orthographically.
struct SliceScene {
    glm::dvec3 centreLps{0.0}; ///< at the middle of the frame, LPS mm
    glm::dvec3 rightLps{1.0, 0.0, 0.0}; ///< unit vector towards the frame's right
    glm::dvec3 downLps{0.0, 1.0, 0.0}; ///< unit vector towards the frame's bottom
    double mmPerPixel = 1.0;
    core::WindowLevel window;
    bool inverted = false; ///< high values are dark
    ColourMap colours = ColourMap::Grey; ///< of the grey values, after they were inverted
    Interpolation interpolation = Interpolation::Linear; ///< of the grey values alone
    bool showCarved = true; ///< carved voxels as a tinted outline
    bool carvedAsHole = false; ///< carved voxels black; with or without the outline
    std::optional<SceneContour> contour{}; ///< none: not drawn
    /// Of the grey values, which are then linear where they would be cubic; all else is that of the
    /// slice.
    SceneSlab slab{};
    /// Drawn under the segments, their rims over them; null: none. Changed chunks must be a new
    /// pointer.
    std::shared_ptr<const SceneChunks> chunks;
    bool operator==(const SliceScene&) const = default;
};

/// The cutting plane (seed B §4.1, §5.1) in the 3D view: a rectangle that shows what a slice would
/// show there, with segments tinted as in slices.
struct ScenePlane {
    glm::dvec3 centreLps{0.0};
    glm::dvec3 rightLps{1.0, 0.0, 0.0}; ///< unit
    glm::dvec3 downLps{0.0, 1.0, 0.0}; ///< unit vector, perpendicular to rightLps
    glm::dvec2 halfSizeMm{100.0}; ///< along right and down
    core::WindowLevel window;
    bool inverted = false; ///< high values are dark
    ColourMap colours = ColourMap::Grey; ///< as in slices
    Interpolation interpolation = Interpolation::Cubic; ///< as in slices
    float opacity = 1.0f; ///< 0: only the contour is shown
    /// How much of it shines through what hides it, in surface and volume rendering.
    float behindOpacity = 0.0f;
    std::uint32_t rimRgb = 0x5AA9E6; ///< 0xRRGGBB
    float rimWidthPixels = 1.5f; ///< 0: none
    std::optional<SceneContour> contour{}; ///< none: not drawn
    /// The segment whose surface is refined (label), which is reddish here; 0: none.
    int mask = 0;
    bool showCarved = true; ///< carved voxels as a tinted outline
    bool operator==(const ScenePlane&) const = default;
};

/// Mip: the greatest visible value along a ray. Xray: the mean of the visible values along it.
enum class RenderMode : std::uint8_t { Surface, Dvr, Mip, Xray };
inline constexpr std::size_t renderModes = 4;

/// Colour and opacity as functions of the modality value, piecewise linear.
struct TransferFunction {
    struct Point {
        double value = 0.0; ///< modality units
        std::uint32_t rgb = 0xFFFFFF;
        double opacity = 0.0; ///< per millimetre along the ray, 0 … 1
        bool operator==(const Point&) const = default;
    };
    std::vector<Point> points; ///< ascending by value
    bool operator==(const TransferFunction&) const = default;
};

/// How the 3D view draws the context: all of the volume that is in no shown segment. Translucent:
/// as one layer in front of segments and the surface that is refined, with VolumeScene's
/// contextOpacity. CutAway: not in front of them, opaque beside them. Hidden: not at all; segments,
/// pieces of segments, surface and plane are drawn shaded, whatever the mode.
enum class Context : std::uint8_t { Opaque, Translucent, CutAway, Hidden };

/// How the cut face of matter looks where something is carved away or clipped, or where the scan
/// ends: in the transfer function's colours, or grey as in a slice.
enum class CutFaces : std::uint8_t { Material, GreyValues };

/// A part of the volume in a pose of its own (core::Piece), drawn together with the rest in one ray
/// cast; or what a sculpt layer hides only in part, at its own place.
struct ScenePiece {
    int id = 0; ///< of the piece in the document; 0: it has none, and no tool hits it
    int layer = 0; ///< sculpt layer whose coverage it is; 0: it consists of a segment's voxels
    int segment = 0; ///< label
    glm::dmat4 shownFromTrue{1.0}; ///< LPS mm; a rotation, uniform scale and translation
    float opacity = 1.0f; ///< 0: hidden
    /// Volume rendering: from the edge inwards it fades from opaque to `opacity`, over this part (0
    /// … 1) of the range of the radiation.
    float softness = 0.0f;
    std::uint32_t rgb = 0xFFFFFF;
    /// Surface and volume rendering: if true, its whole body has the colour rgb, whatever the
    /// values; else it shows what the scene shows of the values, tinted by rgb.
    bool solid = false;
    TransferFunction transferFunction; ///< its own one for volume rendering; empty: the scene's
    [[nodiscard]] bool showsIn(RenderMode mode) const
    {
        return opacity > 0.0f || (softness > 0.0f && mode == RenderMode::Dvr);
    }
    bool operator==(const ScenePiece&) const = default;
};

/// A seed that waits for a growth, drawn as a smooth dot in its segment's colour.
struct SceneSeed {
    glm::dvec3 lps{0.0};
    std::uint8_t label = 0;
    bool operator==(const SceneSeed&) const = default;
};

/// GreyValues: the volume's values at the surface, through a window. Wireframe: only the edges;
/// those behind are seen between them.
enum class SurfaceStyle : std::uint8_t { Shaded, Wireframe, GreyValues };

/// The surface that is being refined (FrameSource::updateSurface()), drawn together with the matter
/// of the 3D view. If it is translucent its front side is seen. In surface and volume rendering it
/// hides what lies behind it, and matter hides it. In MIP and X-ray, which have no order of depth,
/// it is drawn over the rest.
struct SceneSurface {
    SurfaceStyle style = SurfaceStyle::Shaded;
    SurfaceColours colours;
    float opacity = 1.0f; ///< 0: hidden
    float behindOpacity = 0.25f; ///< how much of it shines through what hides it
    core::WindowLevel window; ///< of grey values
    /// Hides the part on the side that the plane's normal points to, in addition to the clip region
    /// of the scene; the inside is seen then.
    core::ClipPlane clip;
    bool operator==(const SceneSurface&) const = default;
};

/// The 3D view.
struct VolumeScene {
    glm::dvec3 eyeLps{0.0, -500.0, 0.0};
    glm::dvec3 targetLps{0.0};
    glm::dvec3 up{0.0, 0.0, 1.0};
    double heightMm = 300.0; ///< height in the target's plane that the frame shows
    bool orthographic = true; ///< else perspective from eyeLps
    RenderMode mode = RenderMode::Surface;
    double surfaceThreshold = 300.0; ///< modality units
    TransferFunction transferFunction;
    core::WindowLevel mipWindow;
    ColourMap mipColours = ColourMap::Grey; ///< what is black stays black
    core::WindowLevel xrayWindow;
    core::ClipRegion clip; ///< what it hides is not drawn, in any mode
    Context context = Context::Opaque;
    float contextOpacity = 0.3f; ///< of a translucent context; 1 hides as an opaque one does
    CutFaces cutFaces = CutFaces::Material; ///< of surface and volume rendering
    core::WindowLevel faceWindow; ///< of grey cut faces
    std::vector<ScenePiece> pieces; ///< hidden ones too; their order decides nothing
    /// The seeds to draw, in any order; null or empty: none. A changed list must be a new pointer.
    std::shared_ptr<const std::vector<SceneSeed>> seeds;
    std::optional<SceneSurface> surface{}; ///< none: not drawn
    /// The segment whose body is not drawn because its surface is (label); 0: none. Slices show it.
    int bodiless = 0;
    std::optional<ScenePlane> plane{}; ///< none: not drawn
    /// Null: none. Changed chunks must be a new pointer.
    std::shared_ptr<const SceneChunks> chunks;
    /// For one eye of a stereo pair: the eye lies this many millimetres to the right of eyeLps and
    /// looks straight ahead. Both pictures agree in the target's plane.
    double eyeShiftMm = 0.0;
    bool operator==(const VolumeScene&) const = default;
};

using Scene = std::variant<SliceScene, VolumeScene>;

/// Identifies a view during the life of a window.
using ViewId = int;

/// A view's request for a picture of its scene.
struct FrameRequest {
    ViewId view = 0;
    glm::ivec2 sizePixels{0}; ///< device pixels
    Scene scene;
    SegmentDisplay segments;
    bool interacting = false; ///< draw coarse and fast now; refinement waits until false
    /// Nobody waits for a next picture or edit: no shader is compiled ahead for one.
    bool single = false;
};

/// The extent of a piece when a frame was drawn.
struct PieceExtent {
    int id = 0;
    core::VoxelBox filled; ///< at its true place in the volume, rounded to 8 voxels
};

/// A finished picture: RGBA bytes, top row first.
struct Frame {
    enum class Quality : std::uint8_t { Coarse, Full, Refined };
    ViewId view = 0;
    glm::ivec2 sizePixels{0};
    std::shared_ptr<const std::vector<std::uint8_t>> rgba;
    Quality quality = Quality::Coarse;
    double renderMilliseconds = 0.0;
    std::vector<PieceExtent> pieces; ///< the pieces of the scene that have something to show
    Scene scene; ///< what was drawn, so that overlays can be laid over it exactly
    /// Why there is no picture (rgba is null); the view asks again when it wants to.
    std::optional<core::Error> failure{};
};

} // namespace gpu
