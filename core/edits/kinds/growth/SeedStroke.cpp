// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/growth/SeedStroke.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EngineEdits.h"

#include <utility>

namespace core {

using namespace rowWords;

Result<void> check(const SeedStroke& edit, const Document& document)
{
    return discardValue(seedPlacement(edit, document));
}

Result<bool> apply(const SeedStroke&, Document&)
{
    return false;
}

EditEffects effects(const SeedStroke& edit)
{
    return {.task = engineTask<SeedStroke>(),
        .standsOpen = false,
        .fills = {.label = edit.segment},
        .boundToStudy = true};
}

Result<SeedPlacement> seedPlacement(const SeedStroke& stroke, const Document& document)
{
    const Result<const Segment*> unlocked =
        unlockedSegment("seed.segment", stroke.segment, document);
    if (!unlocked)
        return tl::unexpected(unlocked.error());
    const Segment* segment = *unlocked;

    if (stroke.pointsLps.empty() && !stroke.takenLps)
        return failure(ErrorCode::InvalidField, QStringLiteral("seed.pointsLps"),
            Clause::saying("needs at least one entry where no seed is taken away"));
    const VolumeGeometry& geometry = document.volumes.front().geometry;
    Result<std::vector<glm::ivec3>> voxels = seedVoxels(stroke.pointsLps, geometry, "pointsLps");
    if (!voxels)
        return tl::unexpected(voxels.error());
    Result<std::vector<glm::ivec3>> taken =
        seedVoxels(stroke.takenLps.value_or(std::vector<glm::dvec3>()), geometry, "takenLps");
    if (!taken)
        return tl::unexpected(taken.error());
    return SeedPlacement{.plane = segment->plane,
        .label = segment->label,
        .voxels = *std::move(voxels),
        .taken = *std::move(taken)};
}

Result<EngineEdit> engineEdit(const SeedStroke& edit, const Document& document)
{
    return engineEditFrom(seedPlacement(edit, document));
}

RowTitle rowTitle(const SeedStroke& stroke, const RowFacts& row)
{
    const QString segment = segmentName(stroke.segment, row.document);
    if (stroke.takenLps && stroke.pointsLps.size() == stroke.takenLps->size()) {
        RowTitle title{.code = RowTitleCode::MoveSeeds,
            .arguments = {TitleCount{std::int64_t(stroke.pointsLps.size())}, segment}};
        if (row.sketched && !row.sketched->isPlain)
            title.then = {row.sketched->became};
        return title;
    }
    const RowTitle voxels = figure(RowTitleCode::Voxels, row.facts.seedWordsChanged);
    if (stroke.pointsLps.empty())
        return {.code = RowTitleCode::TakeSeedsAway, .arguments = {segment}, .then = {voxels}};
    return {.code = RowTitleCode::SeedStroke,
        .arguments = {segment},
        .then = {row.sketched ? row.sketched->became : voxels}};
}

/// The seed words of the bricks that its points lie in.
EditDependencies dependencies(const SeedStroke& edit, const DependencyFacts& row)
{
    std::vector<glm::dvec3> points = edit.pointsLps;
    if (edit.takenLps)
        points.insert(points.end(), edit.takenLps->begin(), edit.takenLps->end());
    dependsOn::Bricks bricks;
    if (const auto voxels = seedVoxels(points, row.geometry())) {
        for (const glm::ivec3& voxel : *voxels)
            bricks.keys.insert({Field::SeedWords, row.planeOf(edit.segment),
                std::uint32_t(row.grid().brickOf(voxel))});
    }
    return bricks;
}

} // namespace core
