// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/chunks/ChunkVoxels.h"

#include "core/chunks/ProbabilityMap.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/chunks/DivideSegment.h"

#include <algorithm>
#include <array>

namespace core {

namespace {

tl::unexpected<Error> wrong(const char* field, const Clause& reason)
{
    return failure(ErrorCode::InvalidField, QLatin1String(field), reason);
}

std::int64_t voxelsOf(const VoxelBox& box)
{
    const glm::ivec3 size = box.maximum - box.minimum;
    return std::int64_t(size.x) * size.y * size.z;
}

Result<void> checkSize(const VoxelBox& box)
{
    if (voxelsOf(box) <= mostChunkVoxels)
        return {};
    return wrong("chunks.marginMm",
        Clause::saying("the box around the segment has %1 million voxels, at most %2 million are "
                       "divided",
            voxelsOf(box) >> 20, mostChunkVoxels >> 20));
}

/// Calls @p visit(place in the volume, place in the box) for every row of the box.
template <class Visit>
void forEachRow(const VoxelBox& box, const glm::ivec3& volumeSize, const Visit& visit)
{
    std::size_t inBox = 0;
    for (int z = box.minimum.z; z < box.maximum.z; ++z) {
        for (int y = box.minimum.y; y < box.maximum.y; ++y) {
            const auto row = std::size_t(z) * std::size_t(volumeSize.y) + std::size_t(y);
            visit(row * std::size_t(volumeSize.x) + std::size_t(box.minimum.x), inBox);
            inBox += std::size_t(box.maximum.x - box.minimum.x);
        }
    }
}

/// The number that an owner has in the box.
std::uint8_t numberOf(int label, const std::vector<ChunkOwner>& owners)
{
    if (label != ChunkSource::outside)
        return std::uint8_t(label);
    // Labels ascend, so this one is the last: before it there is a gap, else it counts as none.
    int free = 1;
    while (std::size_t(free) <= owners.size() && owners[std::size_t(free - 1)].label == free)
        ++free;
    return std::uint8_t(free);
}

/// What boxAround() does with labels.
VoxelBox boxAround(const VoxelRuns& voxels, const VolumeGeometry& geometry, double marginMm)
{
    const auto columns = std::uint64_t(geometry.size.x);
    const auto rows = std::uint64_t(geometry.size.y);
    VoxelBox box;
    for (const VoxelRun& run : voxels.runs()) {
        // A run may go on into further rows.
        for (std::uint64_t at = run.first; at < run.first + run.count;) {
            const glm::ivec3 voxel(
                int(at % columns), int(at / columns % rows), int(at / columns / rows));
            const auto length =
                std::min(columns - std::uint64_t(voxel.x), run.first + run.count - at);
            box = box.united({voxel, voxel + glm::ivec3(int(length), 1, 1)});
            at += length;
        }
    }
    return ChunkMap::withMargin(box, geometry, marginMm);
}

} // namespace

Result<std::vector<ChunkOwner>> chunkOwners(
    const DivideSegment& edit, const VolumeGeometry& geometry, std::span<const std::uint8_t> labels)
{
    const std::optional<VoxelBox> box =
        ChunkMap::boxAround(labels, std::uint8_t(edit.segment), geometry, edit.marginMm);
    if (!box)
        return wrong(
            "chunks.segment", Clause::saying("segment %1 has no voxels to divide", edit.segment));
    if (const Result<void> checked = checkSize(*box); !checked)
        return tl::unexpected(checked.error());
    std::array<VoxelRuns, 256> runs;
    const auto width = std::size_t(box->maximum.x - box->minimum.x);
    forEachRow(*box, geometry.size, [&](std::size_t first, std::size_t) {
        for (std::size_t at = first; at < first + width;) {
            const std::uint8_t label = labels[at];
            std::size_t end = at;
            while (end < first + width && labels[end] == label)
                ++end;
            if (label != 0)
                runs[label].append(at, end - at);
            at = end;
        }
    });
    std::vector<ChunkOwner> owners;
    for (int label = 1; label < int(runs.size()); ++label) {
        const VoxelRuns& voxels = runs[std::size_t(label)];
        if (voxels.empty())
            continue;
        ChunkOwner owner{.label = label, .voxels = packedRuns(voxels)};
        if (owner.voxels.isEmpty())
            return wrong("chunks.marginMm",
                Clause::saying("segment %1 is too ragged there to be divided", label));
        owners.push_back(std::move(owner));
    }
    return owners;
}

Result<OwnedBox> ownedBox(const DivideSegment& edit, const VolumeGeometry& geometry)
{
    std::vector<VoxelRuns> runs;
    OwnedBox owned;
    for (const ChunkOwner& owner : edit.owners.value_or(std::vector<ChunkOwner>())) {
        std::optional<VoxelRuns> voxels = unpackedRuns(owner.voxels, geometry.voxelCount());
        if (!voxels || voxels->empty())
            return wrong("chunks.owners",
                Clause::saying(
                    "the voxels of label %1 are damaged, or of another volume", owner.label));
        if (owner.label == edit.segment) {
            owned.box = boxAround(*voxels, geometry, edit.marginMm);
            owned.segment = numberOf(owner.label, *edit.owners);
        }
        runs.push_back(*std::move(voxels));
    }
    if (owned.box.empty())
        return wrong("chunks.owners", Clause::saying("segment %1 is not among them", edit.segment));
    if (const Result<void> checked = checkSize(owned.box); !checked)
        return tl::unexpected(checked.error());
    owned.owners.assign(std::size_t(voxelsOf(owned.box)), 0);
    const glm::ivec3 size = owned.box.maximum - owned.box.minimum;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        auto run = runs[i].runs().begin();
        const std::uint8_t number = numberOf((*edit.owners)[i].label, *edit.owners);
        forEachRow(owned.box, geometry.size, [&](std::size_t first, std::size_t inBox) {
            const std::uint64_t last = first + std::uint64_t(size.x);
            while (run != runs[i].runs().end() && run->first + run->count <= first)
                ++run;
            // The last run of a row may go on into the next one.
            for (auto one = run; one != runs[i].runs().end() && one->first < last; ++one) {
                const std::uint64_t from = std::max<std::uint64_t>(one->first, first);
                const std::uint64_t to = std::min(one->first + one->count, last);
                std::fill_n(&owned.owners[inBox + std::size_t(from - first)],
                    std::size_t(to - from), number);
            }
        });
    }
    const Result<std::vector<std::uint8_t>> map = probabilitiesOf(edit, geometry);
    if (!map)
        return tl::unexpected(map.error());
    if (map->empty())
        return owned;
    owned.probabilities.resize(owned.owners.size());
    forEachRow(owned.box, geometry.size, [&](std::size_t first, std::size_t inBox) {
        std::copy_n(&(*map)[first], size.x, &owned.probabilities[inBox]);
    });
    return owned;
}

Result<std::vector<std::uint8_t>> probabilitiesOf(
    const DivideSegment& edit, const VolumeGeometry& geometry)
{
    if (!edit.probabilities)
        return std::vector<std::uint8_t>();
    auto map = ProbabilityMap::unpacked(*edit.probabilities, geometry.voxelCount());
    if (!map)
        return wrong("chunks.probabilities",
            Clause::saying("the probability map is damaged, or of another volume"));
    return *std::move(map);
}

Result<ChunkClick> chunkClick(const ChunkToggle& edit, const Document& document)
{
    Result<LabelTarget> target = segmentTarget(edit.segment, edit.overwriteUnlocked, document);
    if (!target)
        return tl::unexpected(target.error());
    if (!document.chunks)
        return wrong("chunkToggle.segment", Clause::saying("nothing is divided into chunks"));
    const Segment* divided = document.segment(document.chunks->segment);
    if (!divided || divided->plane != target->plane)
        return wrong(
            "chunkToggle.segment", Clause::saying("the chunks are of another plane of labels"));
    Result<std::vector<glm::ivec3>> voxels =
        seedVoxels(edit.pointsLps, document.volumes.front().geometry);
    if (!voxels)
        return wrong("chunkToggle.pointsLps", Clause::saying("a point lies outside the volume"));
    Result<std::optional<EditableVoxels>> editable =
        editableVoxels(edit.editable, document, "chunkToggle");
    if (!editable)
        return tl::unexpected(editable.error());
    return ChunkClick{
        .target = *target, .editable = *std::move(editable), .voxels = *std::move(voxels)};
}

ClickedChunks::ClickedChunks(const ChunkMap& map, const ChunkToggle& edit, const ChunkClick& click)
    : m_mode(edit.mode)
    , m_target(click.target)
    , m_editable(click.editable)
{
    const BrickGrid grid{map.volumeSize()};
    for (const ChunkTree::Chunk chunk : map.chunksAt(click.voxels, edit.chunks))
        m_chunks.push_back(partsOf(map, chunk, grid));
}

std::vector<ClickedChunks::Part> ClickedChunks::partsOf(
    const ChunkMap& map, ChunkTree::Chunk chunk, const BrickGrid& grid)
{
    std::map<std::uint32_t, std::size_t> places; // in parts
    std::vector<Part> parts;
    map.forEachVoxel(chunk, [&](const glm::ivec3& voxel) {
        const auto brick = std::uint32_t(grid.brickOf(voxel));
        // Voxels of a piece lie together.
        if (parts.empty() || parts.back().brick != brick) {
            const auto [place, isNew] = places.emplace(brick, parts.size());
            if (isNew)
                parts.push_back({.brick = brick, .offsets = {}});
            parts[place->second].offsets.push_back(std::uint16_t(BrickGrid::offsetInBrick(voxel)));
            return;
        }
        parts.back().offsets.push_back(std::uint16_t(BrickGrid::offsetInBrick(voxel)));
    });
    return parts;
}

std::vector<std::uint32_t> ClickedChunks::bricks() const
{
    std::vector<std::uint32_t> bricks;
    for (const std::vector<Part>& parts : m_chunks) {
        for (const Part& part : parts)
            bricks.push_back(part.brick);
    }
    std::sort(bricks.begin(), bricks.end());
    bricks.erase(std::unique(bricks.begin(), bricks.end()), bricks.end());
    return bricks;
}

RelabelListed ClickedChunks::relabelled(const std::vector<BrickChange>& labels) const
{
    RelabelListed relabel{.target = m_target, .bricks = {}, .editable = m_editable};
    const std::vector<std::uint32_t> numbers = bricks();
    std::vector<const std::vector<std::uint8_t>*> held(numbers.size(), nullptr);
    const auto placeOf = [&numbers](std::uint32_t brick) {
        return std::size_t(
            std::lower_bound(numbers.begin(), numbers.end(), brick) - numbers.begin());
    };
    for (const std::uint32_t brick : numbers)
        relabel.bricks.push_back(
            {brick, std::vector<std::uint8_t>(BrickGrid::voxelsPerBrick, std::uint8_t(0))});
    for (const BrickChange& brick : labels) {
        const std::size_t place = placeOf(brick.key.brick);
        if (place < numbers.size() && numbers[place] == brick.key.brick && !brick.after.empty())
            held[place] = &brick.after.read();
    }
    for (const std::vector<Part>& parts : m_chunks) {
        std::size_t voxels = 0;
        std::size_t own = 0;
        for (const Part& part : parts) {
            voxels += part.offsets.size();
            const std::vector<std::uint8_t>* bytes = held[placeOf(part.brick)];
            for (const std::uint16_t offset : part.offsets)
                own += bytes && (*bytes)[offset] == m_target.label ? 1 : 0;
        }
        const bool goes = m_mode == ChunkToggle::Mode::Remove
            || (m_mode == ChunkToggle::Mode::Toggle && 2 * own > voxels);
        for (const Part& part : parts) {
            std::vector<std::uint8_t>& asked = relabel.bricks[placeOf(part.brick)].asked;
            for (const std::uint16_t offset : part.offsets)
                asked[offset] = goes ? RelabelListed::take : RelabelListed::give;
        }
    }
    return relabel;
}

} // namespace core
