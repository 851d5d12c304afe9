// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/splitting/SplitIslands.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/IslandSizes.h"
#include "core/edits/engine/ListedRuns.h"
#include "core/islands/SegmentIslands.h"

#include <algorithm>
#include <bitset>

namespace core {

using namespace rowWords;

Result<void> check(const SplitIslands& edit, const Document& document)
{
    if (const auto segment = unlockedSegment("splitIslands.segment", edit.segment, document);
        !segment)
        return tl::unexpected(segment.error());
    return checkApplied(edit, document);
}

Result<bool> apply(const SplitIslands& edit, Document& document)
{
    if (!edit.into)
        return false;
    return addParts(
        "splitIslands.segment", edit.segment, "splitIslands.into", *edit.into, document);
}

EditEffects effects(const SplitIslands& edit)
{
    // Elsewhere there may be more islands, or fewer.
    return splitEffects(edit.segment, edit.into.has_value());
}

/// "Split 3 islands off 'Liver', −1 204 voxels"
RowTitle rowTitle(const SplitIslands& edit, const RowFacts& row)
{
    const LabelFlow flow = row.flowOf(edit.segment);
    return {.code = RowTitleCode::SplitIslands,
        .arguments = {TitleCount{std::int64_t(edit.into ? edit.into->size() : 0)},
            segmentName(edit.segment, row.document)},
        .then = {flowTitle(flow.gained, flow.lost)}};
}

/// Every voxel of the plane may decide what hangs together.
EditDependencies dependencies(const SplitIslands& edit, const DependencyFacts& row)
{
    return dependsOn::Plane{.plane = row.planeOf(edit.segment)};
}

std::int64_t leastVoxels(const SplitIslands& edit, const VolumeGeometry& geometry)
{
    return edit.mm3 ? fewestVoxels(*edit.mm3, geometry) : 1;
}

Result<LabelListed> labelListed(SplitIslands& edit, const Document& document,
    std::span<const std::uint8_t> labels, const Progress& progress)
{
    const Result<const Segment*> unlocked =
        unlockedSegment("splitIslands.segment", edit.segment, document);
    if (!unlocked)
        return tl::unexpected(unlocked.error());
    const Segment& segment = **unlocked;
    const std::size_t room = roomForSegments(document);
    const VolumeGeometry& geometry = document.volumes.front().geometry;
    const Result<FurtherIslands> further =
        furtherIslands(labels, geometry.size, segment.label, leastVoxels(edit, geometry),
            edit.into ? std::min(edit.into->size(), room) : room, progress);
    if (!further)
        return tl::unexpected(further.error());
    if (!edit.into && further->count > std::int64_t(room))
        return failure(ErrorCode::TooManyIslands, segment.name, QString::number(further->count),
            QString::number(room));
    if (edit.into && further->islands.size() < edit.into->size())
        return failure(ErrorCode::InvalidField, QStringLiteral("splitIslands.into"),
            Clause::saying("names %1 segments, and there are %2 islands beside the largest, with "
                           "room for %3 segments more",
                edit.into->size(), further->count, room));
    ListedRuns listed(geometry.size);
    for (std::size_t place = 0; place < further->islands.size(); ++place)
        listed.add(
            further->islands[place], std::uint8_t(document.lastLabelGiven() + 1 + int(place)));
    if (!edit.into && !further->islands.empty())
        edit.into = usualParts(document, segment, further->islands.size());
    std::bitset<256> overwritable;
    overwritable.set(segment.label);
    return listed.label(segment.plane, overwritable, 0);
}

} // namespace core
