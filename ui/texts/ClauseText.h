// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"

#include <QString>

namespace ui {

/// Returns a clause and its arguments in the user's language. Plain texts, and clauses without a
/// translation, are returned as they are.
[[nodiscard]] QString clauseText(const core::Clause& clause);

} // namespace ui
