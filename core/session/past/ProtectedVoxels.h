// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/engine/EngineCommands.h"

namespace core {

// Steps that put older cuts in place of what is carved now ("undo only here", a revised stroke)
// know nothing of segments that were protected since. They ask here, and are refused.

/// The labels to look at with these bricks of coverage; none where no segment is protected.
[[nodiscard]] std::vector<BrickKey> labelsOverCoverage(
    const Document& document, const std::vector<BrickImage>& coverage);

/// Whether protected segments are carved no further than they are.
/// @param now as it is, the labels that were asked for among it
/// @param then as it would be; bricks that are not there stay
/// Errors: SegmentProtected.
[[nodiscard]] Result<void> checkProtected(const Document& document,
    const std::vector<BrickChange>& now, const std::vector<BrickImage>& then);

} // namespace core
