// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

#include <optional>

namespace core {

struct CoverLabel;

/// Carve all voxels of a segment into a layer; or all other voxels of the volume, except those of
/// segments that are protected.
struct SegmentToLayer {
    int segment = 0; ///< label
    int layer = 0; ///< id
    std::optional<bool> outside{}; ///< whether all others are carved; none: no
};

[[nodiscard]] Result<void> check(const SegmentToLayer& edit, const Document& document);
Result<bool> apply(const SegmentToLayer& edit, Document& document);
[[nodiscard]] EditEffects effects(const SegmentToLayer& edit);
[[nodiscard]] RowTitle rowTitle(const SegmentToLayer& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const SegmentToLayer& edit, const DependencyFacts& row);
[[nodiscard]] Result<EngineEdit> engineEdit(const SegmentToLayer& edit, const Document& document);

/// Errors: UnknownSegment, SegmentProtected (the segment is protected; or with `outside`, a
/// protected segment lies on another label plane, where it may have the same voxels).
[[nodiscard]] Result<CoverLabel> coverLabel(const SegmentToLayer& edit, const Document& document);

} // namespace core
