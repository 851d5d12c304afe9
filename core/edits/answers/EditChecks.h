// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"
#include "core/document/Document.h"
#include "core/edits/answers/EditAnswers.h"

#include <optional>

namespace core {

struct EditableRange;

// Parts from which check() of several edits is made.

/// Refuses a layer that does not exist or is not visible, since a stroke into it would be lost
/// work. Errors: InvalidField.
/// @param field named in the error
[[nodiscard]] Result<void> checkLayer(const char* field, int id, const Document& document);

template <class T> [[nodiscard]] Result<void> discardValue(const Result<T>& result)
{
    if (!result)
        return tl::unexpected(result.error());
    return {};
}

/// Whether the change that an edit makes to a document is possible.
template <class E> [[nodiscard]] Result<void> checkApplied(const E& edit, const Document& document)
{
    Document copy = document;
    return discardValue(apply(edit, copy));
}

/// The segment with a label, if its voxels may change.
/// @param field name of the field in recipes, such as "paint.segment"
/// Errors: UnknownSegment (argument 0: the label, 1: the field), SegmentLocked.
[[nodiscard]] inline Result<const Segment*> unlockedSegment(
    const char* field, int label, const Document& document)
{
    const Segment* segment = document.segment(label);
    if (!segment)
        return failure(ErrorCode::UnknownSegment, QString::number(label),
            Clause::saying("in field '%1'", QLatin1String(field)));
    if (segment->locked)
        return failure(ErrorCode::SegmentLocked, segment->name);
    return segment;
}

/// Checks that the voxels of a segment may change, and that the editable range is valid.
/// @param edit name of the edit, for messages
/// Errors: those of the range first (editableVoxels()); UnknownSegment, SegmentLocked.
[[nodiscard]] Result<void> checkEditable(int label, const std::optional<EditableRange>& range,
    const Document& document, const char* edit);

} // namespace core
