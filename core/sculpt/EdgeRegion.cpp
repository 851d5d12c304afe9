// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/EdgeRegion.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace core {

namespace {

constexpr std::int32_t mostCodes = 65535;

bool contains(const BrickGrid& grid, const glm::ivec3& voxel)
{
    return glm::all(glm::greaterThanEqual(voxel, glm::ivec3(0)))
        && glm::all(glm::lessThan(voxel, grid.volumeSize));
}

bool bit(const EdgeRegion::Bits& bits, int offset)
{
    return (bits[std::size_t(offset) / 32] >> (offset % 32) & 1u) != 0;
}

void setBit(EdgeRegion::Bits& bits, int offset)
{
    bits[std::size_t(offset) / 32] |= 1u << (offset % 32);
}

glm::ivec3 voxelAt(const VoxelBox& brick, int offset)
{
    return brick.minimum + glm::ivec3(offset & 15, offset >> 4 & 15, offset >> 8);
}

/// Rule 3.
std::vector<glm::ivec3> stepsOf(const CapsuleFrame& frame)
{
    const int main = steepestAxis(frame);
    std::vector<glm::ivec3> steps;
    for (int z = -1; z <= 1; ++z) {
        for (int y = -1; y <= 1; ++y) {
            for (int x = -1; x <= 1; ++x) {
                const glm::ivec3 step(x, y, z);
                const int changed = std::abs(x) + std::abs(y) + std::abs(z);
                const int others = changed - std::abs(step[main]);
                if (changed > 0 && (frame.isFlat ? others <= 1 : changed == 1))
                    steps.push_back(step);
            }
        }
    }
    return steps;
}

} // namespace

bool isSound(const EdgeRule& rule, const BrickGrid& grid)
{
    return contains(grid, rule.start) && rule.tolerance >= 0 && rule.tolerance <= mostCodes;
}

VoxelBox edgeValueBox(const EdgeRule& rule, const BrickGrid& grid)
{
    return {glm::max(rule.start - 1, glm::ivec3(0)), glm::min(rule.start + 2, grid.volumeSize)};
}

int edgeValue(const EdgeRule& rule, const CapsuleFrame& frame, const BrickGrid& grid,
    std::span<const std::uint16_t> codes)
{
    const VoxelBox box = edgeValueBox(rule, grid);
    std::vector<int> counted;
    std::size_t next = 0;
    for (int z = box.minimum.z; z < box.maximum.z; ++z) {
        for (int y = box.minimum.y; y < box.maximum.y; ++y) {
            for (int x = box.minimum.x; x < box.maximum.x; ++x) {
                const int code = codes[next++];
                const glm::ivec3 voxel(x, y, z);
                if (voxel == rule.start || isInSlab(frame, voxel))
                    counted.push_back(code);
            }
        }
    }
    const auto median = counted.begin() + std::ptrdiff_t((counted.size() - 1) / 2);
    std::nth_element(counted.begin(), median, counted.end());
    return *median;
}

EdgeRegion::EdgeRegion(const CapsuleFrame& frame, const BrickGrid& grid)
    : m_grid(grid)
    , m_steps(stepsOf(frame))
{
}

EdgeRegion::Brick* EdgeRegion::brickAt(const glm::ivec3& voxel)
{
    const auto number = std::uint32_t(m_grid.brickOf(voxel));
    if (number != m_lastNumber || !m_last) {
        const auto found = m_bricks.find(number);
        m_lastNumber = number;
        m_last = found == m_bricks.end() ? nullptr : &found->second;
    }
    return m_last;
}

bool EdgeRegion::isMember(const glm::ivec3& voxel)
{
    if (!contains(m_grid, voxel))
        return false;
    const Brick* brick = brickAt(voxel);
    return brick && bit(brick->members, BrickGrid::offsetInBrick(voxel));
}

void EdgeRegion::reach(const glm::ivec3& voxel)
{
    if (!contains(m_grid, voxel))
        return;
    Brick* brick = brickAt(voxel);
    const int offset = BrickGrid::offsetInBrick(voxel);
    if (!brick || !bit(brick->alike, offset) || bit(brick->members, offset))
        return;
    setBit(brick->members, offset);
    setBit(m_new[std::uint32_t(m_grid.brickOf(voxel))], offset);
    m_front.push_back(voxel);
}

void EdgeRegion::addAlike(std::uint32_t number, const Bits& alike)
{
    Brick& brick = m_bricks[number];
    m_last = nullptr;
    Bits added{};
    for (std::size_t word = 0; word < alike.size(); ++word) {
        added[word] = alike[word] & ~brick.alike[word];
        brick.alike[word] |= alike[word];
    }
    const VoxelBox box = m_grid.boxOf(int(number));
    for (int offset = 0; offset < BrickGrid::voxelsPerBrick; ++offset) {
        if (added[std::size_t(offset) / 32] == 0) {
            offset += 31; // words begin at multiples of 32
            continue;
        }
        if (!bit(added, offset))
            continue;
        const glm::ivec3 voxel = voxelAt(box, offset);
        if (bit(brick.under, offset)
            || std::any_of(m_steps.begin(), m_steps.end(),
                [&](const glm::ivec3& step) { return isMember(voxel + step); }))
            reach(voxel);
    }
}

void EdgeRegion::addUnder(const std::vector<glm::ivec3>& voxels)
{
    m_last = nullptr;
    for (const glm::ivec3& voxel : voxels) {
        if (!contains(m_grid, voxel))
            continue;
        Brick& brick = m_bricks[std::uint32_t(m_grid.brickOf(voxel))];
        setBit(brick.under, BrickGrid::offsetInBrick(voxel));
        m_last = nullptr;
        reach(voxel);
    }
}

std::map<std::uint32_t, EdgeRegion::Bits> EdgeRegion::takeNew()
{
    while (!m_front.empty()) {
        const glm::ivec3 voxel = m_front.back();
        m_front.pop_back();
        for (const glm::ivec3& step : m_steps)
            reach(voxel + step);
    }
    return std::exchange(m_new, {});
}

} // namespace core
