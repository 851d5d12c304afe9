// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/EngineEdits.h"

#include "core/edits/kinds/layers/MergeLayers.h"
#include "core/edits/kinds/layers/RemoveLayer.h"
#include "core/edits/kinds/layers/SegmentToLayer.h"
#include "core/edits/kinds/parts/HiddenSides.h"
#include "core/edits/kinds/parts/SegmentChoice.h"
#include "core/edits/kinds/segments/LayerToSegment.h"
#include "core/edits/kinds/segments/SegmentSeen.h"

#include <algorithm>
#include <cmath>

namespace core {

namespace {

/// A plane's side as whole numbers, as finely as sums in 32 bits allow: the plane is off by less
/// than 2⁻¹⁸ of the volume's size, and not at all where it lies along the volume's slices.
VoxelBound voxelBound(const HiddenSide& side, const VolumeGeometry& geometry)
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

Result<LabelCarved> labelCarved(const LayerToSegment& edit, const Document& document)
{
    if (!document.layer(edit.layer))
        return failure(ErrorCode::InvalidField, QStringLiteral("layerToSegment.layer"),
            QStringLiteral("there is no sculpt layer %1").arg(edit.layer));
    Result<LabelTarget> target = labelTarget(edit.target, edit.overwriteUnlocked, document);
    if (!target)
        return tl::unexpected(target.error());
    return LabelCarved{.target = *target, .layer = std::uint8_t(edit.layer)};
}

Result<LabelSeen> labelSeen(const SegmentSeen& edit, const Document& document)
{
    if (edit.lower && edit.upper && !(*edit.lower <= *edit.upper))
        return failure(ErrorCode::InvalidField, QStringLiteral("segmentSeen.upper"),
            QStringLiteral("%1 is below lower, %2").arg(*edit.upper).arg(*edit.lower));
    Result<LabelTarget> target = labelTarget(edit.target, edit.overwriteUnlocked, document);
    if (!target)
        return tl::unexpected(target.error());
    const Volume& volume = document.volumes.front();
    LabelSeen seen{.target = *target};
    seen.lowCode = edit.lower ? volume.encoding.lowestCodeAtLeast(*edit.lower) : 0;
    seen.highCode =
        edit.upper ? volume.encoding.highestCodeAtMost(*edit.upper) : VoxelEncoding::codeCount - 1;
    for (const HiddenSide& side : edit.hidden.value_or(std::vector<HiddenSide>()))
        seen.bounds.push_back(voxelBound(side, volume.geometry));
    return seen;
}

Result<CoverLabel> coverLabel(const SegmentToLayer& edit, const Document& document)
{
    const Segment* segment = document.segment(edit.segment);
    if (!segment)
        return failure(ErrorCode::UnknownSegment, QString::number(edit.segment),
            QStringLiteral("in field 'segmentToLayer.segment'"));
    if (segment->uncarvable)
        return failure(ErrorCode::SegmentProtected, segment->name);
    return CoverLabel{
        .layer = std::uint8_t(edit.layer), .plane = segment->plane, .label = segment->label};
}

FoldLayer foldLayer(const RemoveLayer& edit)
{
    return {.layer = std::uint8_t(edit.layer), .into = {}};
}

FoldLayer foldLayer(const MergeLayers& edit)
{
    return {.layer = std::uint8_t(edit.from), .into = std::uint8_t(edit.into)};
}

} // namespace core
