// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/edits/kinds/ChunkEdits.h"
#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/SurfaceEdits.h"
#include "core/sculpt/DrillCut.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace core {

struct AddSegment {
    QString name{};
    std::uint32_t rgb = 0;
    CodedConcept code{};
};

/// Rename, recolour, code or lock a segment, or protect it from sculpting; absent fields stay.
struct ChangeSegment {
    int segment = 0; ///< label
    std::optional<QString> name{};
    std::optional<std::uint32_t> rgb{};
    std::optional<CodedConcept> code{};
    std::optional<bool> locked{};
    std::optional<bool> uncarvable{};
};

/// Put a segment at another place of the list.
struct MoveSegment {
    int segment = 0; ///< label
    int place = 0; ///< 1: first; beyond the end: last
};

/// Delete a segment with its voxels, seeds and what has grown from them. Its label is not used
/// again.
struct RemoveSegment {
    int segment = 0; ///< label
};

/// An empty sculpt layer, last in the list.
struct AddLayer {
    QString name{};
};

/// Rename or mute a sculpt layer, or have it count alone; absent fields stay.
struct ChangeLayer {
    int layer = 0; ///< id
    std::optional<QString> name{};
    std::optional<bool> muted{};
    std::optional<bool> solo{};
};

/// Put a sculpt layer at another place of the list.
struct MoveLayer {
    int layer = 0; ///< id
    int place = 0; ///< 1: first; beyond the end: last
};

/// Delete a sculpt layer with what it has carved. Not the only one. Its number is not used again.
struct RemoveLayer {
    int layer = 0; ///< id
};

/// Lay what a layer has carved into another one, by the greater value, and delete it. Both carve,
/// or neither does, so that nothing looks different.
struct MergeLayers {
    int from = 0; ///< id
    int into = 0; ///< id
};

/// The segment that receives voxels: one that is there, or a new one.
struct SegmentChoice {
    std::optional<int> segment{}; ///< label; none: a new one
    QString name{}; ///< of the new one
    std::uint32_t rgb = 0;
};

/// What a layer has carved (coverage ≥ 128) becomes voxels of a segment.
struct LayerToSegment {
    int layer = 0; ///< id
    SegmentChoice target{};
    bool overwriteUnlocked = false;
};

/// What a segment holds is carved, whole.
struct SegmentToLayer {
    int segment = 0; ///< label
    int layer = 0; ///< id
};

/// Hidden are the places with dot(normal, place) > offset: what a clip box or plane hides without
/// carving it.
struct HiddenSide {
    glm::dvec3 normalLps{0.0, 0.0, 1.0}; ///< about a unit vector
    double offsetMm = 0.0;
    bool operator==(const HiddenSide&) const = default;
};
/// What an edit did not see: a cut neither starts nor cuts there.
using HiddenSides = std::optional<std::vector<HiddenSide>>;

/// Segments that a cut leaves as they are, by label, ascending: where they were when it was made.
/// Whoever carries out a cut adds those that are protected (SparedSegments.h), so that the edit
/// names what it reads. A cut that restores spares none.
using SparedSegments = std::optional<std::vector<int>>;

/// "Segment what I see": what is not carved, inside the clip region and within an interval of
/// values becomes voxels of a segment, from wherever one looks.
struct SegmentSeen {
    SegmentChoice target{};
    std::optional<double> lower{}; ///< modality units, inclusive; none: any
    std::optional<double> upper{};
    HiddenSides hidden{};
    bool overwriteUnlocked = false;
};

/// A segment of a mask that was read from a file.
struct ImportedSegment {
    QString name{};
    std::uint32_t rgb = 0;
    CodedConcept code{};
    QByteArray voxels{}; ///< packedRuns() (core/brick/VoxelRuns.h), on the volume's grid
};

/// A segment by the number or the name that a recipe has for it.
struct SegmentWord {
    std::optional<int> number{}; ///< label; none: the name says it
    QString name{};
};

/// The segments of a mask's file become segments here. An edit that is carried out holds their
/// voxels and needs the file no more; one that has none yet is completed by core/masks first. Where
/// segments overlap, the first one has the voxel.
struct ImportMask {
    QString file{};
    std::optional<SegmentWord> as{}; ///< the one that receives all of it; none: new ones
    bool overwriteUnlocked = false;
    std::optional<glm::ivec3> size{}; ///< of the volume
    std::optional<std::vector<ImportedSegment>> segments{};
};

/// Keep a view of the patient by name.
struct AddBookmark {
    QString name{};
    OrthographicView view{}; ///< of the 3D view
    glm::dvec3 crosshairLps{0.0};
};

struct RemoveBookmark {
    int bookmark = 0; ///< id
};

/// Keep a distance that was measured: points at their true places.
struct AddMeasurement {
    glm::dvec3 fromLps{0.0};
    glm::dvec3 toLps{0.0};
    std::optional<int> piece{}; ///< id of the one that both points were picked on
};

struct RemoveMeasurement {
    int measurement = 0; ///< id
};

/// Make what a sculpt layer has cut out a piece, which can be shown elsewhere.
struct CutPiece {
    int layer = 1; ///< id; not of another piece
    QString name{};
    std::optional<glm::dvec3> pivotLps{}; ///< none: the middle of the volume
};

/// Show a segment as a piece of its own, besides where it is.
struct PastePiece {
    int segment = 0; ///< label
    QString name{};
    std::optional<glm::dvec3> pivotLps{};
    PiecePose pose{};
};

/// Rename, move, turn or zoom a piece; absent fields stay.
struct ChangePiece {
    int piece = 0; ///< id
    std::optional<QString> name{};
    std::optional<glm::dvec3> offsetMm{};
    std::optional<glm::dvec3> rotationDegrees{};
    std::optional<double> zoom{};
};

/// Show every piece at its true place and in its true size.
struct SendPiecesHome { };

/// A piece is one no more. What cut it stays cut.
struct RemovePiece {
    int piece = 0; ///< id
};

/// Sketched seeds: the voxels nearest to these points.
struct SeedStroke {
    int segment = 0;
    std::vector<glm::dvec3> pointsLps{};
    /// Seeds that are taken away first, where no growth has accepted them; with as many points,
    /// they are moved.
    std::optional<std::vector<glm::dvec3>> takenLps{};
};

/// A box with sides along the volume's axes, by two opposite corners: it holds the voxels between
/// those nearest to the corners, inclusive.
struct GrowBox {
    glm::dvec3 fromLps{0.0};
    glm::dvec3 toLps{0.0};
    bool operator==(const GrowBox&) const = default;
};

/// Which voxels a growth may enter: all that is given here must hold. Values in modality units.
struct GrowCriteria {
    double lower = 0.0; ///< inclusive
    double upper = 0.0;
    int connectivity = 6; ///< 6, 18 or 26
    /// Narrows the interval, for each segment by itself, to mean ± so many standard deviations
    /// around its seeds.
    std::optional<double> sigmas{};
    /// That is done for each stroke of seeds by itself, and a voxel qualifies where it does for one
    /// of the segment's. Read are the SeedStrokes that stand before this edit.
    std::optional<bool> perStroke{};
    std::optional<double> difference{}; ///< at most so much from the voxel it is reached from
    std::optional<double> gradient{}; ///< magnitude at most, per millimetre
    std::optional<double> gradientDifference{}; ///< of magnitudes, from the voxel before
    std::optional<int> majority{}; ///< so many of the 27 voxels around and at it in the interval
    /// mm: growth goes only where a ball of this diameter can roll to from a seed (Passage.h). One
    /// that holds no voxel but its centre asks nothing.
    std::optional<double> passage{};
    bool onlyVisible = false; ///< not what is carved
    std::optional<GrowBox> box{};
    bool overwriteUnlocked = false;
    bool operator==(const GrowCriteria&) const = default;
};

/// Where a growth stops by itself (LeakGuard.h).
struct GrowGuard {
    /// Where a front that came out of a narrow place is so many times as wide; none: nowhere.
    std::optional<double> factor{};
    double areaMm2 = 60.0; ///< and so much wider
    double backMm = 20.0; ///< how far a narrow place lies back at most
    // Recipes and sessions of before counted voxels and generations: where one of these is given,
    // that is done still, and areaMm2 and backMm are not looked at.
    std::optional<int> voxels{}; ///< instead of areaMm2; none: 60
    std::optional<int> generations{}; ///< instead of backMm; none: 20
    [[nodiscard]] bool countsVoxels() const { return voxels || generations; }
    bool operator==(const GrowGuard&) const = default;
};

struct GrowSteps {
    GrowCriteria criteria{};
    std::optional<int> steps{}; ///< none: to closure
    /// Voxels that the segment held before are told from those that grow over them, so that
    /// shrinking leaves them. False in sessions of schema 3 and before.
    bool tellsHeld = true;
    GrowGuard guard{};
};

/// Give a growth another interval: what qualifies now is recovered, what does not any more is taken
/// back with what hung on it (seed A §5.4).
struct ChangeInterval {
    GrowCriteria criteria{}; ///< with `asBefore` only lower and upper are looked at
    bool asBefore = true; ///< all else as the last growth; false once it is carried out
    /// The growth is taken back to its seeds and made anew; none: where more than one segment
    /// grows, or its criteria are not fixed, which is told once it is carried out.
    std::optional<bool> fromSeeds{};
    /// None: to closure. With `fromSeeds` true counted from the seeds, else from what there is.
    std::optional<int> steps{};
    GrowGuard guard{};
};

/// Go on with the growth before, by its own criteria. Kept as the GrowSteps that it was.
struct ResumeGrowth {
    std::optional<int> steps{}; ///< none: to closure
};

/// Take back what growth added last, generation by generation.
struct ShrinkSteps {
    std::optional<int> steps{}; ///< none, or as many as there are: only the accepted seeds stay
};

/// Take back some places of a growth and what grew through them, cut off where it is narrowest;
/// what is nearer to the seeds stays (GrowthCut.h).
struct ShrinkAt {
    std::vector<glm::dvec3> pointsLps{};
    bool onlyHere = false; ///< only the voxels at the points
    bool barrier = true; ///< the cut is shut
};

/// Shut the neck through which growth came to a place, and take back what lies beyond.
struct PlugLeak {
    glm::dvec3 pointLps{0.0};
};

/// Every voxel of a box goes to the segment that is nearest, by a way on which values change
/// little; seeds are the voxels that segments hold, and those that are sketched.
struct GrowFromSeeds {
    std::optional<std::vector<int>> segments{}; ///< labels that compete; none: all not locked
    std::optional<GrowBox> box{}; ///< none: around the seeds with a margin of a twentieth
    int connectivity = 6; ///< 6, 18 or 26
    /// Modality units: what a millimetre of the way costs; none: a thousandth of the volume's
    /// range.
    std::optional<double> lengthCost{};
    bool overwriteUnlocked = false; ///< segments that do not compete
};

struct PenSample {
    double xMm = 0.0; ///< in the view plane, right of the target
    double yMm = 0.0; ///< up from the target
    double pressure = 1.0; ///< 0 … 1
    double tSeconds = 0.0;
};

/// The outline of a tool's tip, in the view plane (seed A §4.1).
struct MaskShape {
    enum class Kind : std::uint8_t { Circle, Ellipse, Square, Rectangle, Rounded };
    Kind kind = Kind::Circle; ///< unless there is a polygon
    double radiusMm = 8.0; ///< circle
    double widthMm = 16.0; ///< all others; of a square both
    double heightMm = 16.0;
    double cornerMm = 2.0; ///< rounded: radius of its corners
    double rotationDegrees = 0.0; ///< counter-clockwise
    /// Over so much from the edge inwards the depth rises to its full value; 0: a sharp edge.
    double softnessMm = 0.0;
    /// Closed by itself, may cross itself; relative to the sample.
    std::optional<std::vector<glm::dvec2>> polygonMm{};
    bool operator==(const MaskShape&) const = default;
};

struct DrillStroke {
    int layer = 1;
    OrthographicView view{};
    MaskShape mask{};
    DrillMode mode = DrillMode::Limit;
    double depthMm = 8.0; ///< at full pressure; in mode Rate a second
    double floorMm = 30.0; ///< mode Rate: no deeper
    int pressureExponent = 2;
    double surfaceThreshold = 0.0; ///< modality units: what is seen
    bool throughGaps = false;
    /// Parts of the surface that lie so much farther back than the depth are left alone, since they
    /// are seen through a gap; 0: all are cut.
    double guardMm = 0.0;
    bool restore = false; ///< fills again what was carved, from the surface towards the viewer
    /// Resampled by time, so that the device's report rate does not matter. Mode Rate always is.
    bool byTime = true;
    std::vector<PenSample> samples{};
    HiddenSides hidden{};
    SparedSegments spared{};
};

/// As a drill, but the mask stands across the surface and goes in along its normal (seed A §4.3).
struct LaserStroke {
    int layer = 1;
    OrthographicView view{};
    MaskShape mask{};
    DrillMode mode = DrillMode::Limit;
    double depthMm = 15.0; ///< at full pressure; in mode Rate a second
    double floorMm = 30.0; ///< mode Rate: no deeper
    int pressureExponent = 2;
    double surfaceThreshold = 0.0; ///< modality units: what is seen
    bool throughGaps = false;
    bool restore = false;
    bool byTime = true; ///< as DrillStroke's
    std::vector<PenSample> samples{};
    HiddenSides hidden{};
    SparedSegments spared{};
};

/// Where a brush went: all that lies within its radius of the path, which runs straight from point
/// to point.
struct BrushPath {
    enum class Shape {
        Ball,
        Disc, ///< round in a plane, one voxel thick
    };
    double radiusMm = 4.0;
    Shape shape = Shape::Ball;
    std::optional<glm::dvec3> normalLps{}; ///< of a disc's plane, which holds the first point
    std::vector<glm::dvec3> pointsLps{};
    /// Places in pointsLps, ascending: the path does not run to these points but begins anew there.
    std::vector<std::int64_t> lifts{};
};

/// Paints a segment, or erases it, along a path.
struct PaintStroke {
    int segment = 0; ///< label
    BrushPath path{};
    bool erase = false;
    std::optional<double> lower{}; ///< modality units, inclusive; none: any
    std::optional<double> upper{};
    bool overwriteUnlocked = false;
    bool seeds = false; ///< what is painted takes part in growth: it goes on from there
};

/// Shut places to growth, or open them again.
struct BarrierStroke {
    BrushPath path{};
    bool erase = false;
};

/// Carves, or restores what was carved, along a path.
struct BrushStroke {
    int layer = 1;
    BrushPath path{};
    bool restore = false;
    HiddenSides hidden{};
    SparedSegments spared{};
};

/// Takes a shell of even thickness off the part of the surface that a closed curve surrounds.
struct PeelCut {
    int layer = 1;
    OrthographicView view{};
    std::vector<glm::dvec2> polygonMm{}; ///< closed by itself; in the view plane, from the target
    double depthMm = 4.0;
    double surfaceThreshold = 0.0; ///< modality units: what is seen
    bool throughGaps = false;
    /// Where the surface jumps by more than this from one element to the next it is another
    /// surface, and only the largest is peeled; 0: all of them.
    double jumpMm = 4.0;
    bool restore = false;
    HiddenSides hidden{};
    SparedSegments spared{};
};

/// Cuts out what lies under a closed curve, along the view.
struct ScissorsCut {
    int layer = 1;
    OrthographicView view{};
    std::vector<glm::dvec2> polygonMm{}; ///< closed by itself; in the view plane, from the target
    std::optional<double> depthMm{}; ///< below the surface; none: through everything
    bool firstLayerOnly = false; ///< only to the first gap in the material
    double surfaceThreshold = 0.0; ///< modality units: what is seen
    bool restore = false;
    HiddenSides hidden{};
    SparedSegments spared{};
};

/// "Undo only here": takes back older rows of the history and leaves what came after them. Their
/// bricks must not have been written or read since (session/past/RowReach.h).
struct RevertRows {
    std::vector<std::int64_t> rows{}; ///< RowId, ascending
};

/// Changes a cut of the history out of order, or takes it out; what later strokes cut stays
/// (session/operations/ReviseOperation.h). Absent fields are as in that row, whatever revised it
/// before; which of them a cut has, StrokeParameters says (SculptEdits.h).
struct ReviseStroke {
    std::int64_t row = 0; ///< RowId
    std::optional<double> radiusMm{};
    std::optional<double> sideMm{}; ///< of a square mask
    std::optional<double> widthMm{}; ///< of an ellipse, a rectangle or a rounded one
    std::optional<double> heightMm{};
    std::optional<double> factor{}; ///< of a drawn outline: so many times as large
    std::optional<double> depthMm{};
    std::optional<double> softnessMm{};
    std::optional<int> layer{};
    std::optional<bool> throughGaps{};
    bool removed = false;
};

} // namespace core
