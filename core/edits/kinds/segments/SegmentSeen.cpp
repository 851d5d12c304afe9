// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/SegmentSeen.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/segments/AddSegment.h"

#include <algorithm>
#include <cmath>

namespace core {

using namespace rowWords;

namespace {

/// A plane's side as whole numbers, as finely as sums in 32 bits allow: the plane is off by less
/// than 2⁻¹⁸ of the volume's size, and not at all where it lies along the volume's slices.
VoxelBound voxelBound(const ClipHalfSpace& side, const VolumeGeometry& geometry)
{
    const glm::dvec3 normal = glm::transpose(glm::dmat3(geometry.indexToWorld)) * side.normalLps;
    const double offset = side.offsetMm - glm::dot(side.normalLps, geometry.originLps());
    double reach = 0.0;
    double longest = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        reach = std::max(reach, std::abs(normal[axis]) * geometry.size[axis]);
        longest = std::max(longest, std::abs(normal[axis]));
    }
    const double most =
        double((1 << 29) - *std::max_element(&geometry.size.x, &geometry.size.x + 3));
    const double scale = std::floor(most / reach * longest) / longest;
    VoxelBound bound;
    for (int axis = 0; axis < 3; ++axis)
        bound.normal[axis] = int(std::llround(normal[axis] * scale));
    // No voxel comes near the ends of the range.
    bound.offset =
        std::int32_t(std::llround(std::clamp(offset * scale, -2147483647.0, 2147483647.0)));
    return bound;
}

} // namespace

Result<void> check(const SegmentSeen& edit, const Document& document)
{
    if (const Result<void> isRoom = checkNewSegment(edit.target, document); !isRoom)
        return isRoom;
    return discardValue(labelSeen(edit, document));
}

Result<bool> apply(const SegmentSeen& edit, Document& document)
{
    return addNewSegment(edit.target, document);
}

EditEffects effects(const SegmentSeen& edit)
{
    return effectsOn(edit.target, engineTask<SegmentSeen>(),
        edit.hidden.has_value() || namesPlaces(edit.editable));
}

Result<LabelSeen> labelSeen(const SegmentSeen& edit, const Document& document)
{
    const Volume& volume = document.volumes.front();
    const Result<CodeInterval> codes =
        codesBetween(QStringLiteral("segmentSeen"), edit.lower, edit.upper, volume.encoding);
    if (!codes)
        return tl::unexpected(codes.error());
    Result<LabelTarget> target = labelTarget(edit.target, edit.overwriteUnlocked, document);
    if (!target)
        return tl::unexpected(target.error());
    LabelSeen seen{.target = *target, .lowCode = codes->low, .highCode = codes->high};
    for (const ClipHalfSpace& side : edit.hidden.value_or(std::vector<ClipHalfSpace>()))
        seen.bounds.push_back(voxelBound(side, volume.geometry));
    return keepingTo(edit.editable, document, "segmentSeen", std::move(seen));
}

Result<EngineEdit> engineEdit(const SegmentSeen& edit, const Document& document)
{
    return engineEditFrom(labelSeen(edit, document));
}

RowTitle rowTitle(const SegmentSeen& edit, const RowFacts& row)
{
    return {.code = RowTitleCode::SegmentSeen,
        .arguments = {targetName(edit.target, row.document)},
        .then = {figure(RowTitleCode::VoxelsGained, row.statistics.voxelsChanged)}};
}

/// The coverage of every layer, and the labels and seed words of the segment's plane, since what
/// other segments held decided too.
EditDependencies dependencies(const SegmentSeen& edit, const DependencyFacts& row)
{
    dependsOn::Fields fields{.plane = row.planeOf(edit.target.segment.value_or(0)), .layers = {}};
    fields.layers.set();
    return row.alsoReading(edit.editable, fields);
}

} // namespace core
