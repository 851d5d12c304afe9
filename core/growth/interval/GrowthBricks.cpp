// SPDX-License-Identifier: Apache-2.0
#include "core/growth/interval/GrowthBricks.h"

#include "core/base/ParallelFor.h"

#include <algorithm>
#include <set>
#include <utility>

namespace core {

namespace {

constexpr std::size_t perBrick = BrickGrid::voxelsPerBrick;
constexpr std::size_t bricksAtATime = 512; ///< bounds what reading takes beside what is kept

void append(std::vector<std::uint8_t>& all, const std::vector<std::uint8_t>& bytes)
{
    if (bytes.empty())
        all.resize(all.size() + perBrick, 0);
    else
        all.insert(all.end(), bytes.begin(), bytes.end());
}

glm::ivec3 placeInBrick(std::size_t offset)
{
    return {int(offset & 15u), int(offset >> 4 & 15u), int(offset >> 8)};
}

bool isOutside(const glm::ivec3& place, const VoxelBox& box)
{
    return glm::any(glm::greaterThanEqual(place, box.maximum - box.minimum));
}

/// −1, 0 or 1: over which side of its brick a voxel at this coordinate reaches.
int sideReached(int coordinate)
{
    return coordinate == 0 ? -1 : coordinate == BrickGrid::side - 1 ? 1 : 0;
}

} // namespace

GrowthBricks::GrowthBricks(
    const BrickGrid& grid, std::span<const std::uint32_t> held, const ReadGrowthBricks& read)
    : m_words(grid, held.size() + held.size() / 2)
{
    const std::size_t voxels = (held.size() + held.size() / 2) * perBrick;
    m_codes.reserve(voxels);
    m_labels.reserve(voxels);
    m_overwritten.reserve(voxels);
    add(held, read);
    add(touchedBricks(), read);
    m_words.link();
}

void GrowthBricks::add(std::span<const std::uint32_t> bricks, const ReadGrowthBricks& read)
{
    const std::vector<std::uint8_t> unvisited(perBrick * 4, 0xFF);
    const BrickGrid& grid = m_words.grid();
    for (std::size_t first = 0; first < bricks.size(); first += bricksAtATime) {
        const auto some = bricks.subspan(first, std::min(bricksAtATime, bricks.size() - first));
        const std::vector<GrowthBrick> contents = read(some);
        for (std::size_t i = 0; i < some.size(); ++i) {
            const GrowthBrick& content = contents[i];
            m_words.add(some[i], content.words.empty() ? unvisited : content.words);
            m_codes.insert(m_codes.end(), content.codes.begin(), content.codes.end());
            append(m_labels, content.labels);
            append(m_overwritten, content.overwritten);
            const VoxelBox box = grid.boxOf(int(some[i]));
            if (box.maximum - box.minimum == glm::ivec3(BrickGrid::side))
                continue;
            const auto start = Voxel((brickCount() - 1) << 12);
            for (std::size_t offset = 0; offset < perBrick; ++offset) {
                if (isOutside(placeInBrick(offset), box))
                    m_words.put(start + Voxel(offset), seedWord::barrier);
            }
        }
    }
}

/// Over which of its sides (x + 3 y + 9 z of −1, 0, 1, each + 1) members or seeds of a brick touch
/// others; one bit each.
std::uint32_t GrowthBricks::sidesTouched(std::size_t place) const
{
    std::uint32_t sides = 0;
    for (std::size_t offset = 0; offset < perBrick; ++offset) {
        const glm::ivec3 at = placeInBrick(offset);
        const glm::ivec3 reach(sideReached(at.x), sideReached(at.y), sideReached(at.z));
        if (reach == glm::ivec3(0))
            continue;
        const std::uint32_t word = m_words[Voxel(place << 12 | offset)];
        if (!seedWord::isMember(word) && !seedWord::isPendingSeed(word))
            continue;
        // Over a side, and with it over each edge and corner of which it is a part.
        for (int part = 1; part < 8; ++part) {
            const glm::ivec3 over = reach * glm::ivec3(part & 1, part >> 1 & 1, part >> 2);
            sides |= 1u << (over.x + 1 + 3 * (over.y + 1) + 9 * (over.z + 1));
        }
    }
    return sides;
}

std::vector<std::uint32_t> GrowthBricks::touchedBricks() const
{
    const BrickGrid& grid = m_words.grid();
    const glm::ivec3 bricks = grid.bricks();
    std::set<std::uint32_t> added;
    for (std::size_t place = 0; place < brickCount(); ++place)
        added.insert(m_words.brickOf(Voxel(place << 12)));
    std::vector<std::uint32_t> sides(brickCount());
    parallelFor(int(sides.size()),
        [&](int place) { sides[std::size_t(place)] = sidesTouched(std::size_t(place)); });
    std::set<std::uint32_t> touched;
    for (std::size_t place = 0; place < brickCount(); ++place) {
        const glm::ivec3 own = grid.brickPosition(int(m_words.brickOf(Voxel(place << 12))));
        for (int side = 0; side < 27; ++side) {
            const glm::ivec3 at = own + glm::ivec3(side % 3, side / 3 % 3, side / 9) - 1;
            if ((sides[place] >> side & 1u) == 0 || glm::any(glm::lessThan(at, glm::ivec3(0)))
                || glm::any(glm::greaterThanEqual(at, bricks)))
                continue;
            const auto brick = std::uint32_t(at.x + bricks.x * (at.y + bricks.y * at.z));
            if (!added.contains(brick))
                touched.insert(brick);
        }
    }
    return {touched.begin(), touched.end()};
}

void GrowthBricks::put(Voxel voxel, const State& state)
{
    m_words.put(voxel, state.word);
    m_labels[voxel] = state.label;
    m_overwritten[voxel] = state.overwritten;
}

void GrowthBricks::write(Voxel voxel, const State& state)
{
    m_log.push_back({voxel, at(voxel)});
    put(voxel, state);
}

void GrowthBricks::keep()
{
    for (const Former& former : m_log)
        m_kept.push_back(former.voxel);
    m_log.clear();
}

std::vector<GrowthChange> GrowthBricks::changes() const
{
    std::vector<GrowthChange> changes;
    changes.reserve(m_kept.size() + m_log.size());
    const auto add = [this, &changes](Voxel voxel) {
        changes.push_back({.brick = m_words.brickOf(voxel),
            .word = m_words[voxel],
            .labelsAndOffset = m_labels[voxel] | std::uint32_t(m_overwritten[voxel]) << 8
                | (voxel & 4095u) << 16});
    };
    for (const Voxel voxel : m_kept)
        add(voxel);
    for (const Former& former : m_log)
        add(former.voxel);
    return changes;
}

} // namespace core
