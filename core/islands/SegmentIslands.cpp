// SPDX-License-Identifier: Apache-2.0
#include "core/islands/SegmentIslands.h"

#include "core/brick/LabelBox.h"
#include "core/islands/RunParts.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <limits>
#include <optional>

namespace core {

namespace {

/// Where, from @p begin on, the first voxel of a row lies that is not the label's, or with @p own
/// false the first that is; @p end: nowhere before it. Eight voxels at once, as long as they agree.
int endOfRun(const std::uint8_t* row, int begin, int end, std::uint8_t label, bool own)
{
    constexpr std::uint64_t ones = 0x0101010101010101U;
    constexpr std::uint64_t highBits = 0x8080808080808080U;
    constexpr int eight = 8;
    int x = begin;
    for (; x + eight <= end; x += eight) {
        std::uint64_t voxels = 0;
        std::memcpy(&voxels, row + x, sizeof(voxels));
        const std::uint64_t others = voxels ^ (ones * label); // a byte is 0 where the label is
        const bool hasLabel = ((others - ones) & ~others & highBits) != 0;
        if (own ? others != 0 : hasLabel)
            break;
    }
    while (x < end && (row[x] == label) == own)
        ++x;
    return x;
}

/// The runs of voxels in a box that are the label's, or those that are not, joined to parts.
/// Errors: Cancelled.
Result<RunParts> partsIn(const VoxelBox& box, std::span<const std::uint8_t> labels,
    const glm::ivec3& size, std::uint8_t label, bool own, const Progress& progress)
{
    const glm::ivec3 boxSize = box.maximum - box.minimum;
    RunParts parts(boxSize, own ? 1 : 0);
    const auto runsOfRow = [&](int y, int z, const auto& add) {
        const auto slice = std::size_t(z + box.minimum.z) * std::size_t(size.y);
        const auto* row =
            &labels[(slice + std::size_t(y + box.minimum.y)) * std::size_t(size.x)] + box.minimum.x;
        for (int x = 0; x < boxSize.x;) {
            const int begin = endOfRun(row, x, boxSize.x, label, !own);
            x = endOfRun(row, begin, boxSize.x, label, own);
            if (x > begin)
                add(begin, x);
        }
    };
    if (!parts.find(progress, runsOfRow) || !parts.join(progress))
        return failure(ErrorCode::Cancelled);
    return parts;
}

/// The number of voxels of each part, indexed by its first run; 0 for runs that begin no part.
std::vector<std::int64_t> sizesOf(RunParts& parts)
{
    std::vector<std::int64_t> sizes(parts.count(), 0);
    for (std::size_t at = 0; at < parts.count(); ++at)
        sizes[parts.partOf(at)] += parts.run(at).end - parts.run(at).begin;
    return sizes;
}

/// The voxel with an index in memory, x fastest.
glm::ivec3 voxelAt(std::size_t index, const glm::ivec3& size)
{
    const auto columns = std::size_t(size.x);
    const auto rows = std::size_t(size.y);
    return {int(index % columns), int(index / columns % rows), int(index / columns / rows)};
}

/// @param row where the row of the run begins in the volume
void appendRun(
    VoxelRuns& voxels, const RunParts::Run& run, const glm::ivec3& row, const glm::ivec3& size)
{
    const std::uint64_t first =
        (std::uint64_t(row.z) * std::uint64_t(size.y) + std::uint64_t(row.y))
            * std::uint64_t(size.x)
        + std::uint64_t(row.x);
    voxels.append(first + std::uint64_t(run.begin), std::uint64_t(run.end - run.begin));
}

/// Parts of the background that reach the box's border lead out of the segment: no voxel beyond
/// the box is the segment's.
void dropOpen(RunParts& parts, const glm::ivec3& size, std::vector<std::int64_t>& sizes)
{
    std::vector<std::uint32_t> open;
    parts.forEach([&](std::size_t at, int y, int z) {
        const RunParts::Run& run = parts.run(at);
        const bool atBorder = run.begin == 0 || run.end == size.x || y == 0 || y + 1 == size.y
            || z == 0 || z + 1 == size.z;
        if (atBorder)
            open.push_back(parts.partOf(at));
    });
    for (const std::uint32_t part : open)
        sizes[part] = 0;
}

} // namespace

Result<IslandChange> islandChange(std::span<const std::uint8_t> labels, const glm::ivec3& size,
    std::uint8_t label, IslandRule rule, std::int64_t voxels, const Progress& progress,
    std::size_t clicked)
{
    if (isOfClicked(rule) && (clicked >= labels.size() || labels[clicked] != label))
        return IslandChange();
    const VoxelBox box = boxOfLabel(labels, size, label);
    if (box.empty())
        return IslandChange();
    const bool holes = rule == IslandRule::FillHoles;
    Result<RunParts> parts = partsIn(box, labels, size, label, !holes, progress);
    if (!parts)
        return tl::unexpected(parts.error());
    std::vector<std::int64_t> sizes = sizesOf(*parts);
    if (holes)
        dropOpen(*parts, box.maximum - box.minimum, sizes);
    const auto largest = std::max_element(sizes.begin(), sizes.end()) - sizes.begin();
    std::optional<std::uint32_t> clickedPart;
    if (isOfClicked(rule))
        clickedPart = parts->partAt(voxelAt(clicked, size) - box.minimum);
    const auto isMeant = [&](std::uint32_t part) {
        switch (rule) {
        case IslandRule::FillHoles:
            return sizes[part] > 0 && sizes[part] <= voxels;
        case IslandRule::KeepLargest:
            return std::ptrdiff_t(part) != largest;
        case IslandRule::RemoveSmall:
            return sizes[part] < voxels;
        case IslandRule::KeepClicked:
            return part != clickedPart;
        case IslandRule::RemoveClicked:
        case IslandRule::GiveClicked:
            return part == clickedPart;
        }
        return false;
    };
    IslandChange change;
    parts->forEach([&](std::size_t at, int y, int z) {
        const std::uint32_t part = parts->partOf(at);
        if (!isMeant(part))
            return;
        change.parts += part == at ? 1 : 0;
        appendRun(change.voxels, parts->run(at), box.minimum + glm::ivec3(0, y, z), size);
    });
    return change;
}

Result<std::vector<std::int64_t>> islandSizes(std::span<const std::uint8_t> labels,
    const glm::ivec3& size, std::uint8_t label, const Progress& progress)
{
    const VoxelBox box = boxOfLabel(labels, size, label);
    if (box.empty())
        return std::vector<std::int64_t>();
    Result<RunParts> parts = partsIn(box, labels, size, label, true, progress);
    if (!parts)
        return tl::unexpected(parts.error());
    std::vector<std::int64_t> sizes = sizesOf(*parts);
    std::erase(sizes, 0); // runs that begin no island
    std::sort(sizes.begin(), sizes.end(), std::greater<>());
    return sizes;
}

Result<FurtherIslands> furtherIslands(std::span<const std::uint8_t> labels, const glm::ivec3& size,
    std::uint8_t label, std::int64_t least, std::size_t most, const Progress& progress)
{
    const VoxelBox box = boxOfLabel(labels, size, label);
    if (box.empty())
        return FurtherIslands();
    Result<RunParts> parts = partsIn(box, labels, size, label, true, progress);
    if (!parts)
        return tl::unexpected(parts.error());
    const std::vector<std::int64_t> sizes = sizesOf(*parts);
    const auto largest = std::size_t(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
    std::vector<std::uint32_t> further; // parts, in the order of memory
    for (std::size_t part = 0; part < sizes.size(); ++part) {
        if (part != largest && sizes[part] > 0 && sizes[part] >= least)
            further.push_back(std::uint32_t(part));
    }
    std::stable_sort(further.begin(), further.end(),
        [&sizes](std::uint32_t one, std::uint32_t other) { return sizes[one] > sizes[other]; });
    FurtherIslands result{.islands = {}, .count = std::int64_t(further.size())};
    further.resize(std::min(further.size(), most));
    result.islands.resize(further.size());
    constexpr std::uint32_t notListed = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> places(sizes.size(), notListed); // by part
    for (std::size_t place = 0; place < further.size(); ++place)
        places[further[place]] = std::uint32_t(place);
    parts->forEach([&](std::size_t at, int y, int z) {
        const std::uint32_t place = places[parts->partOf(at)];
        if (place != notListed)
            appendRun(
                result.islands[place], parts->run(at), box.minimum + glm::ivec3(0, y, z), size);
    });
    return result;
}

} // namespace core
