// SPDX-License-Identifier: Apache-2.0
#include "core/edits/engine/EditableRanges.h"

#include "core/edits/engine/BoxVoxels.h"

#include <map>
#include <utility>

namespace core {

namespace {

using PlaneLabels = EditableVoxels::PlaneLabels;

/// Segments by the plane in which they lie.
Result<std::vector<PlaneLabels>> byPlane(
    const std::vector<int>& segments, const Document& document, const QString& field)
{
    std::map<std::uint8_t, std::bitset<256>> planes;
    for (const int label : segments) {
        const Segment* segment = document.segment(label);
        if (!segment)
            return failure(ErrorCode::UnknownSegment, QString::number(label),
                Clause::saying("in field '%1'", field));
        planes[segment->plane].set(segment->label);
    }
    std::vector<PlaneLabels> listed;
    for (const auto& [plane, labels] : planes)
        listed.push_back({.plane = plane, .labels = labels});
    return listed;
}

} // namespace

Result<CodeInterval> codesBetween(const QString& field, const std::optional<double>& lower,
    const std::optional<double>& upper, const VoxelEncoding& encoding)
{
    if (lower && upper && !(*lower <= *upper))
        return failure(ErrorCode::InvalidField, field + QStringLiteral(".upper"),
            Clause::saying("%1 is below lower, %2", *upper, *lower));
    return CodeInterval{.low = lower ? encoding.lowestCodeAtLeast(*lower) : 0,
        .high = upper ? encoding.highestCodeAtMost(*upper) : VoxelEncoding::codeCount - 1};
}

Result<std::optional<EditableVoxels>> editableVoxels(
    const std::optional<EditableRange>& range, const Document& document, const char* edit)
{
    if (!range)
        return std::optional<EditableVoxels>();
    const QString field = QLatin1String(edit) + QStringLiteral(".editable");
    const Volume& volume = document.volumes.front();
    const Result<CodeInterval> codes =
        codesBetween(field, range->lower, range->upper, volume.encoding);
    if (!codes)
        return tl::unexpected(codes.error());
    EditableVoxels voxels{.lowCode = codes->low, .highCode = codes->high};
    if (range->box) {
        const Result<VoxelSpan> span =
            voxelsOf(*range->box, volume.geometry, field + QStringLiteral(".box"));
        if (!span)
            return tl::unexpected(span.error());
        voxels.box = VoxelBox{span->from, span->to + 1};
    }
    if (range->inside) {
        Result<std::vector<PlaneLabels>> inside =
            byPlane(*range->inside, document, field + QStringLiteral(".inside"));
        if (!inside)
            return tl::unexpected(inside.error());
        voxels.inside = *std::move(inside);
    }
    if (range->outside) {
        Result<std::vector<PlaneLabels>> outside =
            byPlane(*range->outside, document, field + QStringLiteral(".outside"));
        if (!outside)
            return tl::unexpected(outside.error());
        voxels.outside = *std::move(outside);
    }
    return std::optional(std::move(voxels));
}

} // namespace core
