// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/kinds/Edit.h"
#include "core/engine/EngineCommands.h"

namespace core {

/// All that is known of an edit before it is carried out; the next two, and those of
/// DocumentEdits.h, read from that.
[[nodiscard]] EditEffects effectsOf(const Edit& edit);

[[nodiscard]] EditTask taskOf(const Edit& edit);

/// Whether it can be begun, and told bit by bit until it ends: what is under the pen, a growth that
/// is watched, a preview. All others are carried out whole.
[[nodiscard]] bool canStandOpen(const Edit& edit);

/// The command in whole numbers by which the engine begins an edit; of strokes the path comes
/// later. A growth that goes on (ResumeGrowth) has to be named first (RecentGrowth.h).
/// Errors: those of the conversion; InvalidField where the edit is not the engine's.
[[nodiscard]] Result<EngineEdit> engineEditOf(const Edit& edit, const Document& document);

} // namespace core
