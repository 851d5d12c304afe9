// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/splitting/SplitSegment.h"

#include "core/brick/LabelRuns.h"
#include "core/brick/RunRows.h"
#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/HalfSpaces.h"
#include "core/edits/open/OpenStroke.h"
#include "core/sculpt/labels/LayerWrites.h"

namespace core {

using namespace rowWords;

namespace {

/// What lies beyond the plane, in integers (IntegerHalfSpace.h: what one hides).
Result<IntegerHalfSpace> beyondPlane(const SplitSegment& edit, const VolumeGeometry& geometry)
{
    if (!(glm::length(edit.normalLps) > 0.0))
        return failure(ErrorCode::InvalidField, QStringLiteral("splitSegment.normalLps"),
            Clause::saying("is no direction"));
    const ClipHalfSpace half{
        .normalLps = edit.normalLps, .offsetMm = glm::dot(edit.normalLps, edit.placeLps)};
    return integerHalfSpaces(std::vector{half}, geometry).front();
}

} // namespace

Result<void> check(const SplitSegment& edit, const Document& document)
{
    if (const auto segment = unlockedSegment("splitSegment.segment", edit.segment, document);
        !segment)
        return tl::unexpected(segment.error());
    if (const auto half = beyondPlane(edit, document.volumes.front().geometry); !half)
        return tl::unexpected(half.error());
    if (const auto editable = editableVoxels(edit.editable, document, "splitSegment"); !editable)
        return tl::unexpected(editable.error());
    return checkApplied(edit, document);
}

Result<bool> apply(const SplitSegment& edit, Document& document)
{
    return addParts("splitSegment.segment", edit.segment, "splitSegment", {edit.into}, document);
}

EditEffects effects(const SplitSegment& edit)
{
    EditEffects all = splitEffects(edit.segment, true);
    all.standsOpen = opens<SplitSegment>();
    return all;
}

/// It stands open as a preview until the user decides.
OpenManner openManner(const SplitSegment&)
{
    return {.withoutPen = true, .endsIfRefused = true};
}

/// "Split 'Liver' by a plane, −3 210 voxels"
RowTitle rowTitle(const SplitSegment& edit, const RowFacts& row)
{
    return segmentChanged(RowTitleCode::SplitSegment, edit.segment, row);
}

/// Whether any voxel stays decides, too, wherever it lies.
EditDependencies dependencies(const SplitSegment& edit, const DependencyFacts& row)
{
    return row.alsoReading(edit.editable, dependsOn::Plane{.plane = row.planeOf(edit.segment)});
}

Result<SplitSides> sidesOf(const SplitSegment& edit, const Document& document,
    const VoxelRuns& voxels, const Progress& progress)
{
    const VolumeGeometry& geometry = document.volumes.front().geometry;
    const Result<IntegerHalfSpace> half = beyondPlane(edit, geometry);
    if (!half)
        return tl::unexpected(half.error());
    SplitSides sides;
    forEachRowPart(
        voxels, geometry.size, [&](const glm::ivec3& at, int count, std::uint64_t first) {
            if (progress.cancelled())
                return;
            std::int64_t place = std::int64_t(half->perVoxel.x) * at.x
                + std::int64_t(half->perVoxel.y) * at.y + std::int64_t(half->perVoxel.z) * at.z;
            for (int i = 0; i < count; ++i, place += half->perVoxel.x) {
                if (place > half->offset)
                    sides.beyond.append(first + std::uint64_t(i), 1);
                else
                    ++sides.staying;
            }
        });
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);
    return sides;
}

Result<RelabelListed> relabelListed(const SplitSegment& edit, const Document& document,
    std::span<const std::uint8_t> labels, const Progress& progress)
{
    if (const Result<void> checked = check(edit, document); !checked)
        return tl::unexpected(checked.error());
    const std::uint8_t label = document.segment(edit.segment)->label;
    const Result<SplitSides> sides = sidesOf(edit, document, labelRuns(labels, label), progress);
    if (!sides)
        return tl::unexpected(sides.error());
    return keepingTo(
        edit.editable, document, "splitSegment", givenBeyond(*sides, edit.segment, document));
}

} // namespace core
