// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/edits/kinds/parts/ProtectedSegments.h"
#include "core/sculpt/ProtectedLabels.h"

namespace core {

/// Adds the segments that are protected from sculpting to those that an edit leaves uncut, when it
/// is carried out. From then on the edit itself states what it reads, so replay and revision need
/// not know what is protected.
void addProtected(ProtectedSegments& protectedSegments, const Document& document);

/// The same list in the form of an engine, for the label plane of the document.
[[nodiscard]] ProtectedLabels protectedLabelsIn(
    const ProtectedSegments& protectedSegments, const Document& document);

/// Errors: InvalidField if a cut that restores has such a list.
/// @param edit its name, for errors
[[nodiscard]] Result<void> checkProtected(
    const ProtectedSegments& protectedSegments, bool restore, const QString& edit);

/// Errors: UnknownSegment if a listed segment does not exist, InvalidField if it lies on a further
/// label plane, which no cut reads.
[[nodiscard]] Result<void> checkProtectedAreThere(
    const ProtectedSegments& protectedSegments, bool restore, const Document& document);

} // namespace core
