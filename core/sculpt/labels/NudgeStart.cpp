// SPDX-License-Identifier: Apache-2.0
#include "core/sculpt/labels/NudgeStart.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace core {

namespace {

constexpr std::int64_t noneSquared = std::numeric_limits<std::int64_t>::max();
constexpr std::int32_t leastFitting = 1024; ///< mm16
constexpr std::int32_t radiusGrain = 64; ///< mm16

/// The smallest d² of the voxels on each side of the border.
struct NearestVoxels {
    std::int64_t ofSegment = noneSquared;
    std::int64_t ofOthers = noneSquared;
};

std::int64_t rootDown(std::int64_t square)
{
    auto root = std::int64_t(std::sqrt(double(square)));
    while (root * root > square)
        --root;
    while ((root + 1) * (root + 1) <= square)
        ++root;
    return root;
}

std::int64_t roundingMargin(const CapsuleFrame& frame)
{
    return std::int64_t(2) << frame.shift;
}

/// Rule 1, in one brick.
void lookFrom(const glm::ivec3& centre, const CapsuleFrame& frame, const BrickGrid& grid,
    std::uint8_t label, const BrickImage& image, NearestVoxels& nearest)
{
    const VoxelBox box = grid.boxOf(int(image.key.brick));
    const glm::ivec3 base = strokeBase(frame, box.minimum);
    const glm::ivec3 perI = strokeStep(frame.perI);
    const glm::ivec3 perJ = strokeStep(frame.perJ);
    const glm::ivec3 perK = strokeStep(frame.perK);
    const std::int64_t reach = frame.radius + roundingMargin(frame);
    const glm::ivec3 size = box.maximum - box.minimum;
    const std::uint8_t* labels = image.bytes.empty() ? nullptr : image.bytes.read().data();
    for (int z = 0; z < size.z; ++z) {
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                const glm::ivec3 p = base + x * perI + y * perJ + z * perK;
                if (std::abs(p.z) > frame.halfThickness)
                    continue;
                const std::int64_t awayX = std::int64_t(p.x) - centre.x;
                const std::int64_t awayY = std::int64_t(p.y) - centre.y;
                // Farther than that on one axis, and no square can overflow.
                if (std::abs(awayX) > reach || std::abs(awayY) > reach)
                    continue;
                const std::int64_t squared = awayX * awayX + awayY * awayY;
                if (squared > reach * reach)
                    continue;
                const auto offset =
                    std::size_t(BrickGrid::offsetInBrick(box.minimum + glm::ivec3(x, y, z)));
                const bool isSegments = labels && labels[offset] == label;
                std::int64_t& least = isSegments ? nearest.ofSegment : nearest.ofOthers;
                least = std::min(least, squared);
            }
        }
    }
}

} // namespace

NudgeStart nudgeStart(const CapsuleFrame& frame, const glm::ivec3& centre, const BrickGrid& grid,
    std::uint8_t label, const std::vector<BrickImage>& near)
{
    NearestVoxels nearest;
    for (const BrickImage& image : near)
        lookFrom(centre, frame, grid, label, image, nearest);
    NudgeStart start;
    start.isInside = nearest.ofSegment != noneSquared && nearest.ofSegment <= nearest.ofOthers;
    const std::int64_t across = start.isInside ? nearest.ofOthers : nearest.ofSegment;
    std::int64_t fitting = frame.radius;
    if (across != noneSquared) {
        const std::int64_t least = std::max(frame.rampHalfWidth / 2, leastFitting);
        fitting = std::min(fitting, std::max(rootDown(across) - roundingMargin(frame), least));
    }
    start.fittingRadius = std::int32_t(fitting / radiusGrain * radiusGrain);
    return start;
}

} // namespace core
