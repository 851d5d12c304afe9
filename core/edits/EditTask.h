// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/edits/answers/EditEffects.h"
#include "core/edits/kinds/Edit.h"

#include <memory>

namespace core {

class OpenStroke;
struct EngineEdit;
struct OpenManner;

/// Everything that is known of an edit before it is carried out. The next two functions, and those
/// of DocumentEdits.h, take their answers from it.
[[nodiscard]] EditEffects effectsOf(const Edit& edit);

[[nodiscard]] EditTask taskOf(const Edit& edit);

/// Whether it can be begun and then continued until it ends: a stroke, a growth that is watched, a
/// preview. All other edits are carried out whole.
[[nodiscard]] bool canStandOpen(const Edit& edit);

/// The command, in integers, with which the engine begins an edit; the path of a stroke follows
/// later. A ResumeGrowth must first be replaced by the growth that it stands for (RecentGrowth.h).
/// Errors: those of the conversion; InvalidField if the engine does not carry out the edit.
[[nodiscard]] Result<EngineEdit> engineEditOf(const Edit& edit, const Document& document);

/// The object that takes further input for the edit while it stands open. It refers to the edit,
/// which must keep its kind. Null: the engine does not carry the edit out, or only whole.
[[nodiscard]] std::unique_ptr<OpenStroke> openStrokeOf(Edit& edit);

/// How an edit stands open that the engine does not carry out alone: an edit of the surface, or one
/// of a segment that is computed before it is applied. For all others OpenStroke answers this.
[[nodiscard]] OpenManner openMannerOf(const Edit& edit);

} // namespace core
