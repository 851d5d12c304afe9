// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/words/Clause.h"

#include <QString>

namespace ui {

/// A clause with its arguments in the language of the user; a plain text, and a clause that has no
/// translation, as it is.
[[nodiscard]] QString clauseText(const core::Clause& clause);

} // namespace ui
