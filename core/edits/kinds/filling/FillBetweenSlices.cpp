// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/filling/FillBetweenSlices.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/engine/ListedRuns.h"
#include "core/edits/open/OpenStroke.h"
#include "core/morphology/BetweenSlices.h"

namespace core {

using namespace rowWords;

Result<void> check(const FillBetweenSlices& edit, const Document& document)
{
    return checkEditable(edit.segment, edit.editable, document, "fillBetweenSlices");
}

Result<bool> apply(const FillBetweenSlices&, Document&)
{
    return false;
}

EditEffects effects(const FillBetweenSlices& edit)
{
    return workedOutEffects(edit.segment, namesPlaces(edit.editable), opens<FillBetweenSlices>());
}

/// A preview, for the user to decide.
OpenManner openManner(const FillBetweenSlices&)
{
    return {.withoutPen = true, .endsIfRefused = true};
}

RowTitle rowTitle(const FillBetweenSlices& edit, const RowFacts& row)
{
    return segmentChanged(RowTitleCode::FillBetweenSlices, edit.segment, row);
}

/// Every voxel of the plane may decide which slices are drawn.
EditDependencies dependencies(const FillBetweenSlices& edit, const DependencyFacts& row)
{
    return row.alsoReading(edit.editable, dependsOn::Plane{.plane = row.planeOf(edit.segment)});
}

Result<RelabelListed> relabelListed(const FillBetweenSlices& edit, const Document& document,
    std::span<const std::uint8_t> labels, const Progress& progress)
{
    Result<LabelTarget> target = segmentTarget(edit.segment, false, document);
    if (!target)
        return tl::unexpected(target.error());
    const VolumeGeometry& geometry = document.volumes.front().geometry;
    ListedRuns listed(geometry.size);
    const std::array<DrawnSlices, 3> drawn = drawnSlices(labels, geometry.size, target->label);
    if (const std::optional<SliceAxis> axis = edit.axis ? edit.axis : drawnAxis(drawn)) {
        const Result<VoxelRuns> between = voxelsBetween(
            labels, geometry, target->label, drawn.at(std::size_t(alongOf(*axis))), progress);
        if (!between)
            return tl::unexpected(between.error());
        listed.add(*between, RelabelListed::give);
    }
    return keepingTo(
        edit.editable, document, "fillBetweenSlices", listed.relabel(*std::move(target)));
}

} // namespace core
