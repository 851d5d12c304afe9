// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

namespace core {

/// The segment follows the surface to where it was moved since they last agreed: where a voxel's
/// centre has come inside the segment gets it, where it has come outside the segment loses it. All
/// other voxels stay as they are, whether or not the surface encloses them: one that nobody moved
/// changes none. What exactly that means, also at the rim of what was moved and where the mask was
/// changed meanwhile, stands in core/session/surface/SurfaceWriteBack.h.
struct WriteBack {
    bool overwriteUnlocked = false;
};

[[nodiscard]] Result<void> check(const WriteBack& edit, const Document& document);
Result<bool> apply(const WriteBack& edit, Document& document);
[[nodiscard]] EditEffects effects(const WriteBack& edit);
[[nodiscard]] RowTitle rowTitle(const WriteBack& edit, const RowFacts& row);
[[nodiscard]] EditReach reach(const WriteBack& edit, const ReachFacts& row);

} // namespace core
