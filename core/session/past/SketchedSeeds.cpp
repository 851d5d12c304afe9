// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/SketchedSeeds.h"

#include "core/growth/SeedWord.h"
#include "core/session/past/RowWords.h"

#include <QStringList>

#include <algorithm>
#include <set>
#include <tuple>

namespace core {

using namespace rowWords;

namespace {

std::uint32_t wordAt(const std::vector<std::uint8_t>& image, const glm::ivec3& voxel)
{
    if (image.empty())
        return seedWord::unvisited;
    const std::uint8_t* bytes = &image[std::size_t(4) * BrickGrid::offsetInBrick(voxel)];
    return std::uint32_t(bytes[0]) | std::uint32_t(bytes[1]) << 8 | std::uint32_t(bytes[2]) << 16
        | std::uint32_t(bytes[3]) << 24;
}

/// "1 was a seed", "2 were seeds".
QString either(std::int64_t count, const char* one, const char* more)
{
    return grouped(count) + QLatin1Char(' ') + QLatin1String(count == 1 ? one : more);
}

} // namespace

std::vector<BrickKey> wordBricks(const SeedPlacement& stroke, const BrickGrid& grid)
{
    std::set<std::uint32_t> bricks;
    for (const glm::ivec3& voxel : stroke.voxels)
        bricks.insert(std::uint32_t(grid.brickOf(voxel)));
    std::vector<BrickKey> keys;
    for (const std::uint32_t brick : bricks)
        keys.push_back({Field::SeedWords, stroke.plane, brick});
    return keys;
}

SketchedSeeds sketchedSeeds(
    const SeedPlacement& stroke, const BrickGrid& grid, const std::vector<BrickChange>& before)
{
    std::map<std::uint32_t, const std::vector<std::uint8_t>*> images;
    for (const BrickChange& brick : before)
        images[brick.key.brick] = &brick.after;
    const auto triple = [](const glm::ivec3& voxel) {
        return std::tuple(voxel.x, voxel.y, voxel.z);
    };
    std::set<std::tuple<int, int, int>> takenAway;
    for (const glm::ivec3& voxel : stroke.taken)
        takenAway.insert(triple(voxel));

    const std::uint32_t seed = seedWord::pendingSeed(stroke.label);
    SketchedSeeds seeds{.segment = stroke.label, .voxels = std::int64_t(stroke.voxels.size())};
    for (const glm::ivec3& voxel : stroke.voxels) {
        const auto image = images.find(std::uint32_t(grid.brickOf(voxel)));
        std::uint32_t word =
            image == images.end() ? seedWord::unvisited : wordAt(*image->second, voxel);
        if (word == seed && takenAway.contains(triple(voxel)))
            word = seedWord::unvisited;
        const int label = int(seedWord::label(word));
        if (word == seedWord::barrier) {
            ++seeds.barriers;
        } else if (seedWord::isMember(word)) {
            ++seeds.members[label];
        } else if (word <= seed) {
            ++seeds.waiting[label];
        } else {
            ++seeds.taken;
            if (seedWord::isPendingSeed(word))
                ++seeds.replaced[label];
        }
    }
    return seeds;
}

QString sketchedText(const SketchedSeeds& seeds, const Document& document)
{
    const QString voxels = counted(seeds.voxels, "voxel");
    const QString why = whyNotTaken(seeds, document);
    return (seeds.taken == seeds.voxels
                   ? voxels
                   : QStringLiteral("%1 of %2").arg(grouped(seeds.taken), voxels))
        + (why.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(why));
}

QString whyNotTaken(const SketchedSeeds& seeds, const Document& document)
{
    QStringList reasons;
    for (const auto& [label, count] : seeds.members)
        reasons += either(count, "belongs to ", "belong to ") + quoted(segmentName(label, document))
            + (label == seeds.segment ? QStringLiteral(" already") : QString());
    for (const auto& [label, count] : seeds.waiting) {
        if (label == seeds.segment)
            reasons += either(count, "is a seed already", "are seeds already");
        else
            reasons += either(count, "is a seed of ", "are seeds of ")
                + quoted(segmentName(label, document));
    }
    if (seeds.barriers > 0)
        reasons += either(seeds.barriers, "is shut by a barrier", "are shut by a barrier");
    for (const auto& [label, count] : seeds.replaced)
        reasons += either(count, "was a seed of ", "were seeds of ")
            + quoted(segmentName(label, document));
    return reasons.join(QStringLiteral("; ")); // a comma would end a row's title
}

} // namespace core
