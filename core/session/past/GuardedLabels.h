// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"
#include "core/engine/LabelGuard.h"

namespace core {

// Steps that put older cuts in place of what is carved now ("undo only here", a revised stroke)
// know nothing of segments that were protected since.

/// Segments that are protected from sculpting are carved no further than they are.
[[nodiscard]] LabelGuard carvingGuard(const Document& document);
/// And those that are locked keep their voxels.
[[nodiscard]] LabelGuard fullGuard(const Document& document);

/// The error of a guard, with the segment's name instead of its label; others as they are.
[[nodiscard]] Error withSegmentName(const Error& error, const Document& document);

} // namespace core
