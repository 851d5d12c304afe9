// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/edits/kinds/parts/SparedSegments.h"
#include "core/sculpt/SparedLabels.h"

namespace core {

/// Adds the segments that are protected to what an edit spares, as it is carried out. From then on
/// the edit says by itself what it reads: neither replay nor a revision asks what is protected.
void spareProtected(SparedSegments& spared, const Document& document);

/// In an engine's form, in the label plane that the document has.
[[nodiscard]] SparedLabels sparedLabels(const SparedSegments& spared, const Document& document);

/// Errors: InvalidField, where a cut that restores is told to spare something.
/// @param edit its name, for errors
[[nodiscard]] Result<void> checkSpared(
    const SparedSegments& spared, bool restore, const QString& edit);

/// Errors: UnknownSegment, where one of those that a cut spares is not there.
[[nodiscard]] Result<void> checkSparedAreThere(
    const SparedSegments& spared, bool restore, const Document& document);

} // namespace core
