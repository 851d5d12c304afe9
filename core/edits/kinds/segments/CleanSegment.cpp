// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/CleanSegment.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/engine/IslandSizes.h"
#include "core/edits/engine/ListedRuns.h"
#include "core/edits/open/OpenStroke.h"

#include <limits>

namespace core {

using namespace rowWords;

namespace {

/// The label that gains or loses voxels. A segment that receives an island takes voxels from the
/// edit's segment alone.
Result<LabelTarget> targetOf(const CleanSegment& edit, const Document& document)
{
    const Result<LabelTarget> own = segmentTarget(edit.segment, false, document);
    if (!own || !edit.to)
        return own;
    Result<LabelTarget> other = segmentTarget(*edit.to, false, document);
    if (!other)
        return other;
    if (other->plane != own->plane)
        return failure(ErrorCode::InvalidField, QStringLiteral("cleanSegment.to"),
            Clause::saying("lies on another label plane than the segment"));
    other->overwritable.set(own->label);
    return other;
}

Error wrongField(const char* field, const Clause& reason)
{
    return {ErrorCode::InvalidField,
        {QStringLiteral("cleanSegment.%1").arg(QLatin1String(field)), reason}};
}

/// Whether it has what its rule asks for, and no more.
std::optional<Error> fieldAtFault(const CleanSegment& edit)
{
    if (edit.rule == IslandRule::RemoveSmall && !edit.mm3)
        return wrongField("mm3", Clause::saying("is needed to tell which islands are small"));
    if (isOfClicked(edit.rule) && edit.mm3)
        return wrongField("mm3", Clause::saying("means nothing where one island is clicked"));
    if (isOfClicked(edit.rule) != edit.islandLps.has_value())
        return wrongField("islandLps",
            edit.islandLps ? Clause::saying("means nothing where no island is clicked")
                           : Clause::saying("is needed to tell which island is meant"));
    if ((edit.rule == IslandRule::GiveClicked) != edit.to.has_value())
        return wrongField("to",
            edit.to ? Clause::saying("means nothing where no island is given away")
                    : Clause::saying("is needed to tell who receives the island"));
    if (edit.to == edit.segment)
        return wrongField("to", Clause::saying("is the segment itself"));
    return std::nullopt;
}

/// The index of the clicked voxel among the labels of the volume; 0 if the rule needs none.
Result<std::size_t> clickedOf(const CleanSegment& edit, const VolumeGeometry& geometry)
{
    if (!edit.islandLps)
        return std::size_t(0);
    const std::optional<glm::ivec3> voxel = voxelNearest(*edit.islandLps, geometry);
    if (!voxel)
        return tl::unexpected(wrongField(
            "islandLps", Clause::saying("%1 lies outside the volume", pointText(*edit.islandLps))));
    return (std::size_t(voxel->z) * std::size_t(geometry.size.y) + std::size_t(voxel->y))
        * std::size_t(geometry.size.x)
        + std::size_t(voxel->x);
}

/// The number of voxels that islandChange() expects for the rule.
std::int64_t voxelsOf(const CleanSegment& edit, const VolumeGeometry& geometry)
{
    if (!edit.mm3)
        return std::numeric_limits<std::int64_t>::max();
    return edit.rule == IslandRule::FillHoles ? mostVoxels(*edit.mm3, geometry)
                                              : fewestVoxels(*edit.mm3, geometry);
}

} // namespace

Result<void> check(const CleanSegment& edit, const Document& document)
{
    if (const std::optional<Error> error = fieldAtFault(edit))
        return tl::unexpected(*error);
    if (const auto clicked = clickedOf(edit, document.volumes.front().geometry); !clicked)
        return tl::unexpected(clicked.error());
    if (const auto editable = editableVoxels(edit.editable, document, "cleanSegment"); !editable)
        return tl::unexpected(editable.error());
    return discardValue(targetOf(edit, document));
}

Result<bool> apply(const CleanSegment&, Document&)
{
    return false;
}

EditEffects effects(const CleanSegment& edit)
{
    return {.task = EditTask::Islands,
        .standsOpen = opens<CleanSegment>(),
        .writesTo = edit.segment,
        .fills = {.label = edit.to.value_or(edit.segment)},
        .boundToStudy = edit.islandLps.has_value() || namesPlaces(edit.editable)};
}

/// A preview, for the user to decide.
OpenManner openManner(const CleanSegment&)
{
    return {.withoutPen = true, .endsIfRefused = true};
}

RowTitle rowTitle(const CleanSegment& edit, const RowFacts& row)
{
    RowTitle title = segmentChanged(RowTitleCode::FillHoles, edit.segment, row);
    switch (edit.rule) {
    case IslandRule::FillHoles:
        break;
    case IslandRule::KeepLargest:
        title.code = RowTitleCode::KeepLargestIsland;
        break;
    case IslandRule::RemoveSmall:
        title.code = RowTitleCode::RemoveSmallIslands;
        break;
    case IslandRule::KeepClicked:
        title.code = RowTitleCode::KeepClickedIsland;
        break;
    case IslandRule::RemoveClicked:
        title.code = RowTitleCode::RemoveClickedIsland;
        break;
    case IslandRule::GiveClicked:
        title.code = RowTitleCode::GiveClickedIsland;
        title.arguments.push_back(segmentName(edit.to.value_or(0), row.document));
        break;
    }
    return title;
}

/// Every voxel of the plane may decide what hangs together.
EditDependencies dependencies(const CleanSegment& edit, const DependencyFacts& row)
{
    return row.alsoReading(edit.editable, dependsOn::Plane{.plane = row.planeOf(edit.segment)});
}

Result<RelabelListed> relabelListed(const CleanSegment& edit, const Document& document,
    std::span<const std::uint8_t> labels, const Progress& progress)
{
    const Result<LabelTarget> target = targetOf(edit, document);
    if (!target)
        return tl::unexpected(target.error());
    const VolumeGeometry& geometry = document.volumes.front().geometry;
    const Result<std::size_t> clicked = clickedOf(edit, geometry);
    if (!clicked)
        return tl::unexpected(clicked.error());
    const auto label = std::uint8_t(edit.segment);
    if (isOfClicked(edit.rule) && labels[*clicked] != label)
        return failure(ErrorCode::NoIslandThere, document.segment(edit.segment)->name);
    const Result<IslandChange> change = islandChange(
        labels, geometry.size, label, edit.rule, voxelsOf(edit, geometry), progress, *clicked);
    if (!change)
        return tl::unexpected(change.error());
    const bool gives = edit.rule == IslandRule::FillHoles || edit.rule == IslandRule::GiveClicked;
    ListedRuns listed(geometry.size);
    listed.add(change->voxels, gives ? RelabelListed::give : RelabelListed::take);
    return keepingTo(edit.editable, document, "cleanSegment", listed.relabel(*target));
}

} // namespace core
