// SPDX-License-Identifier: Apache-2.0
#include "core/session/ReadLabels.h"

#include <algorithm>
#include <utility>

namespace core {

namespace {

/// Copies the voxels of a brick to their place among the labels of the whole volume.
void place(const BrickChange& brick, const BrickGrid& grid, const glm::ivec3& size,
    std::vector<std::uint8_t>& labels)
{
    const VoxelBox box = grid.boxOf(int(brick.key.brick));
    const int width = box.maximum.x - box.minimum.x;
    for (int z = box.minimum.z; z < box.maximum.z; ++z) {
        for (int y = box.minimum.y; y < box.maximum.y; ++y) {
            const std::size_t from = std::size_t(BrickGrid::offsetInBrick({box.minimum.x, y, z}));
            const std::size_t to = std::size_t(box.minimum.x)
                + std::size_t(size.x) * (std::size_t(y) + std::size_t(size.y) * std::size_t(z));
            std::copy_n(&brick.after[from], width, &labels[to]);
        }
    }
}

} // namespace

Result<std::vector<std::uint8_t>> readLabels(OperationQueue& queue, std::uint8_t plane)
{
    const glm::ivec3 size = queue.state().document.volumes.front().geometry.size;
    const BrickGrid grid{size};
    std::vector<std::uint8_t> labels(
        std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    // In portions, so that a large volume is not there twice.
    constexpr int portion = 1024;
    std::optional<Error> error;
    for (int first = 0; first < grid.brickCount(); first += portion) {
        ReadBricks read;
        for (int brick = first; brick < std::min(first + portion, grid.brickCount()); ++brick)
            read.keys.push_back({Field::Labels, plane, std::uint32_t(brick)});
        bool answered = false;
        queue.ask(std::move(read), [&](const EngineResult& result) {
            answered = true;
            if (result.error)
                error = result.error;
            for (const BrickChange& brick : result.changes) {
                if (!brick.after.empty())
                    place(brick, grid, size, labels);
            }
        });
        while (!answered) {
            queue.state().engine.finish();
            queue.poll();
        }
    }
    if (error)
        return tl::unexpected(*error);
    return labels;
}

} // namespace core
