// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/sculpt/LayerWrites.h"

#include <vector>

namespace core {

struct ImportMask;

/// Where the segments of a mask go, in whatever volume.
struct ImportTargets {
    std::vector<LabelTarget> targets; ///< one a segment
    bool isNew = true; ///< they are made: one by one, or with "as" one
};
/// Errors: InvalidField (no voxels read, no room for so many segments), UnknownSegment,
/// SegmentLocked.
[[nodiscard]] Result<ImportTargets> importTargets(const ImportMask& edit, const Document& document);

} // namespace core
