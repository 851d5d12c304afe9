// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/RowReach.h"

#include "core/edits/engine/EngineEdits.h"
#include "core/edits/engine/SparedSegments.h"
#include "core/edits/engine/ToolMasks.h"
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

/// What a growth asks of voxels; null for other edits.
const GrowCriteria* criteriaOf(const Edit& edit)
{
    if (const auto* grow = std::get_if<GrowSteps>(&edit))
        return &grow->criteria;
    const auto* interval = std::get_if<ChangeInterval>(&edit);
    return interval ? &interval->criteria : nullptr;
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

/// Of a brush that writes labels and seed words: its way, and the plane; null for other edits.
std::pair<const BrushPath*, std::uint8_t> labelledPath(const Edit& edit, const Document& document)
{
    if (const auto* barrier = std::get_if<BarrierStroke>(&edit))
        return {&barrier->path, document.growths.front().plane};
    const auto* paint = std::get_if<PaintStroke>(&edit);
    if (!paint)
        return {nullptr, std::uint8_t(0)};
    const Segment* segment = document.segment(paint->segment);
    return {&paint->path, segment ? segment->plane : std::uint8_t(0)};
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

RowReach::SweptMask RowReach::sweptOutline(const MaskFrame& frame, const BrickGrid& grid,
    const std::vector<glm::dvec2>& outline, const RowTrace& trace)
{
    glm::dvec2 low = outline.front();
    glm::dvec2 high = low;
    for (const glm::dvec2& point : outline) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    return sweptMask(frame, grid, {(low + high) / 2.0}, glm::length(high - low) / 2.0, trace);
}

RowReach::RowReach(const Edit& edit, const Document& document, const std::vector<BrickKey>& written,
    const RowTrace& trace)
{
    const BrickGrid grid{document.volumes.front().geometry.size};
    const SparedSegments* spared = sparedBy(edit);
    std::optional<std::uint8_t> labelsRead;
    if (spared && *spared)
        labelsRead = sparedLabels(*spared, document).plane;
    if (const auto* seed = std::get_if<SeedStroke>(&edit)) {
        Bricks bricks;
        const Segment* segment = document.segment(seed->segment);
        const std::uint8_t plane = segment ? segment->plane : std::uint8_t(0);
        std::vector<glm::dvec3> points = seed->pointsLps;
        if (seed->takenLps)
            points.insert(points.end(), seed->takenLps->begin(), seed->takenLps->end());
        if (const auto voxels = seedVoxels(points, document.volumes.front().geometry)) {
            for (const glm::ivec3& voxel : *voxels)
                bricks.keys.insert({Field::SeedWords, plane, std::uint32_t(grid.brickOf(voxel))});
        }
        m_reach = std::move(bricks);
    } else if (const GrowCriteria* asked = criteriaOf(edit); asked && trace.grownBeside) {
        m_reach = Growth{.plane = document.growths.front().plane,
            .coverage = asked->onlyVisible,
            .beside = *trace.grownBeside};
    } else if (const GrowCriteria* criteria = criteriaOf(edit); criteria && criteria->onlyVisible) {
        Fields fields{.plane = document.growths.front().plane, .layers = {}};
        fields.layers.set();
        m_reach = fields;
    } else if (std::holds_alternative<GrowSteps>(edit) || std::holds_alternative<ShrinkSteps>(edit)
        || std::holds_alternative<ShrinkAt>(edit) || std::holds_alternative<PlugLeak>(edit)
        || std::holds_alternative<RemoveSegment>(edit)
        || std::holds_alternative<ChangeInterval>(edit)
        || std::holds_alternative<GrowFromSeeds>(edit) || std::holds_alternative<WriteBack>(edit)
        || std::holds_alternative<SurfaceBarrier>(edit)) {
        m_reach = Plane{document.growths.front().plane};
    } else if (const auto* drill = std::get_if<DrillStroke>(&edit)) {
        std::vector<glm::dvec2> path;
        for (const PenSample& sample : drill->samples)
            path.emplace_back(sample.xMm, sample.yMm);
        if (const Result<DrillCut> cut = drillCut(*drill, document))
            m_reach = sweptMask(cut->frame, grid, std::move(path), drillReachMm(*cut), trace);
    } else if (const auto* laser = std::get_if<LaserStroke>(&edit)) {
        std::vector<glm::dvec2> path;
        for (const PenSample& sample : laser->samples)
            path.emplace_back(sample.xMm, sample.yMm);
        if (const Result<LaserCut> cut = laserCut(*laser, document))
            m_reach = sweptMask(cut->frame, grid, std::move(path), laserReachMm(*cut), trace);
    } else if (const auto* peel = std::get_if<PeelCut>(&edit)) {
        if (const Result<MaskPeel> cut = maskPeel(*peel, document))
            m_reach = sweptOutline(cut->frame, grid, peel->polygonMm, trace);
    } else if (const auto* scissors = std::get_if<ScissorsCut>(&edit)) {
        if (const Result<MaskScissors> cut = maskScissors(*scissors, document))
            m_reach = sweptOutline(cut->frame, grid, scissors->polygonMm, trace);
    } else if (const auto [path, plane] = labelledPath(edit, document); path) {
        Bricks bricks;
        const VolumeGeometry& geometry = document.volumes.front().geometry;
        if (const auto frame = capsuleFrame(*path, geometry, {})) {
            for (const std::uint32_t brick : bricksUnder(*path, *frame, geometry)) {
                bricks.keys.insert({Field::Labels, plane, brick});
                bricks.keys.insert({Field::SeedWords, plane, brick});
                bricks.keys.insert({Field::Beneath, plane, brick});
            }
        }
        m_reach = std::move(bricks);
    } else if (const auto* mask = std::get_if<ImportMask>(&edit)) {
        Bricks bricks;
        if (const Result<LabelListed> listed = labelListed(*mask, document)) {
            for (const LabelListed::Brick& brick : listed->bricks) {
                bricks.keys.insert({Field::Labels, listed->plane, brick.brick});
                bricks.keys.insert({Field::SeedWords, listed->plane, brick.brick});
            }
        }
        m_reach = std::move(bricks);
    } else if (const auto* toggle = std::get_if<ChunkToggle>(&edit)) {
        Bricks bricks;
        const Segment* segment = document.segment(toggle->segment);
        const std::uint8_t planeOfLabel = segment ? segment->plane : std::uint8_t(0);
        for (const std::int64_t brick : toggle->bricks.value_or(std::vector<std::int64_t>())) {
            bricks.keys.insert({Field::Labels, planeOfLabel, std::uint32_t(brick)});
            bricks.keys.insert({Field::SeedWords, planeOfLabel, std::uint32_t(brick)});
        }
        m_reach = std::move(bricks);
    } else if (const auto* brush = std::get_if<BrushStroke>(&edit)) {
        Bricks bricks;
        const VolumeGeometry& geometry = document.volumes.front().geometry;
        if (const auto frame = capsuleFrame(brush->path, geometry, {})) {
            for (const std::uint32_t brick : bricksUnder(brush->path, *frame, geometry)) {
                bricks.keys.insert({Field::Coverage, std::uint8_t(brush->layer), brick});
                if (labelsRead)
                    bricks.keys.insert({Field::Labels, *labelsRead, brick});
            }
        }
        m_reach = std::move(bricks);
    } else if (std::optional<Fields> fields = wholeFields(edit, document)) {
        m_reach = *fields;
    } else {
        m_reach = Bricks{{written.begin(), written.end()}};
    }
    if (auto* mask = std::get_if<SweptMask>(&m_reach))
        mask->labels = labelsRead;
}

std::optional<RowReach::Fields> RowReach::wholeFields(const Edit& edit, const Document& document)
{
    const auto planeOf = [&document](std::optional<int> label) {
        const Segment* segment = label ? document.segment(*label) : nullptr;
        return segment ? segment->plane : std::uint8_t(0);
    };
    Fields fields;
    if (const auto* carved = std::get_if<LayerToSegment>(&edit)) {
        fields.plane = planeOf(carved->target.segment);
        fields.layers.set(std::size_t(carved->layer));
    } else if (const auto* seen = std::get_if<SegmentSeen>(&edit)) {
        fields.plane = planeOf(seen->target.segment);
        fields.layers.set();
    } else if (const auto* covered = std::get_if<SegmentToLayer>(&edit)) {
        fields.plane = planeOf(covered->segment);
        fields.layers.set(std::size_t(covered->layer));
    } else if (const auto* merge = std::get_if<MergeLayers>(&edit)) {
        fields.layers.set(std::size_t(merge->from)).set(std::size_t(merge->into));
    } else if (const auto* remove = std::get_if<RemoveLayer>(&edit)) {
        fields.layers.set(std::size_t(remove->layer));
    } else {
        return std::nullopt;
    }
    return fields;
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
