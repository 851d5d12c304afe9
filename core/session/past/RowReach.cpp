// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/RowReach.h"

#include "core/edits/engine/EngineEdits.h"
#include "core/edits/engine/SparedSegments.h"
#include "core/edits/kinds/AnyEdit.h"
#include "core/edits/kinds/IsOneOf.h"
#include "core/edits/kinds/sculpt/ToolMasks.h"
#include "core/edits/sculpt/SculptEdits.h"
#include "core/sculpt/Radiation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace core {

namespace {

/// The point of a segment that lies nearest.
glm::dvec2 nearestOn(const glm::dvec2& from, const glm::dvec2& to, const glm::dvec2& point)
{
    const glm::dvec2 along = to - from;
    const double squared = glm::dot(along, along);
    const double t =
        squared > 0.0 ? std::clamp(glm::dot(point - from, along) / squared, 0.0, 1.0) : 0.0;
    return from + t * along;
}

glm::dvec3 millimetres(const Fixed3& fixed30)
{
    return glm::dvec3(double(fixed30[0]), double(fixed30[1]), double(fixed30[2])) / 1073741824.0;
}

/// How far a drill's mask lies from the sample at most.
double drillReachMm(const DrillCut& cut)
{
    const glm::ivec2 corner =
        glm::max(glm::abs(cut.mask.first), glm::abs(cut.mask.first + cut.mask.size));
    return std::max(double(cut.maskRadius), cut.frame.pitch * glm::length(glm::dvec2(corner)))
        / 65536.0;
}

/// The bricks under a brush.
std::set<std::uint32_t> bricksUnder(
    const BrushPath& path, const CapsuleFrame& frame, const VolumeGeometry& geometry)
{
    std::set<std::uint32_t> under;
    for (const Capsule& capsule : capsules(path, geometry)) {
        const std::vector<std::uint32_t> near =
            bricksNear(frame, capsule, BrickGrid{geometry.size});
        under.insert(near.begin(), near.end());
    }
    return under;
}

} // namespace

RowReach::SweptMask RowReach::sweptMask(const MaskFrame& frame, const BrickGrid& grid,
    std::vector<glm::dvec2> path, double maskReachMm, const RowTrace& trace)
{
    SweptMask mask;
    mask.grid = grid;
    mask.origin = millimetres(frame.planeOrigin);
    mask.perVoxel = glm::dmat3(
        millimetres(frame.planePerI), millimetres(frame.planePerJ), millimetres(frame.planePerK));
    mask.path = std::move(path);
    // Samples lie anywhere in their element, a mask's edge is smoothed across one more, and a voxel
    // belongs to the element that its middle lies in.
    const double pitchMm = frame.pitch / 65536.0;
    mask.reachMm = maskReachMm + 4.0 * pitchMm;
    // The first material ends the search; from there a cut, and what it asks about gaps, goes no
    // deeper than maxDepth. A laser's beam leans and looks around: no farther than it reaches.
    mask.endMm = trace.searchedTo && !frame.restore
        ? (double(*trace.searchedTo) + frame.maxDepth + 2.0 * frame.zPerSample
              + 2.0 * frame.rampHalfWidth)
                / 65536.0
            + mask.reachMm
        : std::numeric_limits<double>::infinity();
    return mask;
}

/// What the result of each kind of edit depends on: one that is not told of does not compile.
class RowReach::Kinds {
public:
    const Document& document;
    const std::vector<BrickKey>& written;
    const RowTrace& trace;
    std::optional<std::uint8_t> labelsRead; ///< the plane of what is spared

    Reach operator()(const SeedStroke& seed) const
    {
        std::vector<glm::dvec3> points = seed.pointsLps;
        if (seed.takenLps)
            points.insert(points.end(), seed.takenLps->begin(), seed.takenLps->end());
        Bricks bricks;
        if (const auto voxels = seedVoxels(points, geometry())) {
            for (const glm::ivec3& voxel : *voxels)
                bricks.keys.insert({Field::SeedWords, planeOf(seed.segment),
                    std::uint32_t(grid().brickOf(voxel))});
        }
        return bricks;
    }

    Reach operator()(const GrowSteps& grow) const { return asked(grow.criteria); }
    Reach operator()(const ChangeInterval& change) const { return asked(change.criteria); }
    /// Growths that go by the whole plane.
    template <class E>
    requires isOneOf<E, ResumeGrowth, ShrinkSteps, ShrinkAt, PlugLeak, RemoveSegment, GrowFromSeeds,
        WriteBack, SurfaceBarrier>
        Reach operator()(const E&) const
    {
        return wholeGrowth();
    }

    Reach operator()(const DrillStroke& drill) const
    {
        const Result<DrillCut> cut = drillCut(drill, document);
        return cut ? swept(cut->frame, pathOf(drill.samples), drillReachMm(*cut)) : nothing();
    }
    Reach operator()(const LaserStroke& laser) const
    {
        const Result<LaserCut> cut = laserCut(laser, document);
        return cut ? swept(cut->frame, pathOf(laser.samples), laserReachMm(*cut)) : nothing();
    }
    Reach operator()(const PeelCut& peel) const
    {
        const Result<MaskPeel> cut = maskPeel(peel, document);
        return cut ? sweptOutline(cut->frame, peel.polygonMm) : nothing();
    }
    Reach operator()(const ScissorsCut& scissors) const
    {
        const Result<MaskScissors> cut = maskScissors(scissors, document);
        return cut ? sweptOutline(cut->frame, scissors.polygonMm) : nothing();
    }

    Reach operator()(const PaintStroke& paint) const
    {
        return labelled(paint.path, planeOf(paint.segment));
    }
    Reach operator()(const BarrierStroke& barrier) const
    {
        return labelled(barrier.path, growthPlane());
    }
    Reach operator()(const BrushStroke& brush) const
    {
        Bricks bricks;
        for (const std::uint32_t brick : under(brush.path)) {
            bricks.keys.insert({Field::Coverage, std::uint8_t(brush.layer), brick});
            if (labelsRead)
                bricks.keys.insert({Field::Labels, *labelsRead, brick});
        }
        return bricks;
    }

    Reach operator()(const ImportMask& mask) const
    {
        Bricks bricks;
        if (const Result<LabelListed> listed = labelListed(mask, document)) {
            for (const LabelListed::Brick& brick : listed->bricks) {
                bricks.keys.insert({Field::Labels, listed->plane, brick.brick});
                bricks.keys.insert({Field::SeedWords, listed->plane, brick.brick});
            }
        }
        return bricks;
    }
    Reach operator()(const ChunkToggle& toggle) const
    {
        Bricks bricks;
        const std::uint8_t plane = planeOf(toggle.segment);
        for (const std::int64_t brick : toggle.bricks.value_or(std::vector<std::int64_t>())) {
            bricks.keys.insert({Field::Labels, plane, std::uint32_t(brick)});
            bricks.keys.insert({Field::SeedWords, plane, std::uint32_t(brick)});
        }
        return bricks;
    }

    Reach operator()(const LayerToSegment& carved) const
    {
        Fields fields{.plane = planeOf(carved.target.segment.value_or(0)), .layers = {}};
        fields.layers.set(std::size_t(carved.layer));
        return fields;
    }
    Reach operator()(const SegmentSeen& seen) const
    {
        Fields fields{.plane = planeOf(seen.target.segment.value_or(0)), .layers = {}};
        fields.layers.set();
        return fields;
    }
    Reach operator()(const SegmentToLayer& covered) const
    {
        Fields fields{.plane = planeOf(covered.segment), .layers = {}};
        fields.layers.set(std::size_t(covered.layer));
        return fields;
    }
    Reach operator()(const MergeLayers& merge) const
    {
        Fields fields;
        fields.layers.set(std::size_t(merge.from)).set(std::size_t(merge.into));
        return fields;
    }
    Reach operator()(const RemoveLayer& remove) const
    {
        Fields fields;
        fields.layers.set(std::size_t(remove.layer));
        return fields;
    }

    /// What they took back, or folded anew.
    template <class E>
    requires isOneOf<E, RevertRows, ReviseStroke> Reach operator()(const E&) const
    {
        return whatWasWritten();
    }
    /// They write no voxel.
    template <class E>
    requires isOneOf<E, AddSegment, ChangeSegment, MoveSegment, AddLayer, ChangeLayer, MoveLayer,
        AddBookmark, RemoveBookmark, AddMeasurement, RemoveMeasurement, CutPiece, PastePiece,
        ChangePiece, SendPiecesHome, RemovePiece, Chunks, LaySurface, DropSurface, FollowMask,
        MarkSurface, ChangeMarks, SpherePush, PlaneScrape, PointDrag, ApplyTemplate, SmoothSurface,
        AttractSurface>
        Reach operator()(const E&) const
    {
        return whatWasWritten();
    }

private:
    [[nodiscard]] const VolumeGeometry& geometry() const
    {
        return document.volumes.front().geometry;
    }
    [[nodiscard]] BrickGrid grid() const { return BrickGrid{geometry().size}; }
    [[nodiscard]] std::uint8_t planeOf(int label) const
    {
        const Segment* segment = document.segment(label);
        return segment ? segment->plane : std::uint8_t(0);
    }
    [[nodiscard]] std::uint8_t growthPlane() const { return document.growths.front().plane; }
    /// Of a cut that could not be worked out.
    [[nodiscard]] static Reach nothing() { return Bricks(); }
    [[nodiscard]] Reach whatWasWritten() const { return Bricks{{written.begin(), written.end()}}; }
    [[nodiscard]] Reach wholeGrowth() const { return Plane{growthPlane()}; }

    [[nodiscard]] Reach asked(const GrowCriteria& criteria) const
    {
        if (trace.grownBeside)
            return Growth{.plane = growthPlane(),
                .coverage = criteria.onlyVisible,
                .beside = *trace.grownBeside};
        if (!criteria.onlyVisible)
            return wholeGrowth();
        Fields fields{.plane = growthPlane(), .layers = {}};
        fields.layers.set();
        return fields;
    }
    [[nodiscard]] Reach swept(
        const MaskFrame& frame, std::vector<glm::dvec2> path, double maskReachMm) const
    {
        SweptMask mask = sweptMask(frame, grid(), std::move(path), maskReachMm, trace);
        mask.labels = labelsRead;
        return mask;
    }
    [[nodiscard]] Reach sweptOutline(
        const MaskFrame& frame, const std::vector<glm::dvec2>& outline) const
    {
        glm::dvec2 low = outline.front();
        glm::dvec2 high = low;
        for (const glm::dvec2& point : outline) {
            low = glm::min(low, point);
            high = glm::max(high, point);
        }
        return swept(frame, {(low + high) / 2.0}, glm::length(high - low) / 2.0);
    }
    [[nodiscard]] static std::vector<glm::dvec2> pathOf(const std::vector<PenSample>& samples)
    {
        std::vector<glm::dvec2> path;
        for (const PenSample& sample : samples)
            path.emplace_back(sample.xMm, sample.yMm);
        return path;
    }
    /// The bricks under a brush.
    [[nodiscard]] std::set<std::uint32_t> under(const BrushPath& path) const
    {
        const auto frame = capsuleFrame(path, geometry(), {});
        return frame ? bricksUnder(path, *frame, geometry()) : std::set<std::uint32_t>();
    }
    [[nodiscard]] Reach labelled(const BrushPath& path, std::uint8_t plane) const
    {
        Bricks bricks;
        for (const std::uint32_t brick : under(path)) {
            for (const Field field : {Field::Labels, Field::SeedWords, Field::Beneath})
                bricks.keys.insert({field, plane, brick});
        }
        return bricks;
    }
};

RowReach::RowReach(const Edit& edit, const Document& document, const std::vector<BrickKey>& written,
    const RowTrace& trace)
{
    const SparedSegments* spared = sparedBy(edit);
    std::optional<std::uint8_t> labelsRead;
    if (spared && *spared)
        labelsRead = sparedLabels(*spared, document).plane;
    m_reach = visitEdit(
        Kinds{.document = document, .written = written, .trace = trace, .labelsRead = labelsRead},
        edit);
}

bool RowReach::covers(const BrickKey& key) const
{
    return std::visit([&key](const auto& reach) { return covers(reach, key); }, m_reach);
}

bool RowReach::covers(const Bricks& bricks, const BrickKey& key)
{
    return bricks.keys.count(key) != 0;
}

bool RowReach::covers(const Plane& plane, const BrickKey& key)
{
    return key.field != Field::Coverage && key.plane == plane.plane;
}

bool RowReach::covers(const Growth& growth, const BrickKey& key)
{
    const bool isAsked = key.field == Field::Coverage ? growth.coverage : key.plane == growth.plane;
    const bool isOfMembers = key.field == Field::SeedWords || key.field == Field::Beneath;
    return isAsked && (isOfMembers || growth.beside.count(key.brick) != 0);
}

bool RowReach::covers(const Fields& fields, const BrickKey& key)
{
    return key.field == Field::Coverage ? fields.layers[key.plane] : fields.plane == key.plane;
}

bool RowReach::covers(const SweptMask& mask, const BrickKey& key)
{
    const bool isRead =
        key.field == Field::Coverage || (key.field == Field::Labels && mask.labels == key.plane);
    if (!isRead || mask.path.empty())
        return false;
    // Radiation at a position is interpolated between the voxels around it, and theirs depends on
    // coverage no farther than radiation::reach.
    constexpr double halfSide = BrickGrid::side / 2.0 + radiation::reach + 1.0;
    const glm::dvec3 middle = glm::dvec3(mask.grid.brickPosition(int(key.brick)) * BrickGrid::side)
        + (BrickGrid::side - 1) / 2.0;
    const glm::dvec3 place = mask.origin + mask.perVoxel * middle;
    double nearestMm = place.z;
    for (int axis = 0; axis < 3; ++axis)
        nearestMm -= halfSide * std::abs(mask.perVoxel[axis].z);
    if (nearestMm > mask.endMm)
        return false;
    // A brick, seen along the view, is convex, and so is each piece of the path: where they keep
    // apart along the line between their nearest points, they keep apart.
    for (std::size_t i = 0; i < mask.path.size(); ++i) {
        const glm::dvec2 nearest = nearestOn(
            mask.path[i], mask.path[std::min(i + 1, mask.path.size() - 1)], glm::dvec2(place));
        const glm::dvec2 away = glm::dvec2(place) - nearest;
        const double distance = glm::length(away);
        double halfWidth = 0.0;
        for (int axis = 0; axis < 3 && distance > 0.0; ++axis)
            halfWidth +=
                halfSide * std::abs(glm::dot(glm::dvec2(mask.perVoxel[axis]), away)) / distance;
        if (distance - halfWidth <= mask.reachMm)
            return true;
    }
    return false;
}

} // namespace core
