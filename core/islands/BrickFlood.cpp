// SPDX-License-Identifier: Apache-2.0
#include "core/islands/BrickFlood.h"

#include <cstdlib>
#include <utility>

namespace core {

namespace {

std::vector<glm::ivec3> stepsOf(const BrickFlood::Rule& rule)
{
    std::vector<glm::ivec3> steps;
    for (int z = -1; z <= 1; ++z) {
        for (int y = -1; y <= 1; ++y) {
            for (int x = -1; x <= 1; ++x) {
                const glm::ivec3 step(x, y, z);
                const int sides = std::abs(x) + std::abs(y) + std::abs(z);
                const int counted = rule.across ? sides - std::abs(step[*rule.across]) : sides;
                const bool leaves = rule.within && step[alongOf(*rule.within)] != 0;
                if (sides > 0 && (counted <= 1 || rule.corners) && !leaves)
                    steps.push_back(step);
            }
        }
    }
    return steps;
}

bool isIn(const glm::ivec3& voxel, const VoxelBox& box)
{
    return voxel.x >= box.minimum.x && voxel.y >= box.minimum.y && voxel.z >= box.minimum.z
        && voxel.x < box.maximum.x && voxel.y < box.maximum.y && voxel.z < box.maximum.z;
}

} // namespace

BrickFlood::BrickFlood(const glm::ivec3& volumeSize, const glm::ivec3& first, const Rule& rule)
    : m_grid{volumeSize}
    , m_steps(stepsOf(rule))
{
    reach(first);
}

bool BrickFlood::wasGiven(std::uint32_t brick) const
{
    const auto known = m_bricks.find(brick);
    return known != m_bricks.end() && known->second.given;
}

void BrickFlood::give(std::uint32_t brick, const BrickBits& voxels)
{
    Brick& its = m_bricks[brick];
    its.given = true;
    its.possible = voxels;
    if (m_wanted.erase(brick) > 0)
        m_due.push_back(brick);
}

bool BrickFlood::spread(const Progress& progress)
{
    while (!m_due.empty()) {
        if (progress.cancelled())
            return false;
        const std::uint32_t brick = m_due.back();
        m_due.pop_back();
        spreadIn(brick);
    }
    return true;
}

std::map<std::uint32_t, BrickBits> BrickFlood::found() const
{
    std::map<std::uint32_t, BrickBits> all;
    for (const auto& [number, brick] : m_bricks) {
        if (brick.found != BrickBits())
            all.emplace(number, brick.found);
    }
    return all;
}

void BrickFlood::reach(const glm::ivec3& voxel)
{
    const auto number = std::uint32_t(m_grid.brickOf(voxel));
    const auto offset = std::size_t(BrickGrid::offsetInBrick(voxel));
    Brick& brick = m_bricks[number];
    if (brick.reached.has(offset) || brick.found.has(offset)
        || (brick.given && !brick.possible.has(offset)))
        return;
    brick.reached.add(offset);
    if (brick.given)
        m_due.push_back(number);
    else
        m_wanted.insert(number);
}

void BrickFlood::spreadIn(std::uint32_t number)
{
    Brick& brick = m_bricks.at(number);
    const VoxelBox box = m_grid.boxOf(int(number));
    std::vector<glm::ivec3> waiting;
    const auto find = [&](const glm::ivec3& voxel) {
        const auto offset = std::size_t(BrickGrid::offsetInBrick(voxel));
        if (!brick.possible.has(offset) || brick.found.has(offset))
            return;
        brick.found.add(offset);
        waiting.push_back(voxel);
    };
    std::exchange(brick.reached, BrickBits()).forEach([&](std::size_t offset) {
        constexpr std::size_t side = BrickGrid::side;
        find(box.minimum
            + glm::ivec3(int(offset % side), int(offset / side % side), int(offset / side / side)));
    });
    const VoxelBox volume{.minimum = glm::ivec3(0), .maximum = m_grid.volumeSize};
    while (!waiting.empty()) {
        const glm::ivec3 voxel = waiting.back();
        waiting.pop_back();
        for (const glm::ivec3& step : m_steps) {
            const glm::ivec3 next = voxel + step;
            if (isIn(next, box))
                find(next);
            else if (isIn(next, volume))
                reach(next);
        }
    }
}

} // namespace core
