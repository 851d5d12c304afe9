// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/HistoryTruth.h"

#include "core/edits/EditJson.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/engine/HalfSpaces.h"
#include "core/edits/kinds/filling/MirrorSegment.h"
#include "core/edits/kinds/filling/SegmentScissors.h"
#include "core/edits/kinds/filling/SketchPlanes.h"
#include "core/edits/kinds/growth/BarrierStroke.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/GrowFromSeeds.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/growth/PlugLeak.h"
#include "core/edits/kinds/growth/SeedStroke.h"
#include "core/edits/kinds/growth/ShrinkAt.h"
#include "core/edits/kinds/growth/ShrinkSteps.h"
#include "core/edits/kinds/history/RevertRows.h"
#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/edits/kinds/imports/ImportMask.h"
#include "core/edits/kinds/layers/AddLayer.h"
#include "core/edits/kinds/layers/ChangeLayer.h"
#include "core/edits/kinds/layers/MergeLayers.h"
#include "core/edits/kinds/layers/MoveLayer.h"
#include "core/edits/kinds/layers/RemoveLayer.h"
#include "core/edits/kinds/layers/SegmentToLayer.h"
#include "core/edits/kinds/parts/SegmentChoice.h"
#include "core/edits/kinds/pieces/ChangePiece.h"
#include "core/edits/kinds/pieces/CutPiece.h"
#include "core/edits/kinds/pieces/PastePiece.h"
#include "core/edits/kinds/pieces/RemovePiece.h"
#include "core/edits/kinds/sculpt/DrillPathSampler.h"
#include "core/edits/kinds/segments/AddSegment.h"
#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/edits/kinds/segments/CombineSegments.h"
#include "core/edits/kinds/segments/FillOutline.h"
#include "core/edits/kinds/segments/InvertSegment.h"
#include "core/edits/kinds/segments/LayerToSegment.h"
#include "core/edits/kinds/segments/MoveSegment.h"
#include "core/edits/kinds/segments/PaintStroke.h"
#include "core/edits/kinds/segments/RemoveSegment.h"
#include "core/edits/kinds/segments/ReshapeSegment.h"
#include "core/edits/kinds/segments/SegmentSeen.h"
#include "core/edits/kinds/splitting/LineAcross.h"
#include "core/edits/kinds/values/ThresholdSegment.h"
#include "core/edits/kinds/views/Bookmarks.h"
#include "core/edits/kinds/views/Measurements.h"
#include "core/edits/sculpt/SculptVisit.h"
#include "core/engine/EngineCommands.h"
#include "core/growth/SeedWord.h"
#include "core/sculpt/labels/HeldVoxels.h"
#include "core/sessionfile/records/StateHash.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/reference/filling/BetweenPlanes.h"
#include "tests/reference/filling/BetweenSlices.h"
#include "tests/reference/filling/Contour.h"
#include "tests/reference/filling/FloodFill.h"
#include "tests/reference/sculpt/ElementPlane.h"
#include "tests/reference/sculpt/LayerWrites.h"
#include "tests/support/cases/IslandTruth.h"

#include <QJsonDocument>

#include <algorithm>

namespace test {

using namespace core;

namespace {

constexpr int greatestLayer = 8;
constexpr std::uint8_t truthLayer = 200; ///< where one cut is made alone

/// All that an engine holds, empty bricks left out.
/// @param planes the number of label planes; to ask for one more would bring it into use
std::map<BrickKey, std::vector<std::uint8_t>> everything(
    EditEngine& engine, const glm::ivec3& size, int planes)
{
    ReadBricks read;
    const int bricks = BrickGrid{size}.brickCount();
    const auto ask = [&read, bricks](Field field, int plane) {
        for (int brick = 0; brick < bricks; ++brick)
            read.keys.push_back({field, std::uint8_t(plane), std::uint32_t(brick)});
    };
    for (int layer = 1; layer <= greatestLayer; ++layer)
        ask(Field::Coverage, layer);
    for (int plane = 0; plane < planes; ++plane) {
        ask(Field::Labels, plane);
        ask(Field::SeedWords, plane);
        ask(Field::Overwritten, plane);
    }
    const Ticket ticket = engine.submit(std::move(read));
    engine.finish();
    std::map<BrickKey, std::vector<std::uint8_t>> found;
    for (const EngineResult& result : engine.collect()) {
        for (const BrickChange& brick : result.changes) {
            if (result.ticket == ticket && !brick.after.empty())
                found[brick.key] = brick.after.read();
        }
    }
    return found;
}

/// Bricks without a label and its seeds.
std::map<BrickKey, std::vector<std::uint8_t>> withoutLabel(
    std::map<BrickKey, std::vector<std::uint8_t>> bricks, int label)
{
    for (auto& [key, bytes] : bricks) {
        if (key.field == Field::Labels || key.field == Field::Overwritten)
            std::replace(bytes.begin(), bytes.end(), std::uint8_t(label), std::uint8_t(0));
        for (std::size_t i = 0; key.field == Field::SeedWords && i < bytes.size(); i += 4) {
            // Bits 12 … 5 of a word; all ones is an empty voxel.
            const int bears = (bytes[i] | bytes[i + 1] << 8) >> 5 & 0xFF;
            const auto word = bytes.begin() + std::ptrdiff_t(i);
            if (bears == label
                && !std::all_of(word, word + 4, [](int byte) { return byte == 0xFF; }))
                std::fill(word, word + 4, std::uint8_t(0xFF));
        }
    }
    std::erase_if(bricks, [](const auto& each) {
        const std::uint8_t empty = emptyByte(each.first.field);
        return std::all_of(each.second.begin(), each.second.end(),
            [empty](std::uint8_t byte) { return byte == empty; });
    });
    return bricks;
}

/// Whether it writes labels or seed words.
bool changesLabels(const Edit& edit)
{
    return edit.is<SeedStroke>() || edit.is<GrowSteps>() || edit.is<ChangeInterval>()
        || edit.is<ShrinkSteps>() || edit.is<ShrinkAt>() || edit.is<PlugLeak>()
        || edit.is<BarrierStroke>() || edit.is<GrowFromSeeds>() || edit.is<PaintStroke>()
        || edit.is<RemoveSegment>() || edit.is<LayerToSegment>() || edit.is<SegmentSeen>()
        || edit.is<ImportMask>() || edit.is<InvertSegment>() || edit.is<CombineSegments>()
        || edit.is<CleanSegment>() || edit.is<FillOutline>() || edit.is<ReshapeSegment>()
        || edit.is<FillBetweenSlices>() || edit.is<FloodFill>() || edit.is<ThresholdSegment>()
        || edit.is<SegmentScissors>() || edit.is<MirrorSegment>() || edit.is<EvolveContour>()
        || edit.is<SplitIslands>() || edit.is<SplitSegment>() || edit.is<CopySegment>()
        || edit.is<SplitByCurve>();
}

bool isOf(const BrickKey& key, bool coverage)
{
    return (key.field == Field::Coverage) == coverage;
}

/// Whom it gives to and what it may change; not which voxels are meant.
RelabelListed withoutBricks(Result<RelabelListed> relabel)
{
    RelabelListed like = std::move(relabel).value();
    like.bricks.clear();
    return like;
}

/// Of a member of a plane.
std::uint32_t greatestGeneration(
    const std::map<BrickKey, std::vector<std::uint8_t>>& bricks, int plane)
{
    std::uint32_t greatest = 0;
    for (const auto& [key, bytes] : bricks) {
        const bool isMeant = key.field == Field::SeedWords && key.plane == plane;
        for (std::size_t i = 0; isMeant && i < bytes.size(); i += 4) {
            const std::uint32_t word = std::uint32_t(bytes[i]) | std::uint32_t(bytes[i + 1]) << 8
                | std::uint32_t(bytes[i + 2]) << 16 | std::uint32_t(bytes[i + 3]) << 24;
            if (seedWord::isMember(word))
                greatest = std::max(greatest, seedWord::generation(word));
        }
    }
    return greatest;
}

/// The plane whose growth an edit of growth is about.
std::uint8_t grownPlane(const Edit& edit)
{
    std::optional<int> plane;
    if (const auto* grow = edit.as<GrowSteps>())
        plane = grow->criteria.plane;
    else if (const auto* change = edit.as<ChangeInterval>())
        plane = change->criteria.plane;
    else if (const auto* shrink = edit.as<ShrinkSteps>())
        plane = shrink->plane;
    else if (const auto* through = edit.as<ShrinkAt>())
        plane = through->plane;
    else if (const auto* plug = edit.as<PlugLeak>())
        plane = plug->plane;
    return std::uint8_t(plane.value_or(0));
}

std::uint32_t& counterOf(Document& document, std::uint8_t plane)
{
    std::vector<Growth>& growths = document.growths;
    auto at = growths.begin();
    while (at != growths.end() && at->plane < plane)
        ++at;
    if (at == growths.end() || at->plane != plane)
        at = growths.insert(at, {.plane = plane, .generation = 0});
    return at->generation;
}

/// The area on the left of a line, past the voxels of its segment.
std::vector<glm::dvec2> farAround(const SplitByCurve& edit, const VolumeGeometry& geometry,
    const std::vector<std::uint8_t>& labels)
{
    glm::ivec3 first = geometry.size;
    glm::ivec3 last(-1);
    std::size_t at = 0;
    for (int z = 0; z < geometry.size.z; ++z) {
        for (int y = 0; y < geometry.size.y; ++y) {
            for (int x = 0; x < geometry.size.x; ++x, ++at) {
                if (labels[at] != edit.segment)
                    continue;
                first = glm::min(first, glm::ivec3(x, y, z));
                last = glm::max(last, glm::ivec3(x, y, z));
            }
        }
    }
    const glm::dmat3 toPlane = glm::transpose(viewAxes(edit.view, {}).value());
    std::vector<glm::dvec2> places = edit.curveMm;
    for (const int x : {first.x, last.x})
        for (const int y : {first.y, last.y})
            for (const int z : {first.z, last.z})
                places.emplace_back(
                    toPlane * (geometry.toWorld(glm::dvec3(x, y, z)) - edit.view.targetLps));
    glm::dvec2 low = places.front();
    glm::dvec2 high = low;
    for (const glm::dvec2& place : places) {
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    return leftOfLine(edit.curveMm, low - 8.0, high + 8.0);
}

} // namespace

HistoryTruth::HistoryTruth(LoadedVolume study)
    : m_study(std::move(study))
{
    m_states[0].document = initialDocument(m_study.volume);
}

const Document& HistoryTruth::documentAt(RowId row) const
{
    return m_states.at(row).document;
}

std::vector<glm::ivec3> HistoryTruth::grownVoxels(RowId row, int plane) const
{
    const BrickGrid grid{m_study.volume.geometry.size};
    std::vector<glm::ivec3> voxels;
    for (const auto& [key, bytes] : m_states.at(row).bricks) {
        if (key.field != Field::SeedWords || key.plane != plane)
            continue;
        const glm::ivec3 corner = grid.brickPosition(int(key.brick)) * BrickGrid::side;
        for (std::size_t i = 0; i < bytes.size() / 4; ++i) {
            const std::uint32_t word = std::uint32_t(bytes[4 * i])
                | std::uint32_t(bytes[4 * i + 1]) << 8 | std::uint32_t(bytes[4 * i + 2]) << 16
                | std::uint32_t(bytes[4 * i + 3]) << 24;
            if (seedWord::isMember(word) && seedWord::generation(word) > 1)
                voxels.push_back(corner
                    + glm::ivec3(int(i) % BrickGrid::side,
                        int(i) / BrickGrid::side % BrickGrid::side,
                        int(i) / (BrickGrid::side * BrickGrid::side)));
        }
    }
    return voxels;
}

std::vector<std::uint8_t> HistoryTruth::labelsAt(RowId row, int plane) const
{
    return labelsOf(m_states.at(row).bricks, plane);
}

std::vector<std::uint8_t> HistoryTruth::labelsOf(const Bricks& bricks, int plane) const
{
    const glm::ivec3& size = m_study.volume.geometry.size;
    const BrickGrid grid{size};
    std::vector<std::uint8_t> labels;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::ivec3 voxel(x, y, z);
                const auto held = bricks.find(
                    {Field::Labels, std::uint8_t(plane), std::uint32_t(grid.brickOf(voxel))});
                labels.push_back(held == bricks.end()
                        ? std::uint8_t(0)
                        : held->second[std::size_t(BrickGrid::offsetInBrick(voxel))]);
            }
        }
    }
    return labels;
}

std::vector<std::uint8_t> HistoryTruth::labelsBeside(
    int segment, const Bricks& bricks, const Document& document) const
{
    return labelsOf(bricks, document.segment(segment)->plane);
}

/// Whose voxels may be taken follows from the document; which ones are meant is found here.
HistoryTruth::Bricks HistoryTruth::cleaned(
    const Bricks& before, const CleanSegment& edit, const Document& document) const
{
    const std::vector<std::uint8_t> labels = labelsBeside(edit.segment, before, document);
    const bool gives = edit.rule == IslandRule::FillHoles || edit.rule == IslandRule::GiveClicked;
    return relabelled(before, withoutBricks(relabelListed(edit, document, labels, {})),
        islandVoxels(edit, m_study.volume.geometry, labels),
        gives ? RelabelListed::give : RelabelListed::take);
}

/// In each plane in which one of them lies.
HistoryTruth::Bricks HistoryTruth::smoothedTogether(
    const Bricks& before, const ReshapeSegment& edit, const Document& document) const
{
    std::vector<int> segments = edit.with.value();
    segments.push_back(edit.segment);
    std::map<std::uint8_t, std::vector<std::uint8_t>> labels; // by plane
    for (const int label : segments)
        labels[document.segment(label)->plane] = labelsBeside(label, before, document);
    std::vector<LabelPlane> planes;
    for (const auto& [plane, its] : labels)
        planes.push_back({plane, its});
    return after(before, *labelPlanes(edit, document, planes, Progress()), {}, nullptr);
}

HistoryTruth::Bricks HistoryTruth::filledBetween(
    const Bricks& before, const FillBetweenSlices& edit, const Document& document) const
{
    const std::vector<std::uint8_t> labels = labelsBeside(edit.segment, before, document);
    const VolumeGeometry& geometry = m_study.volume.geometry;
    const auto label = std::uint8_t(edit.segment);
    return relabelled(before, withoutBricks(relabelListed(edit, document, labels, {})),
        edit.planes ? reference::voxelsBetweenPlanes(labels, geometry.size, label,
            planeSketch(*edit.planes, geometry, QStringLiteral("planes")).value())
                    : reference::voxelsBetween(labels, geometry, label, edit.axis),
        RelabelListed::give);
}

HistoryTruth::Bricks HistoryTruth::flooded(
    const Bricks& before, const FloodFill& edit, const Document& document) const
{
    const LabelTarget target = labelTarget(
        {.segment = edit.segment, .name = {}}, edit.overwriteUnlocked && !edit.erase, document)
                                   .value();
    const RelabelListed like{
        .target = target, .editable = editableVoxels(edit.editable, document, "floodFill").value()};
    return relabelled(before, like,
        reference::floodedVoxels(edit, m_study, labelsBeside(edit.segment, before, document)),
        edit.erase ? RelabelListed::take : RelabelListed::give);
}

/// One segment after the other, as the row names them. What an editable range keeps as a whole
/// becomes none.
HistoryTruth::Bricks HistoryTruth::islandsSplit(
    Bricks before, const SplitIslands& edit, const Document& document) const
{
    const VolumeGeometry& geometry = m_study.volume.geometry;
    const auto islands =
        islandsBySize(geometry.size, labelsBeside(edit.segment, before, document), edit.segment);
    RelabelListed like{.editable = editableVoxels(edit.editable, document, "splitIslands").value()};
    like.target.plane = document.segment(edit.segment)->plane;
    like.target.overwritable.set(std::size_t(edit.segment));
    std::size_t island = 1;
    for (std::size_t place = 0; place < edit.into.value().size(); ++island) {
        like.target.label = std::uint8_t(document.lastLabelGiven() + 1 + int(place));
        std::vector<bool> meant(geometry.voxelCount(), false);
        for (const std::size_t voxel : islands.at(island))
            meant[voxel] = true;
        Bricks after = relabelled(before, like, meant, RelabelListed::give);
        place += after == before ? 0 : 1;
        before = std::move(after);
    }
    return before;
}

HistoryTruth::Bricks HistoryTruth::splitByPlane(
    const Bricks& before, const SplitSegment& edit, const Document& document) const
{
    const VolumeGeometry& geometry = m_study.volume.geometry;
    const ClipHalfSpace beyond{
        .normalLps = edit.normalLps, .offsetMm = glm::dot(edit.normalLps, edit.placeLps)};
    const IntegerHalfSpace half = integerHalfSpaces(std::vector{beyond}, geometry).front();
    const std::vector<std::uint8_t> labels = labelsBeside(edit.segment, before, document);
    std::vector<bool> meant(labels.size(), false);
    std::size_t at = 0;
    for (int z = 0; z < geometry.size.z; ++z) {
        for (int y = 0; y < geometry.size.y; ++y) {
            for (int x = 0; x < geometry.size.x; ++x, ++at)
                meant[at] = labels[at] == edit.segment
                    && std::int64_t(half.perVoxel.x) * x + std::int64_t(half.perVoxel.y) * y
                            + std::int64_t(half.perVoxel.z) * z
                        > half.offset;
        }
    }
    RelabelListed like{.target = {.plane = document.segment(edit.segment)->plane,
                           .label = std::uint8_t(document.lastLabelGiven() + 1)},
        .editable = editableVoxels(edit.editable, document, "splitSegment").value()};
    like.target.overwritable.set(std::size_t(edit.segment));
    return relabelled(before, like, meant, RelabelListed::give);
}

/// Into the plane that the row names.
HistoryTruth::Bricks HistoryTruth::copied(
    const Bricks& before, const CopySegment& edit, const Document& document) const
{
    const std::vector<std::uint8_t> labels = labelsBeside(edit.segment, before, document);
    std::vector<bool> meant(labels.size(), false);
    for (std::size_t voxel = 0; voxel < labels.size(); ++voxel)
        meant[voxel] = labels[voxel] == edit.segment;
    const RelabelListed like{.target = {.plane = std::uint8_t(edit.plane.value()),
                                 .label = std::uint8_t(document.lastLabelGiven() + 1)},
        .editable = editableVoxels(edit.editable, document, "copySegment").value()};
    return relabelled(before, like, meant, RelabelListed::give);
}

/// What the oracle's scissors erase of the segment, inside and outside.
HistoryTruth::Bricks HistoryTruth::splitByCurve(
    const Bricks& before, const SplitByCurve& edit, const Document& document) const
{
    using Side = SplitByCurve::Side;
    const VolumeGeometry& geometry = m_study.volume.geometry;
    const std::uint8_t plane = document.segment(edit.segment)->plane;
    const std::vector<std::uint8_t> labels = labelsBeside(edit.segment, before, document);
    SegmentScissors scissors{.segment = edit.segment, .view = edit.view, .erase = true};
    scissors.polygonMm = edit.open ? farAround(edit, geometry, labels) : edit.curveMm;
    scissors.depthMm = edit.depthMm;
    scissors.hidden = edit.hidden;
    const auto erased = [&](bool outside) {
        scissors.outside = outside;
        reference::DenseFields fields(geometry.size);
        fields.labels(plane).values = labels;
        reference::labelScissors(
            {geometry.size, m_study.codes}, fields, labelScissors(scissors, document).value());
        std::vector<bool> meant;
        for (std::size_t at = 0; at < labels.size(); ++at)
            meant.push_back(fields.labels(plane).values[at] != labels[at]);
        return meant;
    };
    std::vector<bool> meant = erased(edit.side == Side::Outside);
    if (edit.side == Side::Smaller || edit.side == Side::Larger) {
        const std::vector<bool> outside = erased(true);
        const bool isInsideSmaller = std::count(meant.begin(), meant.end(), true)
            <= std::count(outside.begin(), outside.end(), true);
        if (isInsideSmaller != (edit.side == Side::Smaller))
            meant = outside;
    }
    RelabelListed like{
        .target = {.plane = plane, .label = std::uint8_t(document.lastLabelGiven() + 1)},
        .editable = editableVoxels(edit.editable, document, "splitByCurve").value()};
    like.target.overwritable.set(std::size_t(edit.segment));
    return relabelled(before, like, meant, RelabelListed::give);
}

HistoryTruth::Bricks HistoryTruth::evolved(
    const Bricks& before, const EvolveContour& edit, const Document& document) const
{
    const LabelTarget target =
        labelTarget({.segment = edit.segment, .name = {}}, edit.overwriteUnlocked, document)
            .value();
    const std::vector<std::uint8_t> labels = labelsBeside(edit.segment, before, document);
    std::vector<bool> gained = reference::evolvedContour(edit, contourRule(edit, document).value(),
        m_study, labels, [&](int label) { return target.overwritable[std::size_t(label)]; });
    std::vector<bool> lost(gained.size(), false);
    for (std::size_t voxel = 0; voxel < gained.size(); ++voxel) {
        const bool isOwn = labels[voxel] == edit.segment;
        lost[voxel] = isOwn && !gained[voxel];
        gained[voxel] = gained[voxel] && !isOwn;
    }
    const RelabelListed like{.target = target,
        .editable = editableVoxels(edit.editable, document, "evolveContour").value()};
    return relabelled(
        relabelled(before, like, lost, RelabelListed::take), like, gained, RelabelListed::give);
}

HistoryTruth::Bricks HistoryTruth::relabelled(const Bricks& before, RelabelListed like,
    const std::vector<bool>& meant, std::uint8_t asked) const
{
    const glm::ivec3& size = m_study.volume.geometry.size;
    const BrickGrid grid{size};
    std::map<std::uint32_t, std::vector<std::uint8_t>> bricks;
    std::size_t at = 0;
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x, ++at) {
                if (!meant[at])
                    continue;
                const glm::ivec3 voxel(x, y, z);
                std::vector<std::uint8_t>& brick = bricks[std::uint32_t(grid.brickOf(voxel))];
                brick.resize(BrickGrid::voxelsPerBrick, 0);
                brick[std::size_t(BrickGrid::offsetInBrick(voxel))] = asked;
            }
        }
    }
    for (const auto& [brick, each] : bricks)
        like.bricks.push_back({brick, each});
    return after(before, like, {}, nullptr);
}

std::vector<RowId> HistoryTruth::standingAt(RowId row) const
{
    std::vector<RowId> rows;
    for (const RowId id : standing(row)) {
        if (!changesDocumentOnly(m_rows.at(id).edit))
            rows.push_back(id);
    }
    return rows;
}

std::vector<RowId> HistoryTruth::path(RowId row) const
{
    std::vector<RowId> rows;
    for (; row != 0; row = m_rows.at(row).parent)
        rows.insert(rows.begin(), row);
    return rows;
}

std::set<RowId> HistoryTruth::standing(RowId row) const
{
    std::set<RowId> rows;
    for (const RowId id : path(row)) {
        rows.insert(id);
        if (const auto* revert = m_rows.at(id).edit.as<RevertRows>()) {
            for (const RowId taken : revert->rows)
                toggle(taken, false, rows);
        }
    }
    return rows;
}

void HistoryTruth::toggle(RowId row, bool stands, std::set<RowId>& rows) const
{
    if (stands)
        rows.insert(row);
    else
        rows.erase(row);
    if (const auto* revert = m_rows.at(row).edit.as<RevertRows>()) {
        for (const RowId taken : revert->rows)
            toggle(taken, !stands, rows);
    }
}

void HistoryTruth::add(const HistoryRow& row)
{
    m_rows[row.id] = row;
    State next = m_states.at(row.parent);
    const Edit& edit = row.edit;
    if (changesDocumentOnly(edit)) {
        changeDocument(edit, next.document);
    } else if (edit.is<DrillStroke>() || edit.is<BrushStroke>() || edit.is<PeelCut>()
        || edit.is<ScissorsCut>() || edit.is<LaserStroke>() || edit.is<RevertRows>()
        || edit.is<ReviseStroke>() || edit.is<SegmentToLayer>() || edit.is<MergeLayers>()
        || edit.is<RemoveLayer>()) {
        // Everything anew: what stands is grown again, and all cuts are laid over each other.
        const Bricks carved = carvedUntil(row.id);
        if (edit.is<RevertRows>()) {
            const Bricks again = regrown(row.id);
            std::erase_if(next.bricks, [](const auto& each) { return isOf(each.first, false); });
            next.bricks.insert(again.begin(), again.end());
            for (Growth& growth : next.document.growths)
                growth.generation =
                    std::max(growth.generation, greatestGeneration(again, growth.plane));
        }
        std::erase_if(next.bricks, [](const auto& each) { return isOf(each.first, true); });
        next.bricks.insert(carved.begin(), carved.end());
        changeDocument(edit, next.document);
    } else {
        std::uint32_t& generation = counterOf(next.document, grownPlane(edit));
        next.bricks = grown(next.bricks, edit, row.parent, &generation);
        changeDocument(edit, next.document);
    }
    for (const Segment& segment : next.document.segments)
        m_planes = std::max(m_planes, int(segment.plane) + 1);
    m_states[row.id] = std::move(next);
}

HistoryTruth::Bricks HistoryTruth::regrown(RowId row) const
{
    Bricks bricks;
    for (const RowId id : standing(row)) {
        const HistoryRow& done = m_rows.at(id);
        if (changesLabels(done.edit)) {
            // What was carved then is what it was chosen by.
            for (const auto& [key, bytes] : m_states.at(done.parent).bricks) {
                if (isOf(key, true))
                    bricks[key] = bytes;
            }
            std::uint32_t ignored = 0;
            bricks = grown(bricks, done.edit, done.parent, &ignored);
            std::erase_if(bricks, [](const auto& each) { return isOf(each.first, true); });
        }
    }
    return bricks;
}

HistoryTruth::Bricks HistoryTruth::grown(
    const Bricks& before, const Edit& edit, RowId parent, std::uint32_t* generation) const
{
    // Locks and the counter are those of when it was done.
    const Document& document = m_states.at(parent).document;
    if (const auto* seed = edit.as<SeedStroke>())
        return after(before, *seedPlacement(*seed, document), {}, nullptr);
    if (const auto* remove = edit.as<RemoveSegment>())
        return withoutLabel(before, remove->segment);
    if (const auto* paint = edit.as<PaintStroke>())
        return after(before, *paintLabel(*paint, document),
            {paintPath(*paint, m_study.volume.geometry)}, nullptr);
    if (const auto* carved = edit.as<LayerToSegment>())
        return after(before, *labelCarved(*carved, document), {}, nullptr);
    if (const auto* seen = edit.as<SegmentSeen>())
        return after(before, *labelSeen(*seen, document), {}, nullptr, &document);
    if (const auto* mask = edit.as<ImportMask>())
        return after(before, *labelPlanes(*mask, document), {}, nullptr);
    if (const auto* invert = edit.as<InvertSegment>())
        return after(before, *mapLabels(*invert, document), {}, nullptr);
    if (const auto* both = edit.as<CombineSegments>())
        return after(before, *engineEdit(*both, document), {}, nullptr);
    if (const auto* clean = edit.as<CleanSegment>())
        return cleaned(before, *clean, document);
    if (const auto* between = edit.as<FillBetweenSlices>())
        return filledBetween(before, *between, document);
    if (const auto* flood = edit.as<FloodFill>())
        return flooded(before, *flood, document);
    if (const auto* contour = edit.as<EvolveContour>())
        return evolved(before, *contour, document);
    if (const auto* islands = edit.as<SplitIslands>())
        return islandsSplit(before, *islands, document);
    if (const auto* split = edit.as<SplitSegment>())
        return splitByPlane(before, *split, document);
    if (const auto* copy = edit.as<CopySegment>())
        return copied(before, *copy, document);
    if (const auto* curve = edit.as<SplitByCurve>())
        return splitByCurve(before, *curve, document);
    if (const auto* outline = edit.as<FillOutline>())
        return after(before, *labelOutlined(*outline, document), {}, nullptr);
    if (const auto* threshold = edit.as<ThresholdSegment>())
        return after(before, *labelThreshold(*threshold, document), {}, nullptr, &document);
    if (const auto* scissors = edit.as<SegmentScissors>())
        return after(before, *labelScissors(*scissors, document), {}, nullptr);
    if (const auto* mirror = edit.as<MirrorSegment>())
        return after(before,
            *relabelListed(
                *mirror, document, labelsBeside(mirror->segment, before, document), Progress()),
            {}, nullptr);
    // What a ball does to a segment is another test's matter; here from which labels, and when.
    if (const auto* reshape = edit.as<ReshapeSegment>()) {
        const std::vector<std::uint8_t> labels = labelsBeside(reshape->segment, before, document);
        if (reshape->with)
            return smoothedTogether(before, *reshape, document);
        return after(before, *relabelListed(*reshape, document, labels, Progress()), {}, nullptr);
    }
    if (const auto* barrier = edit.as<BarrierStroke>())
        return after(before, *paintBarrier(*barrier, document),
            {CapsulePath{capsules(barrier->path, m_study.volume.geometry)}}, nullptr);
    if (const auto* shrink = edit.as<ShrinkSteps>())
        return after(before, *shrinkGrowth(*shrink, document), {}, generation);
    if (const auto* through = edit.as<ShrinkAt>())
        return after(before, *cutGrowth(*through, document), {}, generation);
    if (const auto* plug = edit.as<PlugLeak>())
        return after(before, *cutGrowth(*plug, document), {}, generation);
    if (const auto* spread = edit.as<GrowFromSeeds>())
        return after(before, *spreadLabels(*spread, document), {}, nullptr);
    const auto advance = [](std::optional<int> steps) {
        std::vector<EngineExtension> extensions;
        if (steps != 0)
            extensions.push_back(GrowAdvance{.steps = steps.value_or(GrowAdvance::toClosure)});
        return extensions;
    };
    if (const auto* change = edit.as<ChangeInterval>())
        return after(
            before, *growBurst(*change, document), advance(change->steps), generation, &document);
    const auto& grow = edit.get<GrowSteps>();
    return after(before, *growBurst(grow, document), advance(grow.steps), generation, &document);
}

SculptEdit HistoryTruth::formAfter(const Edit& drawn, const ReviseStroke& revise)
{
    const auto pressed = [&revise](auto form) {
        form.mask.radiusMm = revise.radiusMm.value_or(form.mask.radiusMm);
        form.mask.softnessMm = revise.softnessMm.value_or(form.mask.softnessMm);
        form.depthMm = revise.depthMm.value_or(form.depthMm);
        form.layer = revise.layer.value_or(form.layer);
        form.throughGaps = revise.throughGaps.value_or(form.throughGaps);
        return SculptEdit(form);
    };
    if (const auto* drill = drawn.as<DrillStroke>())
        return pressed(*drill);
    if (const auto* laser = drawn.as<LaserStroke>())
        return pressed(*laser);
    if (const auto* brush = drawn.as<BrushStroke>()) {
        BrushStroke form = *brush;
        form.path.radiusMm = revise.radiusMm.value_or(form.path.radiusMm);
        form.layer = revise.layer.value_or(form.layer);
        return form;
    }
    if (const auto* peel = drawn.as<PeelCut>()) {
        PeelCut form = *peel;
        form.depthMm = revise.depthMm.value_or(form.depthMm);
        form.layer = revise.layer.value_or(form.layer);
        form.throughGaps = revise.throughGaps.value_or(form.throughGaps);
        return form;
    }
    ScissorsCut form = drawn.get<ScissorsCut>();
    if (revise.depthMm)
        form.depthMm = revise.depthMm;
    form.layer = revise.layer.value_or(form.layer);
    return form;
}

HistoryTruth::Bricks HistoryTruth::carvedUntil(RowId row)
{
    std::vector<Stroke> strokes;
    for (const RowId id : standing(row)) {
        const Edit& edit = m_rows.at(id).edit;
        if (const auto* drill = edit.as<DrillStroke>())
            strokes.push_back({.row = id, .form = *drill});
        if (const auto* brush = edit.as<BrushStroke>())
            strokes.push_back({.row = id, .form = *brush});
        if (const auto* peel = edit.as<PeelCut>())
            strokes.push_back({.row = id, .form = *peel});
        if (const auto* scissors = edit.as<ScissorsCut>())
            strokes.push_back({.row = id, .form = *scissors});
        if (const auto* laser = edit.as<LaserStroke>())
            strokes.push_back({.row = id, .form = *laser});
        const auto* revise = edit.as<ReviseStroke>();
        for (Stroke& stroke : strokes) {
            if (!revise || stroke.row != revise->row)
                continue;
            stroke.form = formAfter(m_rows.at(stroke.row).edit, *revise);
            stroke.removed = revise->removed;
        }
    }
    Bricks carved;
    for (const RowId id : standing(row)) {
        const Edit& edit = m_rows.at(id).edit;
        const auto stroke = std::find_if(
            strokes.begin(), strokes.end(), [id](const Stroke& each) { return each.row == id; });
        if (stroke == strokes.end()) {
            writeLayer(edit, m_rows.at(id).parent, carved);
            continue;
        }
        if (stroke->removed)
            continue;
        const int layer = visitSculpt([](const auto& form) { return form.layer; }, stroke->form);
        const bool restore =
            visitSculpt([](const auto& form) { return form.restore; }, stroke->form);
        for (const auto& [brick, bytes] : cutOf(*stroke)) {
            std::vector<std::uint8_t>& held = carved[{Field::Coverage, std::uint8_t(layer), brick}];
            held.resize(bytes.size(), 0);
            for (std::size_t i = 0; i < bytes.size(); ++i)
                held[i] =
                    restore ? reference::refilled(held[i], bytes[i]) : std::max(held[i], bytes[i]);
        }
    }
    std::erase_if(carved, [](const auto& each) {
        return std::count(each.second.begin(), each.second.end(), 0) == std::ssize(each.second);
    });
    return carved;
}

void HistoryTruth::writeLayer(const Edit& edit, RowId at, Bricks& carved) const
{
    const auto layer = [&carved](int id) {
        Bricks found;
        for (const auto& [key, bytes] : carved) {
            if (key.plane == id)
                found[key] = bytes;
        }
        return found;
    };
    const auto* merge = edit.as<MergeLayers>();
    const auto* remove = edit.as<RemoveLayer>();
    if (merge || remove) {
        const int from = merge ? merge->from : remove->layer;
        for (const auto& [key, bytes] : layer(from)) {
            carved.erase(key);
            if (!merge)
                continue;
            std::vector<std::uint8_t>& held =
                carved[{Field::Coverage, std::uint8_t(merge->into), key.brick}];
            held.resize(bytes.size(), 0);
            for (std::size_t i = 0; i < bytes.size(); ++i)
                held[i] = std::max(held[i], bytes[i]);
        }
    }
    if (const auto* segment = edit.as<SegmentToLayer>()) {
        for (const auto& [key, bytes] : m_states.at(at).bricks) {
            for (std::size_t i = 0; key.field == Field::Labels && i < bytes.size(); ++i) {
                if (bytes[i] != segment->segment)
                    continue;
                std::vector<std::uint8_t>& held =
                    carved[{Field::Coverage, std::uint8_t(segment->layer), key.brick}];
                held.resize(bytes.size(), 0);
                held[i] = 255;
            }
        }
    }
}

HistoryTruth::Cut HistoryTruth::cutOf(const Stroke& stroke)
{
    const QByteArray key = QByteArray::number(qlonglong(stroke.row))
        + QJsonDocument(editToJson(stroke.form.plain())).toJson(QJsonDocument::Compact);
    if (const auto known = m_cuts.find(key); known != m_cuts.end())
        return known->second;
    const State& before = m_states.at(m_rows.at(stroke.row).parent);
    Bricks coverage = before.bricks;
    std::erase_if(coverage, [](const auto& each) { return each.first.field == Field::SeedWords; });
    EngineEdit edit;
    std::vector<EngineExtension> paths;
    if (const auto* drill = stroke.form.as<DrillStroke>()) {
        DrillCut alone = *drillCut(*drill, before.document);
        alone.layer = truthLayer;
        alone.laying = Laying::Carve;
        paths.push_back(DrillPath{drillPath(*drill, alone)});
        edit = alone;
    } else if (const auto* brush = stroke.form.as<BrushStroke>()) {
        CapsuleCut alone = *capsuleCut(*brush, before.document);
        alone.layer = truthLayer;
        alone.restore = false;
        paths.push_back(CapsulePath{capsules(brush->path, m_study.volume.geometry)});
        edit = alone;
    } else if (const auto* laser = stroke.form.as<LaserStroke>()) {
        LaserCut alone = *laserCut(*laser, before.document);
        alone.layer = truthLayer;
        alone.laying = Laying::Carve;
        paths.push_back(DrillPath{laserPath(*laser, alone)});
        edit = alone;
    } else if (const auto* peel = stroke.form.as<PeelCut>()) {
        ShellPeel alone = *shellPeel(*peel, before.document);
        alone.layer = truthLayer;
        alone.laying = Laying::Carve;
        paths.push_back(peelDepth(*peel));
        edit = alone;
    } else {
        OutlineCut alone = *outlineCut(stroke.form.get<ScissorsCut>(), before.document);
        alone.layer = truthLayer;
        alone.laying = Laying::Carve;
        edit = alone;
    }
    Cut cut;
    for (const auto& [brick, bytes] : after(coverage, edit, paths, nullptr, &before.document)) {
        if (brick.field == Field::Coverage && brick.plane == truthLayer)
            cut[brick.brick] = bytes;
    }
    return m_cuts[key] = cut;
}

HistoryTruth::Bricks HistoryTruth::after(const Bricks& before, const EngineEdit& edit,
    const std::vector<EngineExtension>& extensions, std::uint32_t* generation,
    const Document* muting) const
{
    reference::ReferenceEngine engine;
    static_cast<void>(engine.openVolume(m_study.volume.geometry.size, m_study.codes));
    if (muting) {
        MuteLayers mute;
        bool anySolo = false;
        for (const SculptLayer& layer : muting->layers)
            anySolo = anySolo || layer.solo;
        for (const SculptLayer& layer : muting->layers)
            mute.muted[layer.id] = layer.muted || (anySolo && !layer.solo);
        engine.submit(mute);
    }
    SwapBricks swap;
    for (const auto& [key, bytes] : before)
        swap.bricks.push_back({key, bytes});
    engine.submit(std::move(swap));
    const Ticket ticket = submitWhole(engine, edit, extensions);
    Bricks bricks = before;
    for (EngineResult& result : engine.collect()) {
        if (result.ticket != ticket)
            continue;
        if (result.error)
            qFatal("the oracle refused what a session did");
        if (generation)
            *generation = result.generation;
        for (BrickChange& change : result.changes) {
            bricks[change.key] = change.after.read();
            if (bricks[change.key].empty())
                bricks.erase(change.key);
        }
    }
    return bricks;
}

namespace {

template <class List, class Id> auto with(List& list, Id member, int id)
{
    return std::find_if(
        list.begin(), list.end(), [&](const auto& each) { return each.*member == id; });
}

template <class List, class Id> void move(List& list, Id member, int id, int place)
{
    const auto from = with(list, member, id);
    const auto moved = *from;
    list.erase(from);
    list.insert(list.begin() + std::min(std::ptrdiff_t(place) - 1, std::ssize(list)), moved);
}

template <class T> void takeValue(T& target, const std::optional<T>& value)
{
    target = value.value_or(target);
}

/// What was measured on a piece that is gone.
void release(int piece, Document& document)
{
    for (Measurement& measurement : document.measurements)
        measurement.piece = measurement.piece == piece ? 0 : measurement.piece;
}

void removeLayer(int id, Document& document)
{
    for (std::size_t i = document.pieces.size(); i-- > 0;) {
        const Piece piece = document.pieces[i];
        if (piece.layer != id)
            continue;
        document.greatestRemovedPiece = std::max(document.greatestRemovedPiece, piece.id);
        release(piece.id, document);
        document.pieces.erase(document.pieces.begin() + std::ptrdiff_t(i));
    }
    document.layers.erase(with(document.layers, &SculptLayer::id, id));
    document.greatestRemovedLayer = std::max(document.greatestRemovedLayer, id);
}

void addTarget(const SegmentChoice& choice, Document& document)
{
    if (choice.segment)
        return;
    int label = document.greatestRemovedLabel;
    for (const Segment& segment : document.segments)
        label = std::max<int>(label, segment.label);
    document.segments.push_back(
        {.label = std::uint8_t(label + 1), .name = choice.name, .rgb = choice.rgb});
}

void changePieces(const Edit& edit, Document& document)
{
    std::vector<Piece>& pieces = document.pieces;
    int last = document.greatestRemovedPiece;
    for (const Piece& piece : pieces)
        last = std::max(last, piece.id);
    if (const auto* cut = edit.as<CutPiece>()) {
        pieces.push_back(
            {.id = last + 1, .name = cut->name, .layer = cut->layer, .pivotLps = cut->pivotLps});
    } else if (const auto* paste = edit.as<PastePiece>()) {
        pieces.push_back({.id = last + 1,
            .name = paste->name,
            .segment = paste->segment,
            .pivotLps = paste->pivotLps,
            .pose = paste->pose});
    } else if (const auto* change = edit.as<ChangePiece>()) {
        Piece& piece = *with(pieces, &Piece::id, change->piece);
        takeValue(piece.name, change->name);
        takeValue(piece.pose.offsetMm, change->offsetMm);
        takeValue(piece.pose.rotationDegrees, change->rotationDegrees);
        takeValue(piece.pose.zoom, change->zoom);
    } else if (edit.is<SendPiecesHome>()) {
        for (Piece& piece : pieces)
            piece.pose = PiecePose{};
    } else if (const auto* gone = edit.as<RemovePiece>()) {
        pieces.erase(with(pieces, &Piece::id, gone->piece));
        release(gone->piece, document);
        document.greatestRemovedPiece = std::max(document.greatestRemovedPiece, gone->piece);
    }
}

} // namespace

void HistoryTruth::changeDocument(const Edit& edit, Document& document) const
{
    std::vector<Segment>& segments = document.segments;
    std::vector<SculptLayer>& layers = document.layers;
    if (const auto* add = edit.as<AddSegment>()) {
        int label = document.greatestRemovedLabel;
        for (const Segment& segment : segments)
            label = std::max(label, int(segment.label));
        segments.push_back({.label = std::uint8_t(label + 1),
            .plane = std::uint8_t(add->plane.value_or(0)),
            .name = add->name,
            .rgb = add->rgb,
            .code = add->code});
    } else if (const auto* change = edit.as<ChangeSegment>()) {
        Segment& segment = *with(segments, &Segment::label, change->segment);
        takeValue(segment.name, change->name);
        takeValue(segment.rgb, change->rgb);
        takeValue(segment.code, change->code);
        takeValue(segment.locked, change->locked);
        takeValue(segment.uncarvable, change->uncarvable);
    } else if (const auto* moved = edit.as<MoveSegment>()) {
        move(segments, &Segment::label, moved->segment, moved->place);
    } else if (const auto* remove = edit.as<RemoveSegment>()) {
        segments.erase(with(segments, &Segment::label, remove->segment));
        document.greatestRemovedLabel = std::max(document.greatestRemovedLabel, remove->segment);
        std::vector<Piece> left;
        for (const Piece& piece : document.pieces) {
            if (piece.segment != remove->segment) {
                left.push_back(piece);
            } else {
                document.greatestRemovedPiece = std::max(document.greatestRemovedPiece, piece.id);
                release(piece.id, document);
            }
        }
        document.pieces = left;
    } else if (const auto* layer = edit.as<AddLayer>()) {
        int id = document.greatestRemovedLayer;
        for (const SculptLayer& each : layers)
            id = std::max<int>(id, each.id);
        layers.push_back({.id = std::uint8_t(id + 1), .name = layer->name});
    } else if (const auto* other = edit.as<ChangeLayer>()) {
        SculptLayer& target = *with(layers, &SculptLayer::id, other->layer);
        takeValue(target.name, other->name);
        takeValue(target.muted, other->muted);
        takeValue(target.solo, other->solo);
    } else if (const auto* order = edit.as<MoveLayer>()) {
        move(layers, &SculptLayer::id, order->layer, order->place);
    } else if (const auto* gone = edit.as<RemoveLayer>()) {
        removeLayer(gone->layer, document);
    } else if (const auto* merge = edit.as<MergeLayers>()) {
        removeLayer(merge->from, document);
    } else if (const auto* carved = edit.as<LayerToSegment>()) {
        addTarget(carved->target, document);
    } else if (const auto* seen = edit.as<SegmentSeen>()) {
        addTarget(seen->target, document);
    } else if (const auto* mask = edit.as<ImportMask>(); mask && !mask->as) {
        for (std::size_t i = 0; i < mask->segments->size(); ++i) {
            const ImportedSegment& segment = (*mask->segments)[i];
            addTarget({.segment = {}, .name = segment.name, .rgb = segment.rgb}, document);
            document.segments.back().code = segment.code;
            document.segments.back().plane = std::uint8_t(mask->planes ? (*mask->planes)[i] : 0);
        }
    } else if (const auto* islands = edit.as<SplitIslands>()) {
        const std::uint8_t plane = with(segments, &Segment::label, islands->segment)->plane;
        for (const SplitPart& part : islands->into.value()) {
            addTarget({.segment = {}, .name = part.name, .rgb = part.rgb}, document);
            document.segments.back().plane = plane;
        }
    } else if (const auto* split = edit.as<SplitSegment>()) {
        const std::uint8_t plane = with(segments, &Segment::label, split->segment)->plane;
        addTarget({.segment = {}, .name = split->into.name, .rgb = split->into.rgb}, document);
        document.segments.back().plane = plane;
    } else if (const auto* copy = edit.as<CopySegment>()) {
        const CodedConcept code = with(segments, &Segment::label, copy->segment)->code;
        addTarget({.segment = {}, .name = copy->name, .rgb = copy->rgb}, document);
        document.segments.back().code = code;
        document.segments.back().plane = std::uint8_t(copy->plane.value());
    } else if (const auto* curve = edit.as<SplitByCurve>()) {
        const std::uint8_t plane = with(segments, &Segment::label, curve->segment)->plane;
        addTarget({.segment = {}, .name = curve->into.name, .rgb = curve->into.rgb}, document);
        document.segments.back().plane = plane;
    } else if (const auto* view = edit.as<AddBookmark>()) {
        int id = document.greatestRemovedBookmark;
        for (const CameraBookmark& bookmark : document.bookmarks)
            id = std::max(id, bookmark.id);
        document.bookmarks.push_back({.id = id + 1,
            .name = view->name,
            .view = view->view,
            .crosshairLps = view->crosshairLps});
    } else if (const auto* measured = edit.as<AddMeasurement>()) {
        int id = document.greatestRemovedMeasurement;
        for (const Measurement& measurement : document.measurements)
            id = std::max(id, measurement.id);
        document.measurements.push_back({.id = id + 1,
            .kind = Measurement::Kind::Distance,
            .pointsLps = {measured->fromLps, measured->toLps},
            .piece = measured->piece.value_or(0),
            .projected = measured->projected.value_or(false)});
    } else if (const auto* noted = edit.as<Annotate>()) {
        int id = document.greatestRemovedMeasurement;
        for (const Measurement& measurement : document.measurements)
            id = std::max(id, measurement.id);
        Measurement made;
        made.id = id + 1;
        made.kind = noted->kind;
        made.pointsLps = noted->pointsLps;
        takeValue(made.piece, noted->piece);
        takeValue(made.text, noted->text);
        takeValue(made.projected, noted->projected);
        document.measurements.push_back(made);
    } else if (const auto* dragged = edit.as<MoveMeasurement>()) {
        with(document.measurements, &Measurement::id, dragged->measurement)->pointsLps =
            dragged->pointsLps;
    } else if (const auto* length = edit.as<RemoveMeasurement>()) {
        document.measurements.erase(
            with(document.measurements, &Measurement::id, length->measurement));
        document.greatestRemovedMeasurement =
            std::max(document.greatestRemovedMeasurement, length->measurement);
    } else if (const auto* forgotten = edit.as<RemoveBookmark>()) {
        document.bookmarks.erase(
            with(document.bookmarks, &CameraBookmark::id, forgotten->bookmark));
        document.greatestRemovedBookmark =
            std::max(document.greatestRemovedBookmark, forgotten->bookmark);
    } else {
        changePieces(edit, document);
    }
}

QString HistoryTruth::difference(
    RowId row, EditEngine& engine, const Document& document, const QByteArray& stateHash) const
{
    const State& truth = m_states.at(row);
    const auto json = [](const Document& each) {
        return QJsonDocument(each.hashedState()).toJson(QJsonDocument::Compact);
    };
    if (json(document) != json(truth.document))
        return QStringLiteral("the document is\n%1 instead of\n%2")
            .arg(QString::fromUtf8(json(document)), QString::fromUtf8(json(truth.document)));
    const Bricks found = everything(engine, m_study.volume.geometry.size, m_planes);
    if (found != truth.bricks) {
        for (const auto& [key, bytes] : truth.bricks) {
            const auto same = found.find(key);
            if (same == found.end())
                return QStringLiteral("brick %1 of field %2, plane %3 is missing")
                    .arg(key.brick)
                    .arg(int(key.field))
                    .arg(key.plane);
            const auto [was, is] =
                std::mismatch(bytes.begin(), bytes.end(), same->second.begin(), same->second.end());
            if (was != bytes.end())
                return QStringLiteral("brick %1 of field %2, plane %3 is another: at byte %4 it "
                                      "is %5 instead of %6")
                    .arg(key.brick)
                    .arg(int(key.field))
                    .arg(key.plane)
                    .arg(was - bytes.begin())
                    .arg(*is)
                    .arg(*was);
        }
        return QStringLiteral("there are voxels that must be empty");
    }
    StateHash hash;
    std::vector<BrickImage> images;
    for (const auto& [key, bytes] : truth.bricks)
        images.push_back({key, bytes});
    hash.update(images);
    if (hash.root(json(truth.document)) != stateHash)
        return QStringLiteral("the state hash is another");
    return {};
}

} // namespace test
