// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/shrink/CutGrown.h"

#include "gpu/fields/BrickImages.h"

#include <map>
#include <utility>

namespace gpu {

namespace {

std::vector<std::uint8_t> bytesOf(const std::vector<std::uint32_t>& words)
{
    std::vector<std::uint8_t> bytes;
    bytes.reserve(4 * words.size());
    for (const std::uint32_t word : words) {
        for (int shift = 0; shift < 32; shift += 8)
            bytes.push_back(std::uint8_t(word >> shift));
    }
    return bytes;
}

/// What a field holds in the bricks that a cut writes.
std::vector<core::BrickImage> imagesOf(VoxelFields& fields,
    const std::vector<core::CutBrick>& bricks, core::Field field, std::uint8_t plane)
{
    std::vector<core::BrickKey> keys;
    for (const core::CutBrick& brick : bricks)
        keys.push_back({.field = field, .plane = plane, .brick = brick.brick});
    return imagesNow(fields, keys);
}

} // namespace

core::WordBricks readWords(VoxelFields& fields, std::uint8_t plane)
{
    const std::vector<std::uint32_t> held = fields.seedWords(plane).heldBricks();
    core::WordBricks words(fields.grid(), held.size());
    if (held.empty())
        return words;
    const auto images =
        fields.copier().images(fields.textures(core::Field::SeedWords, plane), held);
    for (std::size_t i = 0; i < held.size(); ++i) {
        if (!images[i].empty())
            words.add(held[i], images[i]);
    }
    words.link();
    return words;
}

std::vector<core::BrickKey> writeCut(VoxelFields& fields, BeforeImages& before, std::uint8_t plane,
    const std::vector<core::CutBrick>& bricks)
{
    const std::vector<core::BrickImage> held = imagesOf(fields, bricks, core::Field::Labels, plane);
    const std::vector<core::BrickImage> overwritten =
        imagesOf(fields, bricks, core::Field::Overwritten, plane);
    std::vector<core::BrickImage> images;
    for (std::size_t i = 0; i < bricks.size(); ++i) {
        const core::CutBrick& brick = bricks[i];
        images.push_back(
            {.key = {.field = core::Field::SeedWords, .plane = plane, .brick = brick.brick},
                .bytes = bytesOf(brick.words)});
        std::vector<std::uint8_t> kept = held[i].bytes.read();
        std::vector<std::uint8_t> below = overwritten[i].bytes.read();
        for (std::size_t voxel = 0; voxel < kept.size(); ++voxel) {
            if (brick.leaving[voxel] == 0 || kept[voxel] != brick.leaving[voxel])
                continue;
            kept[voxel] = below.empty() ? std::uint8_t(0) : std::exchange(below[voxel], 0);
        }
        if (kept != held[i].bytes.read())
            images.push_back({.key = held[i].key, .bytes = std::move(kept)});
        if (below != overwritten[i].bytes.read())
            images.push_back({.key = overwritten[i].key, .bytes = std::move(below)});
    }
    std::map<core::Field, std::vector<std::uint32_t>> written;
    for (const core::BrickImage& image : images)
        written[image.key.field].push_back(image.key.brick);
    for (const auto& [field, numbers] : written)
        before.capture(field, plane, numbers);
    std::vector<core::BrickKey> keys;
    for (const core::BrickImage& image : images)
        keys.push_back(image.key);
    writeImages(fields, std::move(images));
    return keys;
}

core::Result<CutOutcome> cutGrown(
    VoxelFields& fields, BeforeImages& before, const core::CutGrowth& command)
{
    const core::Result<core::GrowthCutOutcome> cut =
        core::cutGrowth(readWords(fields, command.plane), command);
    if (!cut)
        return tl::unexpected(cut.error());
    return CutOutcome{.keys = writeCut(fields, before, command.plane, cut->bricks),
        .generation = cut->generation};
}

} // namespace gpu
