// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/CleanSegment.h"

#include "core/brick/BrickGrid.h"
#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/parts/SegmentChoice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace core {

using namespace rowWords;

namespace {

Result<LabelTarget> targetOf(const CleanSegment& edit, const Document& document)
{
    return labelTarget({.segment = edit.segment, .name = {}}, false, document);
}

/// IslandRule's number of voxels.
std::int64_t voxelsOf(const CleanSegment& edit, const VolumeGeometry& geometry)
{
    if (!edit.mm3)
        return std::numeric_limits<std::int64_t>::max();
    const glm::dvec3 spacing = geometry.spacingMm();
    constexpr double most = 1e15; // more than any volume has, and fits an integer
    const double voxels = std::min(most, *edit.mm3 / (spacing.x * spacing.y * spacing.z));
    // A hair's breadth of rounding must not decide about a part that is just as large.
    constexpr double slack = 1e-6;
    return std::int64_t(edit.rule == IslandRule::FillHoles ? std::floor(voxels + slack)
                                                           : std::ceil(voxels - slack));
}

} // namespace

Result<void> check(const CleanSegment& edit, const Document& document)
{
    if (edit.rule == IslandRule::RemoveSmall && !edit.mm3)
        return failure(ErrorCode::InvalidField, QStringLiteral("cleanSegment.mm3"),
            QStringLiteral("is needed to tell which islands are small"));
    return discardValue(targetOf(edit, document));
}

Result<bool> apply(const CleanSegment&, Document&)
{
    return false;
}

EditEffects effects(const CleanSegment& edit)
{
    return {.task = EditTask::Islands,
        .standsOpen = false,
        .writesTo = edit.segment,
        .fills = {.label = edit.segment}};
}

RowTitle rowTitle(const CleanSegment& edit, const RowFacts& row)
{
    const Segment* segment = row.document.segment(edit.segment);
    const LabelFlow flow = row.facts.flow(segment ? segment->plane : std::uint8_t(0), edit.segment);
    RowTitle title{.code = RowTitleCode::FillHoles,
        .arguments = {segmentName(edit.segment, row.document)},
        .then = {flowTitle(flow.gained, flow.lost)}};
    if (edit.rule == IslandRule::KeepLargest)
        title.code = RowTitleCode::KeepLargestIsland;
    if (edit.rule == IslandRule::RemoveSmall)
        title.code = RowTitleCode::RemoveSmallIslands;
    return title;
}

/// Every voxel of the plane may decide what hangs together.
EditDependencies dependencies(const CleanSegment& edit, const DependencyFacts& row)
{
    return dependsOn::Plane{.plane = row.planeOf(edit.segment)};
}

Result<RelabelListed> relabelListed(
    const CleanSegment& edit, const Document& document, std::span<const std::uint8_t> labels)
{
    const Result<LabelTarget> target = targetOf(edit, document);
    if (!target)
        return tl::unexpected(target.error());
    const VolumeGeometry& geometry = document.volumes.front().geometry;
    const Result<IslandChange> change = islandChange(
        labels, geometry.size, target->label, edit.rule, voxelsOf(edit, geometry), Progress());
    if (!change)
        return tl::unexpected(change.error());
    const std::uint8_t asked =
        edit.rule == IslandRule::FillHoles ? RelabelListed::give : RelabelListed::take;
    const BrickGrid grid{geometry.size};
    std::map<std::uint32_t, std::vector<std::uint8_t>> bricks;
    const auto columns = std::uint64_t(geometry.size.x);
    const auto rows = std::uint64_t(geometry.size.y);
    // A run never leaves its row.
    for (const VoxelRun& run : change->voxels.runs()) {
        for (std::uint64_t at = run.first; at < run.first + run.count; ++at) {
            const glm::ivec3 voxel(
                int(at % columns), int(at / columns % rows), int(at / columns / rows));
            std::vector<std::uint8_t>& brick = bricks[std::uint32_t(grid.brickOf(voxel))];
            if (brick.empty())
                brick.assign(BrickGrid::voxelsPerBrick, std::uint8_t(0));
            brick[std::size_t(BrickGrid::offsetInBrick(voxel))] = asked;
        }
    }
    RelabelListed relabel{.target = *target, .bricks = {}};
    for (auto& [brick, each] : bricks)
        relabel.bricks.push_back({brick, std::move(each)});
    return relabel;
}

} // namespace core
