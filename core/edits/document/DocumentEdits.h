// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/edits/kinds/Edit.h"

#include <optional>

namespace core {

/// Whether an edit changes only the document and no voxel.
[[nodiscard]] bool changesDocumentOnly(const Edit& edit);

/// Whether an edit does nothing, not even in the document, if it changes no voxel.
[[nodiscard]] bool takesVoxelsOrNothing(const Edit& edit);

/// The list of the document that an edit changes; none if it changes only voxels.
[[nodiscard]] std::optional<DocumentChange::What> changedPart(const Edit& edit);

/// Makes the change of an edit to the document; an engine changes the voxels.
/// @return whether anything differs now Errors: UnknownSegment, SegmentLocked, InvalidField (no
/// label, layer or bookmark with that number, no number left, a view without a direction). Then
/// nothing was changed.
Result<bool> applyToDocument(const Edit& edit, Document& document);

/// Checks in advance what would be refused later: segments, seeds, bounds and views that do not fit
/// the document. Changes nothing. Errors: those of applyToDocument() and of engineEditOf()
/// (EditTask.h).
[[nodiscard]] Result<void> checkAgainst(const Document& document, const Edit& edit);

/// The document with which a session begins: one volume, one sculpt layer, one label plane, no
/// segment.
[[nodiscard]] Document initialDocument(Volume volume);

} // namespace core
