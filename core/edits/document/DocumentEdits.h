// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/edits/kinds/Edit.h"

#include <optional>

namespace core {

/// Whether an edit changes the document only, and no voxel.
[[nodiscard]] bool changesDocumentOnly(const Edit& edit);

/// Whether an edit does nothing at all, in the document neither, where it changes no voxel.
[[nodiscard]] bool takesVoxelsOrNothing(const Edit& edit);

/// Which list of the document an edit changes; none if it changes voxels only.
[[nodiscard]] std::optional<DocumentChange::What> changedPart(const Edit& edit);

/// Carries out on the document what an edit changes there; its voxels are an engine's.
/// @return whether anything is different now
/// Errors: UnknownSegment, SegmentLocked, InvalidField (no label, layer or bookmark of that number,
/// none left, a view without a direction). Nothing is changed then.
Result<bool> applyToDocument(const Edit& edit, Document& document);

/// What would be refused later: segments, seeds, bounds and views that do not fit the document.
/// Changes nothing. Errors: those of applyToDocument() and of engineEditOf() (EditTask.h).
[[nodiscard]] Result<void> checkAgainst(const Document& document, const Edit& edit);

/// A document as a session begins with: one volume, one sculpt layer, one label plane, no segment.
[[nodiscard]] Document initialDocument(Volume volume);

} // namespace core
