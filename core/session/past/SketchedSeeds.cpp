// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/SketchedSeeds.h"

#include "core/edits/answers/RowWords.h"
#include "core/growth/SeedWord.h"

#include <QStringList>

#include <algorithm>
#include <set>
#include <tuple>

namespace core {

using namespace rowWords;

namespace {

/// "1 was a seed", "2 were seeds".
QString either(std::int64_t count, const char* one, const char* more)
{
    return grouped(count) + QLatin1Char(' ') + QLatin1String(count == 1 ? one : more);
}

} // namespace

SketchedSeeds sketchedSeeds(const SeedPlacement& stroke, const std::vector<std::uint32_t>& before)
{
    const auto triple = [](const glm::ivec3& voxel) {
        return std::tuple(voxel.x, voxel.y, voxel.z);
    };
    std::set<std::tuple<int, int, int>> takenAway;
    for (const glm::ivec3& voxel : stroke.taken)
        takenAway.insert(triple(voxel));

    const std::uint32_t seed = seedWord::pendingSeed(stroke.label);
    SketchedSeeds seeds{.segment = stroke.label, .voxels = std::int64_t(stroke.voxels.size())};
    for (std::size_t i = 0; i < stroke.voxels.size(); ++i) {
        std::uint32_t word = before[i];
        if (word == seed && takenAway.contains(triple(stroke.voxels[i])))
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
