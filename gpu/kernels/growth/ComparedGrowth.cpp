// SPDX-License-Identifier: Apache-2.0
#include "gpu/kernels/growth/ComparedGrowth.h"

#include "core/growth/SeedWord.h"
#include "gpu/fields/BrickImages.h"

#include <utility>

namespace gpu {

namespace {

constexpr std::size_t perBrick = core::BrickGrid::voxelsPerBrick;

/// The labels of a brick; no bytes mean that no voxel has one.
const std::vector<std::uint8_t>& labelsOf(const core::BrickBytes& image)
{
    static const std::vector<std::uint8_t> none(perBrick, 0);
    return image.empty() ? none : image.read();
}

bool isMemberIn(const std::vector<std::uint8_t>& words, std::size_t voxel)
{
    return !words.empty() && core::seedWord::isMember(core::seedWord::wordAt(&words[4 * voxel]));
}

} // namespace

ComparedGrowth compareGrowth(VoxelFields& fields, BeforeImages& before, std::uint8_t plane,
    const std::vector<core::BrickKey>& touched)
{
    std::vector<core::BrickKey> labels;
    for (const core::BrickKey& key : touched) {
        if (key.field == core::Field::Labels && key.plane == plane)
            labels.push_back(key);
    }
    return compareGrowth(fields, plane, before.changes(std::move(labels)));
}

ComparedGrowth compareGrowth(
    VoxelFields& fields, std::uint8_t plane, std::span<const core::BrickChange> changes)
{
    std::vector<const core::BrickChange*> labels;
    std::vector<core::BrickKey> keys;
    for (const core::BrickChange& change : changes) {
        if (change.key.field != core::Field::Labels || change.key.plane != plane)
            continue;
        labels.push_back(&change);
        keys.push_back(
            {.field = core::Field::SeedWords, .plane = plane, .brick = change.key.brick});
    }
    const std::vector<std::vector<std::uint8_t>> words = readImages(fields, keys);

    ComparedGrowth compared;
    compared.bricks.reserve(labels.size());
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const std::vector<std::uint8_t>& former = labelsOf(labels[i]->before);
        const std::vector<std::uint8_t>& now = labelsOf(labels[i]->after);
        std::vector<std::uint8_t> marks(perBrick, PreviewMarks::None);
        for (std::size_t voxel = 0; voxel < perBrick; ++voxel) {
            if (former[voxel] == now[voxel])
                continue;
            const bool isReached = isMemberIn(words[i], voxel);
            marks[voxel] = isReached ? PreviewMarks::Reached : PreviewMarks::Suspended;
            ++(isReached ? compared.counts.reached : compared.counts.suspended);
        }
        compared.bricks.push_back({.brick = labels[i]->key.brick, .marks = std::move(marks)});
    }
    return compared;
}

} // namespace gpu
