// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/views/Measurements.h"

#include "core/edits/answers/EditChecks.h"
#include "core/edits/answers/EditDependencies.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/answers/ListEdits.h"
#include "core/edits/answers/RowFacts.h"

#include <algorithm>

namespace core {

Result<void> check(const AddMeasurement& edit, const Document& document)
{
    return checkApplied(edit, document);
}

Result<bool> apply(const AddMeasurement& edit, Document& document)
{
    if (edit.fromLps == edit.toLps)
        return failure(ErrorCode::InvalidField, QStringLiteral("addMeasurement.toLps"),
            QStringLiteral("is the same point as fromLps"));
    if (edit.piece && !document.piece(*edit.piece))
        return unknownPiece("addMeasurement.piece", *edit.piece);
    document.measurements.push_back({.id = document.lastMeasurementGiven() + 1,
        .fromLps = edit.fromLps,
        .toLps = edit.toLps,
        .piece = edit.piece.value_or(0)});
    return true;
}

EditEffects effects(const AddMeasurement&)
{
    return documentEffects(DocumentChange::What::Measurements, true);
}

RowTitle rowTitle(const AddMeasurement& edit, const RowFacts&)
{
    return {.code = RowTitleCode::Measure,
        .arguments = {inMm(glm::distance(edit.fromLps, edit.toLps))}};
}

EditDependencies dependencies(const AddMeasurement&, const DependencyFacts& row)
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
            QStringLiteral("there is no measurement %1").arg(edit.measurement));
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
    return {.code = RowTitleCode::RemoveMeasurement, .arguments = {inMm(measurement->lengthMm())}};
}

EditDependencies dependencies(const RemoveMeasurement&, const DependencyFacts& row)
{
    return row.whatWasWritten();
}

} // namespace core
