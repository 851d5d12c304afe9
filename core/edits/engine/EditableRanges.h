// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/edits/kinds/parts/EditableRange.h"
#include "core/growth/SeedStatistics.h"
#include "core/sculpt/labels/EditableVoxels.h"

#include <QString>

#include <optional>
#include <utility>

namespace core {

/// The same range in the form of an engine; none: none.
/// @param edit its name, for messages
/// Errors: UnknownSegment, InvalidField (bounds in the wrong order, a box outside the volume).
[[nodiscard]] Result<std::optional<EditableVoxels>> editableVoxels(
    const std::optional<EditableRange>& range, const Document& document, const char* edit);

/// A command of an engine that keeps to the range. Errors: those of editableVoxels().
template <class Command>
[[nodiscard]] Result<Command> keepingTo(const std::optional<EditableRange>& range,
    const Document& document, const char* edit, Command command)
{
    Result<std::optional<EditableVoxels>> editable = editableVoxels(range, document, edit);
    if (!editable)
        return tl::unexpected(editable.error());
    command.editable = *std::move(editable);
    return command;
}

/// Whether it names places of the patient, which mean nothing in another study.
[[nodiscard]] inline bool namesPlaces(const std::optional<EditableRange>& range)
{
    return range && range->box;
}

/// The codes of values between two bounds, both included; a bound that is not given is the end of
/// all codes.
/// Errors: InvalidField (bounds in the wrong order: the field "upper" below @p field).
[[nodiscard]] Result<CodeInterval> codesBetween(const QString& field,
    const std::optional<double>& lower, const std::optional<double>& upper,
    const VoxelEncoding& encoding);

} // namespace core
