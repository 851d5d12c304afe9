// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/segments/ReshapeSegment.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/engine/EditableRanges.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/engine/ListedRuns.h"
#include "core/edits/open/OpenStroke.h"
#include "core/morphology/GaussianShape.h"
#include "core/morphology/GridGaussian.h"
#include "core/morphology/MillimetreBall.h"
#include "core/morphology/SidedMargin.h"
#include "core/sculpt/labels/HeldVoxels.h"

#include <algorithm>
#include <bitset>

namespace core {

using namespace rowWords;

namespace {

Error fieldError(const char* field, const Clause& reason)
{
    return {ErrorCode::InvalidField,
        {QStringLiteral("reshapeSegment.%1").arg(QLatin1String(field)), reason}};
}

/// The radius of the ball around a voxel that decides. Half of a centred shell lies on either side.
double ballMm(const ReshapeSegment& edit)
{
    constexpr double half = 0.5;
    if (edit.operation == ShapeOperation::Gaussian)
        return gaussianReach * edit.mm;
    return edit.shell == ShellPlace::Centred ? half * edit.mm : edit.mm;
}

bool hasSides(const ReshapeSegment& edit)
{
    const auto sides = edit.sides.all();
    return std::any_of(
        sides.begin(), sides.end(), [](const auto& side) { return side.has_value(); });
}

SixMargins marginsOf(const ReshapeSegment& edit)
{
    const SideMargins& sides = edit.sides;
    return {.right = sides.rightMm.value_or(edit.mm),
        .left = sides.leftMm.value_or(edit.mm),
        .anterior = sides.anteriorMm.value_or(edit.mm),
        .posterior = sides.posteriorMm.value_or(edit.mm),
        .inferior = sides.inferiorMm.value_or(edit.mm),
        .superior = sides.superiorMm.value_or(edit.mm)};
}

/// The margin on the side where it is widest.
double widestMm(const ReshapeSegment& edit)
{
    double widest = 0.0;
    for (const std::optional<double>& side : edit.sides.all())
        widest = std::max(widest, side.value_or(edit.mm));
    return widest;
}

std::optional<Error> sidesAtFaultIn(const ReshapeSegment& edit, const VolumeGeometry& geometry)
{
    if (edit.operation != ShapeOperation::Grow && edit.operation != ShapeOperation::Shrink)
        return fieldError("sides", Clause::saying("mean nothing where nothing grows or shrinks"));
    for (const std::optional<double>& side : edit.sides.all()) {
        if (side && !(*side >= 0.0))
            return fieldError("sides", Clause::saying("is no length"));
    }
    if (!(widestMm(edit) > 0.0))
        return fieldError("sides", Clause::saying("are all nothing"));
    if (ballVoxels(geometry, widestMm(edit)) > mostBallVoxels)
        return fieldError("sides",
            Clause::saying("%1 mm are more than %2 voxels here", widestMm(edit), mostBallVoxels));
    return std::nullopt;
}

std::optional<Error> fieldAtFaultIn(const ReshapeSegment& edit, const VolumeGeometry& geometry)
{
    if (edit.shell && edit.operation != ShapeOperation::Hollow)
        return fieldError("shell", Clause::saying("means nothing where nothing is hollowed out"));
    if (edit.flat && edit.operation != ShapeOperation::Median)
        return fieldError("flat", Clause::saying("means nothing where no majority decides"));
    if (!(edit.mm > 0.0))
        return fieldError("mm", Clause::saying("is no length"));
    if (hasSides(edit)) {
        if (const std::optional<Error> error = sidesAtFaultIn(edit, geometry))
            return error;
    }
    if (ballVoxels(geometry, ballMm(edit)) > mostBallVoxels)
        return fieldError(
            "mm", Clause::saying("%1 mm are more than %2 voxels here", edit.mm, mostBallVoxels));
    return std::nullopt;
}

/// The segments that are smoothed together, by label.
/// Errors: UnknownSegment, SegmentLocked, InvalidField.
Result<std::vector<std::uint8_t>> together(const ReshapeSegment& edit, const Document& document)
{
    const Result<const Segment*> first =
        unlockedSegment("reshapeSegment.segment", edit.segment, document);
    if (!first)
        return tl::unexpected(first.error());
    if (edit.operation != ShapeOperation::Gaussian)
        return tl::unexpected(
            fieldError("with", Clause::saying("means nothing where no Gaussian smooths")));
    std::vector<std::uint8_t> labels{(*first)->label};
    for (const int label : *edit.with) {
        const Result<const Segment*> other =
            unlockedSegment("reshapeSegment.with", label, document);
        if (!other)
            return tl::unexpected(other.error());
        if (std::find(labels.begin(), labels.end(), (*other)->label) != labels.end())
            return tl::unexpected(fieldError("with", Clause::saying("names a segment twice")));
        labels.push_back((*other)->label);
    }
    constexpr std::size_t most = 254; // one number is needed for what no segment has
    if (labels.size() > most)
        return tl::unexpected(fieldError("with", Clause::saying("are more than %1", most)));
    std::sort(labels.begin(), labels.end());
    return labels;
}

/// Those of them that lie in a plane.
std::vector<std::uint8_t> labelsInPlane(
    std::vector<std::uint8_t> labels, std::uint8_t plane, const Document& document)
{
    std::erase_if(
        labels, [&](std::uint8_t label) { return document.segment(label)->plane != plane; });
    return labels;
}

/// A number that is none of these labels.
std::uint8_t numberBeside(const std::vector<std::uint8_t>& labels)
{
    std::uint8_t number = 1;
    while (std::binary_search(labels.begin(), labels.end(), number))
        ++number;
    return number;
}

RowTitleCode titleOf(const ReshapeSegment& edit)
{
    switch (edit.operation) {
    case ShapeOperation::Grow:
        return hasSides(edit) ? RowTitleCode::GrowBySides : RowTitleCode::GrowByMargin;
    case ShapeOperation::Shrink:
        return hasSides(edit) ? RowTitleCode::ShrinkBySides : RowTitleCode::ShrinkByMargin;
    case ShapeOperation::Hollow:
        switch (edit.shell.value_or(ShellPlace::Inside)) {
        case ShellPlace::Inside:
            return RowTitleCode::HollowInside;
        case ShellPlace::Centred:
            return RowTitleCode::HollowCentred;
        case ShellPlace::Outside:
            return RowTitleCode::HollowOutside;
        }
        break;
    case ShapeOperation::Open:
        return RowTitleCode::OpenShape;
    case ShapeOperation::Close:
        return RowTitleCode::CloseShape;
    case ShapeOperation::Wrap:
        return RowTitleCode::WrapShape;
    case ShapeOperation::Gaussian:
        return edit.with ? RowTitleCode::JointGaussian : RowTitleCode::GaussianShape;
    case ShapeOperation::Median:
        break;
    }
    return RowTitleCode::SmoothShape;
}

Result<ShapeChange> changeOf(const ReshapeSegment& edit, const VolumeGeometry& geometry,
    std::uint8_t label, std::span<const std::uint8_t> labels, const Progress& progress)
{
    if (edit.operation == ShapeOperation::Gaussian)
        return gaussianChange(
            labels, geometry.size, label, gaussianOf(geometry, edit.mm), progress);
    if (hasSides(edit))
        return sidedMarginChange(labels, geometry.size, label,
            edit.operation == ShapeOperation::Grow, sidedBallOf(geometry, marginsOf(edit)),
            progress);
    const MillimetreBall ball = edit.flat.value_or(false) ? flatBallOf(geometry, ballMm(edit))
                                                          : ballOf(geometry, ballMm(edit));
    return shapeChange(labels, geometry.size, label, edit.operation,
        edit.shell.value_or(ShellPlace::Inside), ball, progress);
}

/// What is written in one plane.
/// @param segments those of the plane that are smoothed together, ascending
/// @param change what that comes to
Result<LabelListed> listedIn(std::uint8_t plane, const std::vector<std::uint8_t>& segments,
    const JointChange& change, const ReshapeSegment& edit, const Document& document)
{
    ListedRuns listed(document.volumes.front().geometry.size);
    std::bitset<256> overwritable;
    for (std::size_t place = 0; place < segments.size(); ++place) {
        overwritable.set(segments[place]);
        listed.add(change.given[place], segments[place]);
    }
    const std::uint8_t frees = numberBeside(segments);
    listed.add(change.freed, frees);
    return keepingTo(
        edit.editable, document, "reshapeSegment", listed.label(plane, overwritable, frees));
}

} // namespace

Result<void> check(const ReshapeSegment& edit, const Document& document)
{
    if (const std::optional<Error> error = fieldAtFaultIn(edit, document.volumes.front().geometry))
        return tl::unexpected(*error);
    if (const auto editable = editableVoxels(edit.editable, document, "reshapeSegment"); !editable)
        return tl::unexpected(editable.error());
    if (edit.with)
        return discardValue(together(edit, document));
    return discardValue(segmentTarget(edit.segment, false, document));
}

Result<bool> apply(const ReshapeSegment&, Document&)
{
    return false;
}

EditEffects effects(const ReshapeSegment& edit)
{
    return workedOutEffects(edit.segment, namesPlaces(edit.editable), opens<ReshapeSegment>());
}

/// A preview, for the user to decide.
OpenManner openManner(const ReshapeSegment&)
{
    return {.withoutPen = true, .endsIfRefused = true};
}

RowTitle rowTitle(const ReshapeSegment& edit, const RowFacts& row)
{
    RowTitle title = segmentChanged(titleOf(edit), edit.segment, row);
    title.arguments.push_back(TitleDigits{hasSides(edit) ? widestMm(edit) : edit.mm, 3});
    return title;
}

/// Every voxel of the plane may decide what is near another.
EditDependencies dependencies(const ReshapeSegment& edit, const DependencyFacts& row)
{
    dependsOn::Plane plane{.plane = row.planeOf(edit.segment)};
    for (const int label : edit.with.value_or(std::vector<int>())) {
        if (row.planeOf(label) != row.planeOf(edit.segment))
            plane.plane.reset(); // it writes to several
    }
    return row.alsoReading(edit.editable, plane);
}

Result<RelabelListed> relabelListed(const ReshapeSegment& edit, const Document& document,
    std::span<const std::uint8_t> labels, const Progress& progress)
{
    Result<LabelTarget> target = segmentTarget(edit.segment, false, document);
    if (!target)
        return tl::unexpected(target.error());
    const VolumeGeometry& geometry = document.volumes.front().geometry;
    if (const std::optional<Error> error = fieldAtFaultIn(edit, geometry))
        return tl::unexpected(*error);
    const Result<ShapeChange> change = changeOf(edit, geometry, target->label, labels, progress);
    if (!change)
        return tl::unexpected(change.error());
    ListedRuns listed(geometry.size);
    listed.add(change->given, RelabelListed::give);
    listed.add(change->taken, RelabelListed::take);
    return keepingTo(edit.editable, document, "reshapeSegment", listed.relabel(*std::move(target)));
}

Result<LabelListed> labelListed(const ReshapeSegment& edit, const Document& document,
    std::span<const std::uint8_t> labels, const Progress& progress)
{
    const VolumeGeometry& geometry = document.volumes.front().geometry;
    if (const std::optional<Error> error = fieldAtFaultIn(edit, geometry))
        return tl::unexpected(*error);
    const Result<std::vector<std::uint8_t>> segments = together(edit, document);
    if (!segments)
        return tl::unexpected(segments.error());
    const Result<JointChange> change = jointGaussianChange(
        labels, geometry.size, *segments, gaussianOf(geometry, edit.mm), progress);
    if (!change)
        return tl::unexpected(change.error());
    return listedIn(document.segment(edit.segment)->plane, *segments, *change, edit, document);
}

Result<LabelPlanes> labelPlanes(const ReshapeSegment& edit, const Document& document,
    std::span<const LabelPlane> planes, const Progress& progress)
{
    const VolumeGeometry& geometry = document.volumes.front().geometry;
    if (const std::optional<Error> error = fieldAtFaultIn(edit, geometry))
        return tl::unexpected(*error);
    const Result<std::vector<std::uint8_t>> all = together(edit, document);
    if (!all)
        return tl::unexpected(all.error());
    LabelPlanes result;
    for (const LabelPlane& each : planes) {
        const std::vector<std::uint8_t> segments = labelsInPlane(*all, each.plane, document);
        const Result<JointChange> change = jointGaussianChange(each.labels, geometry.size, segments,
            gaussianOf(geometry, edit.mm), progress, int(result.planes.size()), int(planes.size()));
        if (!change)
            return tl::unexpected(change.error());
        Result<LabelListed> listed = listedIn(each.plane, segments, *change, edit, document);
        if (!listed)
            return tl::unexpected(listed.error());
        result.planes.push_back(*std::move(listed));
    }
    return result;
}

} // namespace core
