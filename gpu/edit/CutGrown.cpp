// SPDX-License-Identifier: Apache-2.0
#include "gpu/edit/CutGrown.h"

#include "core/growth/GrowthCut.h"
#include "gpu/edit/BrickImages.h"

namespace gpu {

namespace {

core::WordBricks readWords(VoxelFields& fields, std::uint8_t plane)
{
    const std::vector<std::uint32_t> held = fields.seedWords(plane).heldBricks();
    core::WordBricks words(fields.grid(), held.size());
    const auto images =
        fields.copier().images(fields.textures(core::Field::SeedWords, plane), held);
    for (std::size_t i = 0; i < held.size(); ++i) {
        if (!images[i].empty())
            words.add(held[i], images[i]);
    }
    words.link();
    return words;
}

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

} // namespace

CutOutcome cutGrown(VoxelFields& fields, BeforeImages& before, const core::CutGrowth& command)
{
    CutOutcome outcome{.keys = {}, .generation = command.generation};
    if (fields.seedWords(command.plane).empty())
        return outcome;
    const core::GrowthCutOutcome cut = core::cutGrowth(readWords(fields, command.plane), command);
    outcome.generation = cut.generation;

    std::vector<std::uint32_t> bricks;
    std::vector<core::BrickKey> labelKeys;
    for (const core::CutBrick& brick : cut.bricks) {
        bricks.push_back(brick.brick);
        labelKeys.push_back(
            {.field = core::Field::Labels, .plane = command.plane, .brick = brick.brick});
    }
    const auto labels = readImages(fields, labelKeys);
    std::vector<std::uint32_t> losing;
    std::vector<core::BrickImage> images;
    for (std::size_t i = 0; i < bricks.size(); ++i) {
        const core::CutBrick& brick = cut.bricks[i];
        images.push_back(
            {.key = {.field = core::Field::SeedWords, .plane = command.plane, .brick = brick.brick},
                .bytes = bytesOf(brick.words)});
        std::vector<std::uint8_t> kept = labels[i];
        bool loses = false;
        for (std::size_t voxel = 0; voxel < kept.size(); ++voxel) {
            if (brick.leaving[voxel] == 0 || kept[voxel] != brick.leaving[voxel])
                continue;
            kept[voxel] = 0;
            loses = true;
        }
        if (!loses)
            continue;
        losing.push_back(brick.brick);
        images.push_back({.key = labelKeys[i], .bytes = std::move(kept)});
    }
    before.capture(core::Field::SeedWords, command.plane, bricks);
    before.capture(core::Field::Labels, command.plane, losing);
    for (const core::BrickImage& image : images)
        outcome.keys.push_back(image.key);
    writeImages(fields, std::move(images));
    return outcome;
}

} // namespace gpu
