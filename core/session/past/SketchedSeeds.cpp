// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/SketchedSeeds.h"

#include "core/edits/answers/RowWords.h"
#include "core/growth/SeedWord.h"

#include <set>
#include <tuple>

namespace core {

using namespace rowWords;

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

RowTitle sketchedTitle(const SketchedSeeds& seeds, const Document& document)
{
    const bool all = seeds.taken == seeds.voxels;
    RowTitle title = figure(all ? RowTitleCode::Voxels : RowTitleCode::VoxelsOf, seeds.voxels);
    if (!all)
        title.arguments.push_back(TitleCount{seeds.taken});
    if (!seeds.isPlain()) {
        title.code = all ? RowTitleCode::VoxelsBecause : RowTitleCode::VoxelsOfBecause;
        title.arguments.push_back(asArgument(whyNotTaken(seeds, document)));
    }
    return title;
}

RowTitle whyNotTaken(const SketchedSeeds& seeds, const Document& document)
{
    if (seeds.isPlain())
        return {};
    std::vector<RowTitle> reasons;
    const auto add = [&](RowTitleCode code, int label, std::int64_t count) {
        reasons.push_back(
            {.code = code, .arguments = {TitleCount{count}, segmentName(label, document)}});
    };
    for (const auto& [label, count] : seeds.members)
        add(label == seeds.segment ? RowTitleCode::BelongAlready : RowTitleCode::BelongTo, label,
            count);
    for (const auto& [label, count] : seeds.waiting) {
        if (label == seeds.segment)
            reasons.push_back(figure(RowTitleCode::SeedsAlready, count));
        else
            add(RowTitleCode::SeedsOfAnother, label, count);
    }
    if (seeds.barriers > 0)
        reasons.push_back(figure(RowTitleCode::ShutByBarrier, seeds.barriers));
    for (const auto& [label, count] : seeds.replaced)
        add(RowTitleCode::WereSeedsOf, label, count);
    return {.code = RowTitleCode::Reasons, .arguments = {reasons}};
}

} // namespace core
