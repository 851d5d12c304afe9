// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

namespace core {

/// Show every piece at its true place and in its true size.
struct SendPiecesHome { };

[[nodiscard]] Result<void> check(const SendPiecesHome& edit, const Document& document);
Result<bool> apply(const SendPiecesHome& edit, Document& document);
[[nodiscard]] EditEffects effects(const SendPiecesHome& edit);
[[nodiscard]] RowTitle rowTitle(const SendPiecesHome& edit, const RowFacts& row);
[[nodiscard]] EditDependencies dependencies(const SendPiecesHome& edit, const DependencyFacts& row);

} // namespace core
