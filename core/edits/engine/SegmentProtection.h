// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/edits/kinds/parts/ProtectedSegments.h"
#include "core/sculpt/ProtectedLabels.h"

namespace core {

/// Called when a cut is carried out: adds the segments that are now protected from sculpting to the
/// list of segments that the cut leaves uncut. From then on the edit itself states what it reads,
/// so replay and revision need not know which segments are protected at that time.
void addProtected(ProtectedSegments& protectedSegments, const Document& document);

/// The list of an edit in the form of an engine, each segment in its label plane.
[[nodiscard]] ProtectedLabels protectedLabelsOf(
    const ProtectedSegments& protectedSegments, const Document& document);

/// Checks that a cut that restores has no such list.
/// @param edit name of the edit, for errors
/// Errors: InvalidField.
[[nodiscard]] Result<void> checkProtected(
    const ProtectedSegments& protectedSegments, bool restore, const QString& edit);

/// Checks the listed segments against a document. Errors: UnknownSegment if one does not exist.
[[nodiscard]] Result<void> checkProtectedAreThere(
    const ProtectedSegments& protectedSegments, bool restore, const Document& document);

} // namespace core
