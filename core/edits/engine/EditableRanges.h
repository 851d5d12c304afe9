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

/// Converts the editable range of an edit to the form of an engine; without a range the result is
/// empty, too.
/// @param edit name of the edit, for messages
/// Errors: UnknownSegment, InvalidField (bounds in the wrong order, a box outside the volume).
[[nodiscard]] Result<std::optional<EditableVoxels>> editableVoxels(
    const std::optional<EditableRange>& range, const Document& document, const char* edit);

/// Adds the editable range to a command of an engine. Errors: those of editableVoxels().
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

/// Whether there is a range, and it may leave any voxel out.
[[nodiscard]] inline bool isLimited(const std::optional<EditableRange>& range)
{
    return range && *range != EditableRange();
}

/// Whether the range contains positions in the patient, which have no meaning in another study.
[[nodiscard]] inline bool namesPlaces(const std::optional<EditableRange>& range)
{
    return range && range->box;
}

/// The codes of the values between two bounds, both included; modality units. A bound that is not
/// given does not limit the codes on its side.
/// Errors: InvalidField (bounds in the wrong order: the field "upper" below @p field).
[[nodiscard]] Result<CodeInterval> codesBetween(const QString& field,
    const std::optional<double>& lower, const std::optional<double>& upper,
    const VoxelEncoding& encoding);

} // namespace core
