// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/engine/LabelGuard.h"

namespace core {

// Which labels must not change when a step puts older cuts in place of present ones ("undo only
// here", a revised stroke): such a step knows nothing of segments that were protected since.

/// Prevents segments that are protected from sculpting from being carved further.
[[nodiscard]] LabelGuard carvingGuard(const Document& document);
/// The same, and prevents locked segments from gaining or losing voxels.
[[nodiscard]] LabelGuard fullGuard(const Document& document);

/// A guard's error with the segment's name in place of its label; other errors are returned
/// unchanged.
[[nodiscard]] Error withSegmentName(const Error& error, const Document& document);

} // namespace core
