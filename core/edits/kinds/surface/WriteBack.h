// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"
#include "core/edits/kinds/parts/EditableRange.h"
#include "core/edits/kinds/surface/parts/SurfaceRules.h"

#include <optional>

namespace core {

/// Make the segment follow the surface to where it was moved since the two last agreed: a voxel
/// whose centre is inside now joins the segment, and one whose centre is outside now leaves it. All
/// other voxels stay as they are, whether or not the surface encloses them, so a surface that was
/// not moved changes none. core/session/surface/SurfaceWriteBack.h has the exact rule, also for the
/// rim of what was moved and for changes of the mask in the meantime.
///
/// If the editable range leaves voxels out, mask and surface do not agree afterwards, and the next
/// write-back covers again everything that the surface was moved over since they last agreed.
struct WriteBack {
    bool overwriteUnlocked = false;
    SurfaceRules rules{};
    std::optional<EditableRange> editable{}; ///< which voxels may change; none: any
};

/// Whether mask and surface agree afterwards.
[[nodiscard]] bool agreesAfterwards(const WriteBack& edit);

[[nodiscard]] Result<void> check(const WriteBack& edit, const Document& document);
Result<bool> apply(const WriteBack& edit, Document& document);
[[nodiscard]] EditEffects effects(const WriteBack& edit);
[[nodiscard]] RowTitle rowTitle(const WriteBack& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const WriteBack& edit, const DependencyFacts& row);

} // namespace core
