// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/filling/FillBetweenSlices.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/engine/ListedRuns.h"
#include "core/edits/kinds/filling/SketchPlanes.h"
#include "core/edits/open/OpenStroke.h"
#include "core/morphology/BetweenSlices.h"
#include "core/morphology/planes/BetweenPlanes.h"

namespace core {

using namespace rowWords;

Result<void> check(const FillBetweenSlices& edit, const Document& document)
{
    if (edit.planes) {
        const Result<PlaneSketch> sketch = planeSketch(
            *edit.planes, document.volumes.front().geometry, QStringLiteral("fillBetweenSlices"));
        if (!sketch)
            return tl::unexpected(sketch.error());
    }
    return checkEditable(edit.segment, edit.editable, document, "fillBetweenSlices");
}

Result<bool> apply(const FillBetweenSlices&, Document&)
{
    return false;
}

EditEffects effects(const FillBetweenSlices& edit)
{
    return workedOutEffects(
        edit.segment, edit.planes || namesPlaces(edit.editable), opens<FillBetweenSlices>());
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

Result<VoxelRuns> voxelsFilled(const FillBetweenSlices& edit, const VolumeGeometry& geometry,
    std::span<const std::uint8_t> labels, const Progress& progress)
{
    const auto label = std::uint8_t(edit.segment);
    if (edit.planes) {
        const Result<PlaneSketch> sketch =
            planeSketch(*edit.planes, geometry, QStringLiteral("fillBetweenSlices"));
        if (!sketch)
            return tl::unexpected(sketch.error());
        return voxelsBetweenPlanes(labels, geometry.size, label, *sketch, progress);
    }
    const std::array<DrawnSlices, 3> drawn = drawnSlices(labels, geometry.size, label);
    const std::optional<SliceAxis> axis = edit.axis ? edit.axis : drawnAxis(drawn);
    if (!axis)
        return VoxelRuns();
    return voxelsBetween(labels, geometry, label, drawn.at(std::size_t(alongOf(*axis))), progress);
}

Result<RelabelListed> relabelListed(const FillBetweenSlices& edit, const Document& document,
    std::span<const std::uint8_t> labels, const Progress& progress)
{
    Result<LabelTarget> target = segmentTarget(edit.segment, false, document);
    if (!target)
        return tl::unexpected(target.error());
    const VolumeGeometry& geometry = document.volumes.front().geometry;
    const Result<VoxelRuns> filled = voxelsFilled(edit, geometry, labels, progress);
    if (!filled)
        return tl::unexpected(filled.error());
    ListedRuns listed(geometry.size);
    listed.add(*filled, RelabelListed::give);
    return keepingTo(
        edit.editable, document, "fillBetweenSlices", listed.relabel(*std::move(target)));
}

} // namespace core
