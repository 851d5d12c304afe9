// SPDX-License-Identifier: Apache-2.0
#include "core/session/operations/segments/FloodOperation.h"

#include "core/brick/BrickBits.h"
#include "core/engine/EngineCommands.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

namespace core {

namespace {

constexpr int blockSide = 4; ///< bricks, in all directions
constexpr int sliceBlockSide = 32; ///< bricks, in a slice
constexpr int firstSliceBlockSide = 8; ///< of the block around the place, in a slice
constexpr std::size_t blocksAtOnce = 8;

/// The voxels of a brick that have the label.
BrickBits bitsOfLabel(const BrickImage& image, std::uint8_t label)
{
    BrickBits bits;
    const std::vector<std::uint8_t>& bytes = image.bytes.read();
    for (std::size_t voxel = 0; voxel < bytes.size(); ++voxel) {
        if (bytes[voxel] == label)
            bits.add(voxel);
    }
    return bits;
}

/// Those of these voxels of a brick that lie in an oblique slice, to which the first voxel always
/// belongs.
BrickBits inSlice(
    const BrickBits& bits, const VoxelBox& box, const CapsuleFrame& slice, const glm::ivec3& first)
{
    constexpr int side = BrickGrid::side;
    BrickBits kept;
    bits.forEach([&](std::size_t offset) {
        const auto at = int(offset);
        const glm::ivec3 voxel =
            box.minimum + glm::ivec3(at % side, at / side % side, at / (side * side));
        if (voxel == first || isInSlab(slice, voxel))
            kept.add(offset);
    });
    return kept;
}

} // namespace

FloodOperation::FloodOperation(const FloodFill& edit, RowId again)
    : WorkedOutOperation(edit, Kind::Whole, again)
{
}

void FloodOperation::start(SessionState& state)
{
    if (!mayStart(state))
        return;
    const Volume& volume = state.document.volumes.front();
    const glm::ivec3 first = firstVoxel(fill(), volume.geometry).value();
    const std::optional<CapsuleFrame> slice = obliqueSlice(fill(), volume.geometry);
    BrickFlood::Rule rule{.corners = fill().corners, .within = fill().within};
    if (slice)
        rule.across = steepestAxis(*slice);
    m_work = std::make_shared<Work>(Work{.edit = fill(),
        .grid = BrickGrid{volume.geometry.size},
        .first = first,
        .flood = BrickFlood(volume.geometry.size, first, rule),
        .slice = slice,
        .encoding = volume.encoding});
    askNext(state);
}

/// A few of the blocks that are wanted.
std::vector<FloodOperation::Reading> FloodOperation::nextReadings() const
{
    const glm::ivec3 size = m_work->grid.volumeSize;
    glm::ivec3 side(blockSide);
    if (fill().within) {
        side = glm::ivec3(m_isFirstReading ? firstSliceBlockSide : sliceBlockSide);
        side[alongOf(*fill().within)] = 1;
    }
    std::set<std::tuple<int, int, int>> blocks; // z, y, x
    for (const std::uint32_t brick : m_work->flood.wanted()) {
        const glm::ivec3 block = m_work->grid.brickPosition(int(brick)) / side;
        blocks.emplace(block.z, block.y, block.x);
        if (blocks.size() == blocksAtOnce)
            break;
    }
    std::vector<Reading> readings;
    for (const auto& [z, y, x] : blocks) {
        const glm::ivec3 begin = glm::ivec3(x, y, z) * side;
        const glm::ivec3 end = glm::min(begin + side, m_work->grid.bricks());
        Reading reading{.box = {.minimum = begin * BrickGrid::side,
                            .maximum = glm::min(end * BrickGrid::side, size)},
            .bricks = {},
            .codes = {},
            .labels = {}};
        if (fill().within) {
            const int along = alongOf(*fill().within);
            reading.box.minimum[along] = m_work->first[along];
            reading.box.maximum[along] = m_work->first[along] + 1;
        }
        for (int w = begin.z; w < end.z; ++w) {
            for (int v = begin.y; v < end.y; ++v) {
                for (int u = begin.x; u < end.x; ++u) {
                    const glm::ivec3 voxel = glm::ivec3(u, v, w) * BrickGrid::side;
                    const auto brick = std::uint32_t(m_work->grid.brickOf(voxel));
                    if (!m_work->flood.wasGiven(brick))
                        reading.bricks.push_back(brick);
                }
            }
        }
        readings.push_back(std::move(reading));
    }
    return readings;
}

void FloodOperation::askNext(SessionState& state)
{
    if (!mayGoOn(state))
        return;
    const std::uint8_t plane = state.document.segment(fill().segment)->plane;
    std::vector<Reading> readings = nextReadings();
    m_isFirstReading = false;
    for (Reading& reading : readings) {
        EngineCommand question = ReadCodes{reading.box};
        if (fill().erase) {
            ReadBricks labels;
            for (const std::uint32_t brick : reading.bricks)
                labels.keys.push_back({Field::Labels, plane, brick});
            question = std::move(labels);
        }
        const Ticket ticket = state.engine.submit(std::move(question));
        m_asked.emplace(ticket, std::move(reading));
    }
}

void FloodOperation::takeResult(SessionState& state, EngineResult&& result)
{
    const auto asked = m_asked.find(result.ticket);
    if (asked == m_asked.end())
        return takeWritten(state, std::move(result));
    Reading reading = std::move(asked->second);
    m_asked.erase(asked);
    if (result.error && !m_failed)
        m_failed = *result.error;
    reading.codes = std::move(result.codes);
    for (const BrickChange& brick : result.changes) {
        if (!brick.after.empty())
            reading.labels.push_back({.key = brick.key, .bytes = brick.after});
    }
    m_read.push_back(std::move(reading));
    if (!m_asked.empty())
        return;
    if (m_failed)
        return giveUp(state, *m_failed);
    goOn(state);
}

void FloodOperation::goOn(SessionState& state)
{
    workAside(state,
        [this, work = m_work, watch = watch(), document = state.document,
            readings = std::make_shared<std::vector<Reading>>(std::exchange(m_read, {}))] {
            for (const Reading& reading : *readings)
                give(*work, reading);
            readings->clear();
            if (!work->flood.spread(watch->progress) || !work->flood.wanted().empty())
                return SideThread::Sequel([this](SessionState& known) { askNext(known); });
            auto listed = std::make_shared<Result<Listed>>(
                relabelListed(work->edit, document, work->flood.found()));
            return SideThread::Sequel(
                [this, listed](SessionState& known) { write(known, std::move(*listed)); });
        });
}

/// What of a block may belong to the region.
void FloodOperation::give(Work& work, const Reading& reading)
{
    std::map<std::uint32_t, BrickBits> bits;
    for (const std::uint32_t brick : reading.bricks)
        bits.emplace(brick, BrickBits());
    for (const BrickImage& image : reading.labels)
        bits[image.key.brick] = bitsOfLabel(image, std::uint8_t(work.edit.segment));
    if (!reading.codes.empty()) {
        const glm::ivec3 extent = reading.box.maximum - reading.box.minimum;
        const auto codeAt = [&](const glm::ivec3& voxel) {
            const glm::ivec3 at = voxel - reading.box.minimum;
            return int(reading.codes[(std::size_t(at.z) * std::size_t(extent.y) + std::size_t(at.y))
                    * std::size_t(extent.x)
                + std::size_t(at.x)]);
        };
        if (!work.interval) // the first block has the first voxel
            work.interval = floodInterval(work.edit, work.encoding, codeAt(work.first));
        for (auto& [brick, its] : bits) {
            const VoxelBox box = work.grid.boxOf(int(brick));
            const glm::ivec3 begin = glm::max(box.minimum, reading.box.minimum);
            const glm::ivec3 end = glm::min(box.maximum, reading.box.maximum);
            for (int z = begin.z; z < end.z; ++z) {
                for (int y = begin.y; y < end.y; ++y) {
                    for (int x = begin.x; x < end.x; ++x) {
                        const int code = codeAt({x, y, z});
                        if (code >= work.interval->low && code <= work.interval->high)
                            its.add(std::size_t(BrickGrid::offsetInBrick({x, y, z})));
                    }
                }
            }
        }
    }
    for (const auto& [brick, its] : bits) {
        const VoxelBox box = work.grid.boxOf(int(brick));
        work.flood.give(brick, work.slice ? inSlice(its, box, *work.slice, work.first) : its);
    }
}

} // namespace core
