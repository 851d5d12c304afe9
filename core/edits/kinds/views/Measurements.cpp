// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/views/Measurements.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/ListEdits.h"
#include "core/edits/answers/RowFacts.h"
#include "core/measure/MeasuredSize.h"
#include "core/measure/PlaneShape.h"

#include <algorithm>
#include <utility>

namespace core {

namespace {

/// @param field with its edit: "annotate.text"
tl::unexpected<Error> unfit(const char* field, const Clause& reason)
{
    return failure(ErrorCode::InvalidField, QLatin1String(field), reason);
}

Result<void> checkPoints(const Measurement& measurement, const char* field)
{
    using Kind = Measurement::Kind;
    const std::vector<glm::dvec3>& points = measurement.pointsLps;
    const std::size_t least = pointsOf(measurement.kind);
    const bool isOutline = measurement.kind == Kind::Outline;
    if (points.size() < least || points.size() > (isOutline ? Annotate::mostCorners : least))
        return unfit(field,
            isOutline ? Clause::saying("must be %1 to %2", least, Annotate::mostCorners)
                      : Clause::saying("must be %1", least));
    if (points.size() == 2 && points[0] == points[1])
        return unfit(field, Clause::saying("are the same point"));
    if (measurement.kind == Kind::Angle && (points[0] == points[1] || points[2] == points[1]))
        return unfit(field, Clause::saying("have an end at the vertex"));
    if (!measurement.isPlaneRegion())
        return {};
    const std::optional<PlaneShape> shape = planeShape(measurement);
    if (!shape)
        return unfit(field, Clause::saying("lie on one line"));
    if (shape->offPlaneMm(measurement) > PlaneShape::mostOffPlaneMm)
        return unfit(field, Clause::saying("do not lie in one plane"));
    return {};
}

TitleDecimal oneDecimal(double value)
{
    return {.value = value, .decimals = 1};
}

/// "120.4 mm²"; in voxels where the source does not say how large they are.
TitleArgument areaTitle(const MeasuredSize& size)
{
    return asArgument(
        {.code = size.inVoxels ? RowTitleCode::SquareVoxels : RowTitleCode::SquareMillimetres,
            .arguments = {oneDecimal(size.area.value_or(0.0))}});
}

TitleArgument volumeTitle(const MeasuredSize& size)
{
    constexpr double mm3PerMl = 1000.0;
    if (size.inVoxels)
        return asArgument(
            {.code = RowTitleCode::OfVoxels, .arguments = {oneDecimal(size.volume.value_or(0.0))}});
    return asArgument({.code = RowTitleCode::Millilitres,
        .arguments = {TitleDecimal{.value = size.volume.value_or(0.0) / mm3PerMl, .decimals = 2}}});
}

MeasuredSize sizeOf(const Measurement& measurement, const Document& document)
{
    if (!document.volumes.empty())
        return measuredSize(measurement, document.volumes.front());
    MeasuredSize size;
    if (measurement.kind == Measurement::Kind::Distance)
        size.length = measurement.lengthMm();
    return size;
}

/// "distance 12.5 mm", or voxels.
RowTitle lengthTitle(const MeasuredSize& size)
{
    const double length = size.length.value_or(0.0);
    return size.inVoxels
        ? RowTitle{.code = RowTitleCode::DistanceOfVoxels, .arguments = {oneDecimal(length)}}
        : RowTitle{.code = RowTitleCode::DistanceOf, .arguments = {inMm(length)}};
}

/// What it is and comes to: "ellipse 120.4 mm²".
RowTitle whatItIs(const Measurement& measurement, const Document& document)
{
    using Kind = Measurement::Kind;
    const MeasuredSize size = sizeOf(measurement, document);
    switch (measurement.kind) {
    case Kind::Distance:
        return lengthTitle(size);
    case Kind::Angle:
        return {.code = RowTitleCode::AngleOf,
            .arguments = {oneDecimal(size.angleDegrees.value_or(0.0))}};
    case Kind::Ellipse:
        return {.code = RowTitleCode::EllipseOf, .arguments = {areaTitle(size)}};
    case Kind::Rectangle:
        return {.code = RowTitleCode::RectangleOf, .arguments = {areaTitle(size)}};
    case Kind::Outline:
        return {.code = RowTitleCode::OutlineOf, .arguments = {areaTitle(size)}};
    case Kind::Ball:
        return {.code = RowTitleCode::BallOf, .arguments = {volumeTitle(size)}};
    case Kind::Probe:
        return {.code = RowTitleCode::Probe};
    case Kind::Arrow:
        if (measurement.text.isEmpty())
            return {.code = RowTitleCode::Arrow};
        return {.code = RowTitleCode::ArrowTo, .arguments = {measurement.text}};
    case Kind::Text:
        return {.code = RowTitleCode::TextThat, .arguments = {measurement.text}};
    }
    return {};
}

Measurement measurementOf(const Annotate& edit)
{
    return {.kind = edit.kind,
        .pointsLps = edit.pointsLps,
        .piece = edit.piece.value_or(0),
        .text = edit.text.value_or(QString()),
        .projected = edit.projected.value_or(false)};
}

} // namespace

Result<void> check(const AddMeasurement& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const AddMeasurement& edit, Document& document)
{
    if (edit.fromLps == edit.toLps)
        return failure(ErrorCode::InvalidField, QStringLiteral("addMeasurement.toLps"),
            Clause::saying("is the same point as fromLps"));
    if (edit.piece && !document.piece(*edit.piece))
        return unknownPiece("addMeasurement.piece", *edit.piece);
    document.measurements.push_back({.id = document.lastMeasurementGiven() + 1,
        .kind = Measurement::Kind::Distance,
        .pointsLps = {edit.fromLps, edit.toLps},
        .piece = edit.piece.value_or(0),
        .projected = edit.projected.value_or(false)});
    return true;
}

EditEffects effects(const AddMeasurement&)
{
    return documentEffects(DocumentChange::What::Measurements, true);
}

RowTitle rowTitle(const AddMeasurement& edit, const RowFacts& row)
{
    const Measurement measured{.kind = Measurement::Kind::Distance,
        .pointsLps = {edit.fromLps, edit.toLps},
        .projected = edit.projected.value_or(false)};
    const MeasuredSize size = sizeOf(measured, row.document);
    if (size.inVoxels)
        return {.code = RowTitleCode::MeasureThat, .arguments = {asArgument(lengthTitle(size))}};
    return {.code = RowTitleCode::Measure, .arguments = {inMm(size.length.value_or(0.0))}};
}

EditDependencies dependencies(const AddMeasurement&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

Result<void> check(const Annotate& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const Annotate& edit, Document& document)
{
    using Kind = Measurement::Kind;
    if (edit.kind == Kind::Distance)
        return unfit("annotate.kind", Clause::saying("is kept by addMeasurement"));
    if (edit.text && edit.kind != Kind::Arrow && edit.kind != Kind::Text)
        return unfit("annotate.text", Clause::saying("belongs to arrows and texts"));
    if (!edit.text && edit.kind == Kind::Text)
        return unfit("annotate.text", Clause::saying("is missing"));
    if (edit.piece && !document.piece(*edit.piece))
        return unknownPiece("annotate.piece", *edit.piece);
    Measurement made = measurementOf(edit);
    if (const Result<void> sound = checkPoints(made, "annotate.pointsLps"); !sound)
        return tl::unexpected(sound.error());
    made.id = document.lastMeasurementGiven() + 1;
    document.measurements.push_back(std::move(made));
    return true;
}

EditEffects effects(const Annotate&)
{
    return documentEffects(DocumentChange::What::Measurements, true);
}

RowTitle rowTitle(const Annotate& edit, const RowFacts& row)
{
    const bool note = edit.kind == Measurement::Kind::Arrow || edit.kind == Measurement::Kind::Text;
    return {.code = note ? RowTitleCode::AddNote : RowTitleCode::MeasureThat,
        .arguments = {asArgument(whatItIs(measurementOf(edit), row.document))}};
}

EditDependencies dependencies(const Annotate&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

Result<void> check(const MoveMeasurement& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const MoveMeasurement& edit, Document& document)
{
    const auto known = std::find_if(document.measurements.begin(), document.measurements.end(),
        [&edit](const Measurement& each) { return each.id == edit.measurement; });
    if (known == document.measurements.end())
        return failure(ErrorCode::InvalidField, QStringLiteral("moveMeasurement.measurement"),
            Clause::saying("there is no measurement %1", edit.measurement));
    Measurement moved = *known;
    moved.pointsLps = edit.pointsLps;
    if (const Result<void> sound = checkPoints(moved, "moveMeasurement.pointsLps"); !sound)
        return tl::unexpected(sound.error());
    if (moved == *known)
        return false;
    *known = std::move(moved);
    return true;
}

EditEffects effects(const MoveMeasurement&)
{
    return documentEffects(DocumentChange::What::Measurements, true);
}

RowTitle rowTitle(const MoveMeasurement& edit, const RowFacts& row)
{
    const Measurement* known = row.document.measurement(edit.measurement);
    Measurement moved = known ? *known : Measurement();
    moved.pointsLps = edit.pointsLps;
    if (!known || moved.pointsLps.size() < pointsOf(moved.kind))
        return {.code = RowTitleCode::MoveUnknownMeasurement,
            .arguments = {TitleNumber{edit.measurement}}};
    return {
        .code = RowTitleCode::MoveNote, .arguments = {asArgument(whatItIs(moved, row.document))}};
}

EditDependencies dependencies(const MoveMeasurement&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

Result<void> check(const RemoveMeasurement& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const RemoveMeasurement& edit, Document& document)
{
    const Measurement* known = document.measurement(edit.measurement);
    if (!known)
        return failure(ErrorCode::InvalidField, QStringLiteral("removeMeasurement.measurement"),
            Clause::saying("there is no measurement %1", edit.measurement));
    document.greatestRemovedMeasurement =
        std::max(document.greatestRemovedMeasurement, edit.measurement);
    document.measurements.erase(
        document.measurements.begin() + (known - document.measurements.data()));
    return true;
}

EditEffects effects(const RemoveMeasurement&)
{
    return documentEffects(DocumentChange::What::Measurements);
}

RowTitle rowTitle(const RemoveMeasurement& edit, const RowFacts& row)
{
    const Measurement* measurement = row.document.measurement(edit.measurement);
    if (!measurement)
        return {.code = RowTitleCode::RemoveUnknownMeasurement,
            .arguments = {TitleNumber{edit.measurement}}};
    const MeasuredSize size = sizeOf(*measurement, row.document);
    if (measurement->kind != Measurement::Kind::Distance || size.inVoxels)
        return {.code = RowTitleCode::RemoveNote,
            .arguments = {asArgument(whatItIs(*measurement, row.document))}};
    return {
        .code = RowTitleCode::RemoveMeasurement, .arguments = {inMm(size.length.value_or(0.0))}};
}

EditDependencies dependencies(const RemoveMeasurement&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core
