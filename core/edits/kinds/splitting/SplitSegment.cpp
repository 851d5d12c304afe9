// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/splitting/SplitSegment.h"

#include "core/brick/LabelBox.h"
#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/engine/HalfSpaces.h"
#include "core/edits/engine/ListedRuns.h"

#include <utility>

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

/// The new segment's label; it takes voxels of the segment alone.
LabelTarget newTarget(const Segment& segment, const Document& document)
{
    LabelTarget target{
        .plane = segment.plane, .label = std::uint8_t(document.lastLabelGiven() + 1)};
    target.overwritable.set(segment.label);
    return target;
}

/// A segment's voxels on both sides of a plane.
struct PlaneSides {
    VoxelRuns beyond;
    bool staysAny = false; ///< whether one is not beyond
};

Result<PlaneSides> sidesOf(const IntegerHalfSpace& half, const glm::ivec3& size,
    std::span<const std::uint8_t> labels, std::uint8_t label, const Progress& progress)
{
    PlaneSides sides;
    const VoxelBox box = boxOfLabel(labels, size, label);
    for (int z = box.minimum.z; z < box.maximum.z; ++z) {
        if (progress.cancelled())
            return failure(ErrorCode::Cancelled);
        for (int y = box.minimum.y; y < box.maximum.y; ++y) {
            const std::size_t row =
                (std::size_t(z) * std::size_t(size.y) + std::size_t(y)) * std::size_t(size.x);
            const std::int64_t ofRow =
                std::int64_t(half.perVoxel.y) * y + std::int64_t(half.perVoxel.z) * z - half.offset;
            for (int x = box.minimum.x; x < box.maximum.x; ++x) {
                if (labels[row + std::size_t(x)] != label)
                    continue;
                if (ofRow + std::int64_t(half.perVoxel.x) * x > 0)
                    sides.beyond.append(row + std::size_t(x), 1);
                else
                    sides.staysAny = true;
            }
        }
    }
    return sides;
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
    return splitEffects(edit.segment, true);
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

Result<RelabelListed> relabelListed(const SplitSegment& edit, const Document& document,
    std::span<const std::uint8_t> labels, const Progress& progress)
{
    if (const Result<void> checked = check(edit, document); !checked)
        return tl::unexpected(checked.error());
    const Segment& segment = *document.segment(edit.segment);
    const VolumeGeometry& geometry = document.volumes.front().geometry;
    const Result<IntegerHalfSpace> half = beyondPlane(edit, geometry);
    if (!half)
        return tl::unexpected(half.error());
    const Result<PlaneSides> sides = sidesOf(*half, geometry.size, labels, segment.label, progress);
    if (!sides)
        return tl::unexpected(sides.error());
    ListedRuns listed(geometry.size);
    if (sides->staysAny)
        listed.add(sides->beyond, RelabelListed::give);
    return keepingTo(
        edit.editable, document, "splitSegment", listed.relabel(newTarget(segment, document)));
}

} // namespace core
