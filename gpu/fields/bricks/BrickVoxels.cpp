// SPDX-License-Identifier: Apache-2.0
#include "gpu/fields/bricks/BrickVoxels.h"

#include <algorithm>

namespace gpu {

namespace {

constexpr int sideOfBrick = core::BrickGrid::side;

/// The part of a brick that lies in the volume.
struct Part {
    glm::ivec3 origin{0};
    glm::ivec3 size{0};

    [[nodiscard]] std::size_t voxels() const
    {
        return std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
    }
    [[nodiscard]] bool isWhole() const { return size == glm::ivec3(sideOfBrick); }
    /// Calls work(inBrick, inPart) with the place of the first voxel of each row.
    template <typename Work> void forEachRow(const Work& work) const
    {
        std::size_t inPart = 0;
        for (int z = 0; z < size.z; ++z) {
            for (int y = 0; y < size.y; ++y) {
                work(std::size_t(core::BrickGrid::offsetInBrick({0, y, z})), inPart);
                inPart += std::size_t(size.x);
            }
        }
    }
};

Part partOf(const core::BrickGrid& grid, std::uint32_t brick)
{
    const core::VoxelBox box = grid.boxOf(int(brick));
    return {.origin = box.minimum, .size = box.maximum - box.minimum};
}

/// The codes of a brick out of those of its row.
/// @param left where it begins in the row
std::vector<std::uint16_t> codesOfBrick(
    const std::vector<std::uint16_t>& row, const glm::ivec3& rowSize, int left)
{
    std::vector<std::uint16_t> codes(core::BrickGrid::voxelsPerBrick, 0);
    const int width = std::min(sideOfBrick, rowSize.x - left);
    for (int z = 0; z < rowSize.z; ++z) {
        for (int y = 0; y < rowSize.y; ++y)
            std::copy_n(row.begin() + left + rowSize.x * (y + rowSize.y * z), width,
                codes.begin() + core::BrickGrid::offsetInBrick({0, y, z}));
    }
    return codes;
}

} // namespace

void readDense(const Texture3D& texture, const core::BrickGrid& grid, std::uint32_t brick,
    std::span<std::uint8_t> voxels)
{
    const Part part = partOf(grid, brick);
    if (part.isWhole()) {
        texture.read(part.origin, part.size, std::as_writable_bytes(voxels));
        return;
    }
    std::vector<std::uint8_t> within(part.voxels());
    texture.read(part.origin, part.size, std::as_writable_bytes(std::span(within)));
    std::fill(voxels.begin(), voxels.end(), std::uint8_t(0));
    part.forEachRow([&](std::size_t inBrick, std::size_t inPart) {
        std::copy_n(&within[inPart], part.size.x, &voxels[inBrick]);
    });
}

void writeDense(const Texture3D& texture, const core::BrickGrid& grid, std::uint32_t brick,
    std::span<const std::uint8_t> voxels)
{
    const Part part = partOf(grid, brick);
    if (part.isWhole()) {
        texture.upload(part.origin, part.size, std::as_bytes(voxels));
        return;
    }
    std::vector<std::uint8_t> within(part.voxels());
    part.forEachRow([&](std::size_t inBrick, std::size_t inPart) {
        std::copy_n(&voxels[inBrick], part.size.x, &within[inPart]);
    });
    texture.upload(part.origin, part.size, std::as_bytes(std::span(within)));
}

std::vector<std::vector<std::uint16_t>> readCodes(
    const Texture3D& texture, const core::BrickGrid& grid, std::span<const std::uint32_t> bricks)
{
    std::vector<std::vector<std::uint16_t>> codes;
    codes.reserve(bricks.size());
    std::vector<std::uint16_t> row;
    // Bricks that follow each other in a row are read at once: reading a few voxels takes a driver
    // that computes on the processor hardly less time than reading many.
    for (std::size_t first = 0; first < bricks.size();) {
        std::size_t last = first + 1;
        while (last < bricks.size() && bricks[last] == bricks[last - 1] + 1
            && grid.brickPosition(int(bricks[last])).x > 0)
            ++last;
        const core::VoxelBox box =
            grid.boxOf(int(bricks[first])).united(grid.boxOf(int(bricks[last - 1])));
        const glm::ivec3 size = box.maximum - box.minimum;
        row.resize(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
        texture.read(box.minimum, size, std::as_writable_bytes(std::span<std::uint16_t>(row)));
        for (std::size_t i = first; i < last; ++i)
            codes.push_back(codesOfBrick(row, size, sideOfBrick * int(i - first)));
        first = last;
    }
    return codes;
}

} // namespace gpu
